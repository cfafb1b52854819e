'use strict';
// What VS Code starts: the language server's client, and the commands.

const vscode = require('vscode');
const { LanguageClient, TransportKind } = require('vscode-languageclient/node');
const { NotFound, run } = require('./compiler.js');
const { Preview } = require('./preview.js');

/** @type {LanguageClient | undefined} */
let client;

/** Where lmslc is, as the user has said. */
function program() {
    return vscode.workspace.getConfiguration('lmsl').get('lmslc.path', 'lmslc').trim() || 'lmslc';
}

/** @param {vscode.ExtensionContext} context */
async function activate(context) {
    const preview = new Preview(program);
    context.subscriptions.push(
        preview.listen(),
        vscode.commands.registerCommand('lmsl.showDiagram', () => preview.show()),
        vscode.commands.registerCommand('lmsl.failSensors', () => preview.fail()),
        vscode.commands.registerCommand('lmsl.restartServer', restart),
        vscode.workspace.onDidChangeConfiguration((change) =>
            change.affectsConfiguration('lmsl.lmslc.path') ? restart() : undefined,
        ),
    );
    await start();
}

async function deactivate() {
    await stop();
}

async function restart() {
    await stop();
    await start();
}

async function stop() {
    const running = client;
    client = undefined;
    await running?.dispose();
}

/** Starts the language server, or says what to do where there is none. */
async function start() {
    const command = program();
    try {
        const { code, told } = await run(command, ['lsp', '--help']);
        if (code !== 0) throw new Error(`\`${command}\` is no lmslc with a language server: ${told.trim()}`);
        const server = { command, args: ['lsp'], transport: TransportKind.stdio };
        const options = {
            documentSelector: [{ scheme: 'file', language: 'lmsl' }, { scheme: 'untitled', language: 'lmsl' }],
            synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher('**/{*.msd,*.fsfn,lmsl.toml}') },
        };
        client = new LanguageClient('lmsl', 'LMSL', server, options);
        await client.start();
    } catch (error) {
        // Not waited for: nobody may be there to answer.
        complain(error).catch(() => {});
    }
}

/** @param {unknown} error */
async function complain(error) {
    const settings = 'Open Settings';
    const message =
        error instanceof NotFound
            ? `The compiler lmslc was not found as \`${error.program}\`. Install it with \`cargo install --path .\` from ` +
              'its repository, or say where it is. Until then there are colors and snippets only.'
            : `The language server did not start: ${error instanceof Error ? error.message : error}`;
    if ((await vscode.window.showErrorMessage(message, settings)) === settings) {
        await vscode.commands.executeCommand('workbench.action.openSettings', 'lmsl.lmslc.path');
    }
}

module.exports = { activate, deactivate };
