'use strict';
// What the extension does in an editor: its client, its preview, and what it says when something is missing.

const assert = require('node:assert/strict');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { after, beforeEach, describe, test } = require('node:test');
const { extensionIn, fake } = require('./fake.js');
const { server } = require('./server.js');
const { extension, read, root } = require('./tokens.js');

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'lmsl-test-'));
after(() => fs.rmSync(folder, { recursive: true }));

/** @type {ReturnType<typeof fake>} */
let editor;
/** @type {any} */
let activated;

/** @param {Record<string, string>} settings */
async function start(settings) {
    editor = fake();
    editor.state.settings = settings;
    activated = extensionIn(editor);
    await activated.activate({ subscriptions: [] });
}

/**
 * A document in the active editor.
 * @param {string} fileName
 * @param {string} [text] as it stands in the editor, else as it is on disk
 */
function open(fileName, text = fs.readFileSync(fileName, 'utf8')) {
    const document = { fileName, languageId: 'lmsl', uri: { scheme: 'file' }, text, getText: () => document.text };
    editor.vscode.window.activeTextEditor = /** @type {any} */ ({ document });
    return document;
}

/** The pictures of the preview, as SVG. */
function pictures() {
    const found = editor.state.panels[0].webview.html.matchAll(/src="data:image\/svg\+xml;base64,([^"]*)"/g);
    return [...found].map(([, data]) => Buffer.from(data, 'base64').toString());
}

/** @param {() => unknown} holds */
async function until(holds) {
    for (let tries = 0; !holds(); tries += 1) {
        assert.ok(tries < 200, `waited in vain: ${holds}`);
        await new Promise((resolve) => setTimeout(resolve, 50));
    }
}

test('without lmslc the user is told what to do', async () => {
    await start({ 'lmslc.path': '/nowhere/lmslc' });
    assert.equal(editor.state.clients.length, 0);
    assert.match(editor.state.errors[0], /^The compiler lmslc was not found as `\/nowhere\/lmslc`\. Install it/);
    await editor.state.commands['lmsl.showDiagram']();
    assert.match(editor.state.infos[0], /Open a \.msd or \.fsfn file/);
    open(path.join(root, 'examples/j5/preliminary.msd'));
    await editor.state.commands['lmsl.showDiagram']();
    assert.match(editor.state.panels[0].webview.html, /`\/nowhere\/lmslc` could not be started \(.*ENOENT\)\. Say in the setting/);
});

test('the settings are one click away', async () => {
    await start({ 'lmslc.path': '/nowhere/lmslc' });
    editor.state.answer = 'Open Settings';
    await editor.state.commands['lmsl.restartServer']();
    await until(() => editor.state.executed.length > 0);
    assert.deepEqual(editor.state.executed[0], ['workbench.action.openSettings', 'lmsl.lmslc.path']);
});

test('a program that is not lmslc is not taken for it', async () => {
    await start({ 'lmslc.path': process.execPath });
    assert.equal(editor.state.clients.length, 0);
    assert.match(editor.state.errors[0], /is no lmslc with a language server/);
});

