'use strict';
// The page that shows pictures: no scripts, nothing from outside, and styles only of its own.

const { randomBytes } = require('node:crypto');

/** What stands in SVG for a dark page; an editor's theme need not be that of the system. */
const DARK = '@media(prefers-color-scheme:dark)';

/** @param {string} text */
const escape = (text) =>
    text.replace(/[&<>"]/g, (mark) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[mark] ?? mark);

/**
 * @param {string} svg
 * @param {boolean} isDark
 */
function image(svg, isDark) {
    const themed = svg.replaceAll(DARK, isDark ? '@media all' : '@media not all');
    const title = /<title[^>]*>([^<]*)</.exec(svg)?.[1] ?? '';
    // What the title escapes is escaped already.
    return `<img alt="${title.replaceAll('"', '&quot;')}" src="data:image/svg+xml;base64,${Buffer.from(themed).toString('base64')}">`;
}

/**
 * @param {{ title: string, pictures: string[], fault: string, isDark: boolean }} shown
 * @returns {string} HTML
 */
function page({ title, pictures, fault, isDark }) {
    const nonce = randomBytes(16).toString('base64');
    const notice = fault ? `<pre role="status">${escape(fault)}</pre>` : '';
    return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'nonce-${nonce}'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escape(title)}</title>
<style nonce="${nonce}">
body { margin: 0; padding: 12px; color: var(--vscode-editor-foreground); background: var(--vscode-editor-background) }
img { display: block; max-width: 100%; height: auto; margin: 0 auto 12px; border-radius: 4px }
pre {
    margin: 0 0 12px; padding: 8px 12px; overflow-x: auto; white-space: pre-wrap;
    font-family: var(--vscode-editor-font-family, monospace); font-size: var(--vscode-editor-font-size, 12px);
    background: var(--vscode-textBlockQuote-background); border-left: 3px solid var(--vscode-editorWarning-foreground)
}
</style>
</head>
<body>
${notice}${pictures.map((svg) => image(svg, isDark)).join('\n')}
</body>
</html>
`;
}

module.exports = { page };
