'use strict';
// The language server, spoken to by the protocol pieces of VS Code's own client.

const fs = require('node:fs');
const path = require('node:path');
const { spawn } = require('node:child_process');
const rpc = require('vscode-jsonrpc/node');
const { root } = require('./tokens.js');

/** The compiler: the one that `LMSLC` names, else the one that was built here last. */
const server = process.env.LMSLC ? path.resolve(root, process.env.LMSLC) : builtLast();

function builtLast() {
    const built = ['release', 'debug'].map((profile) => path.join(root, 'target', profile, 'lmslc')).filter(fs.existsSync);
    const time = (/** @type {string} */ file) => fs.statSync(file).mtimeMs;
    return built.sort((one, other) => time(other) - time(one)).at(0);
}

/** @type {{ connection: rpc.MessageConnection, child: import('node:child_process').ChildProcess } | undefined} */
let running;

/** Starts the server where it does not run yet. */
function start() {
    if (running) return running;
    if (!server) throw new Error('lmslc is not built');
    const child = spawn(server, ['lsp'], { stdio: ['pipe', 'pipe', 'inherit'] });
    const connection = rpc.createMessageConnection(
        new rpc.StreamMessageReader(/** @type {import('node:stream').Readable} */ (child.stdout)),
        new rpc.StreamMessageWriter(/** @type {import('node:stream').Writable} */ (child.stdin)),
    );
    connection.listen();
    running = { connection, child };
    return running;
}

/**
 * The answer to a request, after a document was opened where one is given.
 * @param {string} method
 * @param {unknown} parameters
 * @param {{ uri: string, text: string }} [document]
 * @returns {Promise<any>}
 */
async function ask(method, parameters, document) {
    const { connection } = start();
    if (document) {
        const textDocument = { ...document, languageId: 'lmsl', version: 1 };
        await connection.sendNotification('textDocument/didOpen', { textDocument });
    }
    const answer = await connection.sendRequest(method, parameters);
    if (method === 'initialize') await connection.sendNotification('initialized', {});
    return answer;
}

/** Takes leave as the protocol wants it; answers the exit code. */
async function stop() {
    if (!running) return undefined;
    const { connection, child } = running;
    running = undefined;
    const ended = new Promise((resolve) => child.once('exit', resolve));
    await connection.sendRequest('shutdown');
    await connection.sendNotification('exit');
    const code = await ended;
    connection.dispose();
    return code;
}

/**
 * Hears what the server tells by itself.
 * @param {string} method
 * @param {(parameters: any) => void} listener
 */
const listen = (method, listener) => start().connection.onNotification(method, listener);

module.exports = { ask, listen, server, start, stop };