describe('with lmslc', { skip: server ? false : 'lmslc is not built' }, () => {
    beforeEach(() => start({ 'lmslc.path': String(server) }));

    test('the client speaks to `lmslc lsp`, and is let go of in the end', async () => {
        const [client] = editor.state.clients;
        const [, , { command, args }, { documentSelector, synchronize }] = client.made;
        assert.deepEqual([command, args, client.state], [server, ['lsp'], 'started']);
        assert.ok(documentSelector.every((/** @type {any} */ of) => of.language === 'lmsl'));
        assert.match(synchronize.fileEvents.glob, /msd.*fsfn.*lmsl\.toml/);
        await editor.state.events.settings.fire({ affectsConfiguration: () => true });
        assert.deepEqual(editor.state.clients.map((/** @type {any} */ one) => one.state), ['gone', 'started']);
        await activated.deactivate();
        assert.equal(editor.state.clients[1].state, 'gone');
    });

    test('the preview follows the text, the file and the theme', async () => {
        const document = open(path.join(root, 'examples/j5/preliminary.msd'));
        await editor.state.commands['lmsl.showDiagram']();
        const [panel] = editor.state.panels;
        assert.equal(panel.title, 'Diagram preliminary.msd');
        assert.equal(panel.made[3].enableScripts, false);
        assert.match(panel.webview.html, /content="default-src 'none'; img-src data:; style-src 'nonce-[^']+'"/);
        assert.doesNotMatch(panel.webview.html, /<script|https?:/);
        assert.match(pictures()[0], />watch</);

        document.text = document.text.replaceAll('ahead {', 'far_ahead {').replaceAll('-> ahead', '-> far_ahead');
        await editor.state.events.text.fire({ document });
        await until(() => pictures()[0].includes('>far_ahead<'));

        assert.match(pictures()[0], /@media not all\{/);
        editor.vscode.window.activeColorTheme.kind = 2;
        await editor.state.events.theme.fire();
        assert.match(pictures()[0], /@media all\{/);

        const network = open(path.join(root, 'stdlib/networks/obstacle_id.fsfn'));
        await editor.state.events.editor.fire({ document: network });
        await until(() => pictures()[0]?.includes('Network obstacle_id'));
        await panel.dispose();
        await editor.state.commands['lmsl.showDiagram']();
        assert.equal(editor.state.panels.length, 2);
    });

    test('several behaviors are several pictures', async () => {
        const behavior = (/** @type {string} */ name) => `behavior ${name} on j5 { entry m final mode m { halt() } }\n`;
        open(path.join(folder, 'two.msd'), `import std.robots.j5\n${behavior('a')}${behavior('b')}`);
        await editor.state.commands['lmsl.showDiagram']();
        assert.deepEqual(pictures().map((svg) => /diagram (\w+)</.exec(svg)?.[1]), ['a', 'b']);
    });

    test('what is broken is said, and the last picture stays', async () => {
        const document = open(path.join(root, 'examples/j5/preliminary.msd'));
        await editor.state.commands['lmsl.showDiagram']();
        document.text = document.text.replace('-> ahead', '-> aheda');
        await editor.state.events.text.fire({ document });
        await until(() => editor.state.panels[0].webview.html.includes('There are errors.'));
        document.text = 'scenario <b> {';
        await editor.state.events.text.fire({ document });
        await until(() => editor.state.panels[0].webview.html.includes('`preliminary.msd` holds no behavior'));
        assert.equal(pictures().length, 1);
        assert.doesNotMatch(editor.state.panels[0].webview.html, /<b>/);
    });

    test('failed sensors are drawn, and unknown ones answered with those there are', async () => {
        open(path.join(root, 'stdlib/behaviors/obstacle_manipulation.msd'));
        editor.state.answer = 'contact_force';
        await editor.state.commands['lmsl.failSensors']();
        assert.match(pictures()[0], /class="[^"]*gone/);
        editor.state.answer = 'contact';
        await editor.state.commands['lmsl.failSensors']();
        assert.match(editor.state.panels[0].webview.html, /has no sensor `contact`[^<]*contact_force/);
    });
});

test('what the manifest promises is there', () => {
    const manifest = JSON.parse(read('editors/vscode/package.json'));
    const { commands, grammars, languages, snippets, menus, keybindings } = manifest.contributes;
    const files = [manifest.icon, ...[...grammars, ...snippets].map(({ path }) => path), languages[0].configuration];
    for (const file of [...files, ...Object.values(languages[0].icon)]) {
        assert.ok(fs.existsSync(path.join(extension, file)), file);
    }
    const registered = Object.keys(editor.state.commands).sort();
    assert.deepEqual(commands.map((/** @type {any} */ { command }) => command).sort(), registered);
    const used = [...Object.values(menus).flat(), ...keybindings].map(({ command }) => command);
    assert.ok(used.every((command) => registered.includes(command)));
});
