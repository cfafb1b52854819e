'use strict';
// The diagram beside the editor: of the file that is looked at, as it changes.

const path = require('node:path');
const vscode = require('vscode');
const { NotFound } = require('./compiler.js');
const { page } = require('./page.js');
const { draw, isNetworks } = require('./pictures.js');

/** How long a text must stand still before it is drawn, in milliseconds. */
const PAUSE = 300;

/** @param {vscode.TextDocument | undefined} document */
const isOurs = (document) => document?.languageId === 'lmsl' && document.uri.scheme === 'file';

function isDark() {
    const { Dark, HighContrast } = vscode.ColorThemeKind;
    return [Dark, HighContrast].includes(vscode.window.activeColorTheme.kind);
}

class Preview {
    /** @param {() => string} program where lmslc is */
    constructor(program) {
        this.program = program;
        /** @type {vscode.WebviewPanel | undefined} */
        this.panel = undefined;
        /** @type {vscode.TextDocument | undefined} */
        this.document = undefined;
        /** Sensors that have failed, by file. @type {Map<string, string[]>} */
        this.failed = new Map();
        /** @type {import('./pictures.js').Drawing} */
        this.drawing = { pictures: [], fault: '' };
        /** @type {NodeJS.Timeout | undefined} */
        this.timer = undefined;
        this.turn = 0;
    }

    /** @returns {vscode.Disposable} what it listens to, to be let go of in the end */
    listen() {
        return vscode.Disposable.from(
            vscode.window.onDidChangeActiveTextEditor((editor) => {
                if (this.panel && isOurs(editor?.document)) this.show(editor?.document);
            }),
            vscode.workspace.onDidChangeTextDocument(({ document }) => {
                if (this.panel && document === this.document && !isNetworks(document.fileName)) this.drawSoon();
            }),
            // Another file may be imported here.
            vscode.workspace.onDidSaveTextDocument((document) => {
                if (this.panel && isOurs(document)) this.drawSoon();
            }),
            vscode.window.onDidChangeActiveColorTheme(() => this.render()),
            { dispose: () => this.panel?.dispose() },
        );
    }

    /**
     * Opens the preview where there is none, and turns it to a file.
     * @param {vscode.TextDocument | undefined} document
     */
    show(document = vscode.window.activeTextEditor?.document) {
        if (!document || !isOurs(document)) {
            vscode.window.showInformationMessage('Open a .msd or .fsfn file from the disk to see its diagram.');
            return undefined;
        }
        if (!this.panel) {
            const column = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
            const options = { enableScripts: false, localResourceRoots: [], enableFindWidget: false };
            this.panel = vscode.window.createWebviewPanel('lmsl.diagram', 'Diagram', column, options);
            this.panel.onDidDispose(() => {
                clearTimeout(this.timer);
                this.panel = undefined;
                this.document = undefined;
            });
        }
        if (document !== this.document) this.drawing = { pictures: [], fault: '' };
        this.document = document;
        this.panel.title = `Diagram ${path.basename(document.fileName)}`;
        return this.draw();
    }

    /** Asks which sensors have failed, and shows what that takes away. */
    async fail() {
        const document = vscode.window.activeTextEditor?.document;
        if (!document) return;
        const before = this.failed.get(document.fileName) ?? [];
        const answer = await vscode.window.showInputBox({
            title: 'Which sensors have failed?',
            prompt: 'Names with commas between them, or nothing. What never happens any more is drawn pale.',
            placeHolder: 'contact_force, left_wheel_acceleration',
            value: before.join(', '),
        });
        if (answer === undefined) return;
        this.failed.set(document.fileName, answer.split(/[\s,]+/).filter(Boolean));
        await this.show(document);
    }

    drawSoon() {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.draw(), PAUSE);
    }

    /** Draws the file anew. What was asked for later wins, whichever is ready first. */
    async draw() {
        const document = this.document;
        if (!document) return;
        this.turn += 1;
        const turn = this.turn;
        const file = document.fileName;
        const source = { path: file, text: document.getText(), failed: this.failed.get(file) ?? [] };
        const drawing = await draw(this.program(), source).catch((error) => ({ pictures: [], fault: said(error) }));
        if (turn !== this.turn || document !== this.document) return;
        // While a line is half written the last picture is better than none.
        const pictures = drawing.pictures.length > 0 ? drawing.pictures : this.drawing.pictures;
        this.drawing = { pictures, fault: drawing.fault };
        this.render();
    }

    render() {
        if (!this.panel) return;
        this.panel.webview.html = page({ title: this.panel.title, ...this.drawing, isDark: isDark() });
    }
}

/** @param {unknown} error */
function said(error) {
    if (error instanceof NotFound) return `${error.message}. Say in the setting lmsl.lmslc.path where lmslc is.`;
    return error instanceof Error ? error.message : String(error);
}

module.exports = { Preview };
