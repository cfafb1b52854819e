'use strict';
// The tokens of a text as VS Code's own engine finds them with the grammar.

const fs = require('node:fs');
const path = require('node:path');
const oniguruma = require('vscode-oniguruma');
const textmate = require('vscode-textmate');

const extension = path.join(__dirname, '..');
const root = path.join(extension, '..', '..');

/** @returns {Promise<import('vscode-textmate').IGrammar>} */
async function load() {
    const wasm = fs.readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm'));
    await oniguruma.loadWASM(wasm);
    const file = path.join(extension, 'syntaxes', 'lmsl.tmLanguage.json');
    const registry = new textmate.Registry({
        onigLib: Promise.resolve(oniguruma),
        loadGrammar: async () => textmate.parseRawGrammar(fs.readFileSync(file, 'utf8'), file),
    });
    const grammar = await registry.loadGrammar('source.lmsl');
    if (!grammar) throw new Error('no grammar');
    return grammar;
}

/**
 * @typedef {{ line: number, start: number, end: number, text: string, scope: string }} Token
 * Lines and columns count from 0, columns in UTF-16 units; the scope is the innermost one.
 */

/**
 * @param {import('vscode-textmate').IGrammar} grammar
 * @param {string} text
 * @returns {Token[]} all but space
 */
function tokens(grammar, text) {
    let stack = textmate.INITIAL;
    return text.split(/\r\n|\r|\n/).flatMap((content, line) => {
        const result = grammar.tokenizeLine(content, stack);
        stack = result.ruleStack;
        return result.tokens.flatMap(({ startIndex, endIndex, scopes }) => {
            const raw = content.slice(startIndex, endIndex);
            const text = raw.replace(/^\uFEFF/, '').trim();
            const start = startIndex + raw.indexOf(text);
            const scope = scopes[scopes.length - 1];
            return text ? [{ line, start, end: start + text.length, text, scope }] : [];
        });
    });
}

/**
 * The files of the language below folders of the repository, as paths from its root.
 * @param {string[]} folders
 */
function filesBelow(...folders) {
    return folders.flatMap((folder) =>
        fs
            .readdirSync(path.join(root, folder), { recursive: true, encoding: 'utf8' })
            .filter((file) => /\.(msd|fsfn)$/.test(file))
            .map((file) => path.posix.join(folder, ...file.split(path.sep)))
            .sort(),
    );
}

/** @param {string} file */
const read = (file) => fs.readFileSync(path.join(root, file), 'utf8');

module.exports = { extension, filesBelow, load, read, root, tokens };
