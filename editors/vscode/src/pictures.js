'use strict';
// The pictures of a file, drawn by lmslc.

const fs = require('node:fs/promises');
const os = require('node:os');
const path = require('node:path');
const { run } = require('./compiler.js');

/**
 * @typedef {object} Drawing
 * @property {string[]} pictures SVG, one for each behavior or network, by name
 * @property {string} fault why there is none, or why it may be incomplete; empty where all is well
 *
 * @typedef {object} Source
 * @property {string} path
 * @property {string} text as it stands in the editor
 * @property {string[]} failed sensors that have failed
 */

/** @param {string} file */
const isNetworks = (file) => file.endsWith('.fsfn');

/**
 * Draws the behaviors of a text, or the networks of a file as it was saved: standard input is a text of behaviors.
 *
 * @param {string} program lmslc
 * @param {Source} source
 * @returns {Promise<Drawing>}
 * @throws {import('./compiler.js').NotFound}
 */
async function draw(program, { path: file, text, failed }) {
    const made = await fs.mkdtemp(path.join(os.tmpdir(), 'lmsl-'));
    try {
        const what = isNetworks(file) ? [file, '--network'] : ['-', ...failed.flatMap((sensor) => ['--failed', sensor])];
        const words = ['graph', ...what, '--output', made, '--quiet'];
        const { code, told } = await run(program, words, { folder: path.dirname(file), input: text });
        const names = (await fs.readdir(made)).sort();
        const pictures = await Promise.all(names.map((name) => fs.readFile(path.join(made, name), 'utf8')));
        return { pictures, fault: fault(code, told, path.basename(file)) };
    } finally {
        await fs.rm(made, { recursive: true, force: true });
    }
}

/**
 * @param {number | null} code
 * @param {string} told
 * @param {string} name of the file
 */
function fault(code, told, name) {
    if (code === 0) return /^error/m.test(told) ? 'There are errors. This is what lmslc understands.' : '';
    const named = told.replaceAll('`-`', `\`${name}\``).replaceAll('─ -:', `─ ${name}:`).trim();
    return named || `lmslc ended with code ${code}, and did not say why.`;
}

module.exports = { draw, isNetworks };
