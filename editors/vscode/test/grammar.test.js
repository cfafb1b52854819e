'use strict';
// The colors of the TextMate grammar, held against the grammar of the compiler and against what the language server
// knows of each word.

const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const { before, describe, test } = require('node:test');
const { ask, stop, server } = require('./server.js');
const { filesBelow, load, read, root, tokens } = require('./tokens.js');

/** @type {import('vscode-textmate').IGrammar} */
let grammar;
before(async () => {
    grammar = await load();
});

const ours = filesBelow('stdlib', 'examples');
const files = [...ours, ...filesBelow('tests/corpus')];

/** @param {import('./tokens.js').Token} token */
const isKeyword = ({ scope }) => /^keyword\.(other|operator\.word)\.lmsl$/.test(scope);

/** The words that the compiler takes for keywords, by file of the corpus: `3:1 arbiter`. */
function keywordsOfTheCompiler() {
    const snapshot = fs.readFileSync(path.join(root, 'editors', 'keywords.snap'), 'utf8').split('---\n').slice(2).join();
    /** @type {Map<string, string[]>} */
    const keywords = new Map();
    for (const line of snapshot.trim().split('\n')) {
        if (/^\d/.test(line)) [...keywords.values()].at(-1)?.push(line);
        else keywords.set(line, []);
    }
    return keywords;
}

test('keywords are those of the compiler, each where it is one', () => {
    const told = keywordsOfTheCompiler();
    assert.ok(told.size >= 8);
    for (const [file, expected] of told) {
        const found = tokens(grammar, read(`tests/corpus/syntax/pass/${file}`)).filter(isKeyword);
        const words = found.map(({ line, start, text }) => `${line + 1}:${start + 1} ${text}`);
        // `points` is colored like the other shapes.
        assert.deepEqual(words, expected.filter((word) => !word.endsWith(' points')), file);
    }
});

test('every token has a color', () => {
    for (const file of files.filter((file) => !file.includes('/syntax/fail/'))) {
        for (const { line, start, text, scope } of tokens(grammar, read(file))) {
            assert.notEqual(scope, 'source.lmsl', `${file}:${line + 1}:${start + 1}: ${text}`);
        }
    }
});

test('comments are comments, and nothing else is', () => {
    for (const file of files) {
        for (const { line, start, text, scope } of tokens(grammar, read(file))) {
            const place = `${file}:${line + 1}:${start + 1}: ${text}`;
            const isComment = /comment/.test(scope);
            const before = read(file).split(/\r\n|\r|\n/)[line].slice(0, start + 2);
            assert.equal(isComment, before.includes('//'), place);
        }
    }
});

test('shapes have names, and terms may have the names of hedges', () => {
    const scopes = (/** @type {string} */ text) => tokens(grammar, text).map(({ text, scope }) => `${text} ${scope}`);
    assert.deepEqual(scopes('variable v: m { very = not very ramp(1 m, 2) }').slice(4, 11), [
        '{ punctuation.section.block.begin.lmsl',
        'very variable.other.enummember.lmsl',
        '= keyword.operator.assignment.lmsl',
        'not keyword.operator.word.lmsl',
        'very keyword.other.lmsl',
        'ramp support.function.lmsl',
        '( punctuation.section.parens.begin.lmsl',
    ]);
});

test('a file that is half written spoils no declaration behind it', () => {
    const broken = ['variable v: m {\n', 'network n(a: b) {\n event e { contributor (x\n', 'behavior b {\n mode m {\n'];
    for (const text of broken) {
        const found = tokens(grammar, `${text}\n}\nvariable w: m in 0 .. 1 { low = ramp(1, 0) }\n`).slice(-18);
        assert.deepEqual(
            found.slice(0, 7).map(({ text, scope }) => `${text} ${scope}`),
            [
                'variable keyword.other.lmsl',
                'w entity.name.type.lmsl',
                ': punctuation.separator.colon.lmsl',
                'm keyword.other.unit.lmsl',
                'in keyword.other.lmsl',
                '0 constant.numeric.lmsl',
                '.. keyword.operator.range.lmsl',
            ],
            text,
        );
    }
});

describe('the language server', { skip: server ? false : 'lmslc is not built' }, () => {
    test('agrees in every file of the library and the examples', async () => {
        const legend = (await ask('initialize', { capabilities: {}, processId: null, rootUri: null })).capabilities
            .semanticTokensProvider.legend.tokenTypes;
        /** @type {Record<string, RegExp>} */
        const scopes = {
            comment: /comment/,
            keyword: /^keyword\.(other|operator\.word)\.lmsl$/,
            number: /^(constant\.numeric|keyword\.other\.unit)/,
            function: /^support\.function/,
            type: /^(entity\.name\.type|variable)/,
            enumMember: /^variable\.other\.(enummember|readwrite)/,
            namespace: /^(entity\.name\.namespace|variable\.other)/,
            parameter: /^variable/,
            event: /^variable\.other/,
            property: /^(variable\.other|entity\.name\.type)/,
            class: /^(entity\.name\.class|variable\.other\.readwrite|entity\.name\.namespace)/,
            method: /^entity\.name\.function/,
            variable: /^variable\.other\.readwrite/,
        };
        let count = 0;
        try {
            for (const file of ours) {
                const text = read(file);
                const uri = `file://${path.join(root, file)}`;
                const { data } = await ask('textDocument/semanticTokens/full', { textDocument: { uri } }, { uri, text });
                const own = tokens(grammar, text);
                let [line, start] = [0, 0];
                for (let at = 0; at < data.length; at += 5) {
                    start = data[at] === 0 ? start + data[at + 1] : data[at + 1];
                    line += data[at];
                    const kind = legend[data[at + 3]];
                    const token = own.find((token) => token.line === line && token.start <= start && start < token.end);
                    assert.ok(token, `${file}:${line + 1}:${start + 1}`);
                    assert.match(token.scope, scopes[kind], `${file}:${line + 1}:${start + 1}: ${token.text}, ${kind}`);
                    count += 1;
                }
            }
        } finally {
            await stop();
        }
        assert.ok(count > 1500, `${count}`);
    });
});
