'use strict';
// As much of VS Code as the extension asks for, and a client that notes what it was made with.

const Module = require('node:module');

class Emitter {
    /** @type {Array<(event: any) => any>} */
    listeners = [];

    /** @param {(event: any) => any} listener */
    event = (listener) => {
        this.listeners.push(listener);
        return { dispose: () => (this.listeners = this.listeners.filter((other) => other !== listener)) };
    };

    /** @param {any} [event] */
    fire = (event) => Promise.all(this.listeners.map((listener) => listener(event)));
}

/** An editor in which nothing is open yet. */
function fake() {
    const events = { editor: new Emitter(), text: new Emitter(), saved: new Emitter(), theme: new Emitter(), settings: new Emitter() };
    /** @type {any} */
    const state = { commands: {}, settings: {}, panels: [], errors: [], infos: [], clients: [], executed: [], answer: undefined, events };
    const Disposable = { from: (/** @type {any[]} */ ...all) => ({ dispose: () => all.forEach((one) => one.dispose()) }) };
    const vscode = {
        Disposable,
        ColorThemeKind: { Light: 1, Dark: 2, HighContrast: 3, HighContrastLight: 4 },
        ViewColumn: { Beside: -2 },
        commands: {
            registerCommand: (/** @type {string} */ name, /** @type {any} */ act) => {
                state.commands[name] = act;
                return { dispose: () => delete state.commands[name] };
            },
            executeCommand: async (/** @type {any[]} */ ...words) => void state.executed.push(words),
        },
        window: {
            activeTextEditor: undefined,
            activeColorTheme: { kind: 1 },
            onDidChangeActiveTextEditor: events.editor.event,
            onDidChangeActiveColorTheme: events.theme.event,
            showErrorMessage: async (/** @type {string} */ text) => (state.errors.push(text), state.answer),
            showInformationMessage: async (/** @type {string} */ text) => void state.infos.push(text),
            showInputBox: async () => state.answer,
            createWebviewPanel: (/** @type {any[]} */ ...made) => {
                const gone = new Emitter();
                const panel = { made, title: made[1], webview: { html: '' }, onDidDispose: gone.event, dispose: gone.fire };
                state.panels.push(panel);
                return panel;
            },
        },
        workspace: {
            onDidChangeTextDocument: events.text.event,
            onDidSaveTextDocument: events.saved.event,
            onDidChangeConfiguration: events.settings.event,
            createFileSystemWatcher: (/** @type {string} */ glob) => ({ glob, dispose: () => {} }),
            getConfiguration: () => ({
                get: (/** @type {string} */ name, /** @type {any} */ otherwise) => state.settings[name] ?? otherwise,
            }),
        },
    };
    class LanguageClient {
        /** @param {any[]} made */
        constructor(...made) {
            this.made = made;
            this.state = 'made';
            state.clients.push(this);
        }
        async start() {
            this.state = 'started';
        }
        async dispose() {
            this.state = 'gone';
        }
    }
    return { vscode, state, client: { LanguageClient, TransportKind: { stdio: 0 } } };
}

/**
 * The extension as that editor loads it.
 * @param {ReturnType<typeof fake>} editor
 * @param {string} [file]
 */
function extensionIn(editor, file = '../src/extension.js') {
    const loader = /** @type {any} */ (Module);
    const load = loader._load;
    loader._load = (/** @type {string} */ name, /** @type {any[]} */ ...rest) => {
        if (name === 'vscode') return editor.vscode;
        if (name === 'vscode-languageclient/node') return editor.client;
        return load(name, ...rest);
    };
    try {
        for (const name of Object.keys(require.cache)) if (/vscode\/(src|dist)\//.test(name)) delete require.cache[name];
        return require(file);
    } finally {
        loader._load = load;
    }
}

module.exports = { extensionIn, fake };
