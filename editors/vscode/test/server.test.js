'use strict';
// The language server as the protocol pieces of VS Code's client see it.

const assert = require('node:assert/strict');
const { test } = require('node:test');
const { ask, listen, server, start, stop } = require('./server.js');

const uri = 'file:///desk/wander.msd';
const text = `import std.robots.j5

behavior wander on j5 {
  entry ahead
    mode ahead {
        drive(26 cm/s)
        1: after 2 s -> stopp
    }
    final mode stop { halt() }
}
`;

test('a mistake is found, mended, renamed around and laid out', { skip: !server && 'lmslc is not built' }, async () => {
    /** @type {(told: any) => void} */
    let tell = () => {};
    const told = () => new Promise((resolve) => (tell = resolve));
    await ask('initialize', { capabilities: {}, processId: process.pid, rootUri: null });
    listen('textDocument/publishDiagnostics', (parameters) => tell(parameters));

    const first = told();
    const outline = await ask('textDocument/documentSymbol', { textDocument: { uri } }, { uri, text });
    assert.equal(outline[0].name, 'wander');
    const { diagnostics } = await first;
    assert.deepEqual(diagnostics.map((/** @type {any} */ { code, range }) => [code, range.start.line]), [['LM0201', 6]]);

    const second = told();
    const range = { start: { line: 6, character: 24 }, end: { line: 6, character: 29 } };
    const change = { textDocument: { uri, version: 2 }, contentChanges: [{ range, text: 'stop' }] };
    await start().connection.sendNotification('textDocument/didChange', change);
    assert.deepEqual((await second).diagnostics, []);

    const where = { textDocument: { uri }, position: { line: 6, character: 25 } };
    const { changes } = await ask('textDocument/rename', { ...where, newName: 'rest' });
    assert.deepEqual(changes[uri].map((/** @type {any} */ edit) => edit.range.start.line), [6, 8]);
    const options = { tabSize: 4, insertSpaces: true };
    const edits = await ask('textDocument/formatting', { textDocument: { uri }, options });
    assert.ok(edits.some((/** @type {any} */ edit) => edit.newText.includes('    entry ahead')), JSON.stringify(edits));
    assert.equal(await stop(), 0);
});
