'use strict';
// lmslc as a program: where it is, and what it answers.

const { spawn } = require('node:child_process');

/** lmslc could not be started. */
class NotFound extends Error {
    /**
     * @param {string} program
     * @param {Error} cause
     */
    constructor(program, cause) {
        super(`\`${program}\` could not be started (${cause.message})`, { cause });
        this.program = program;
    }
}

/**
 * Runs the program to its end.
 *
 * @param {string} program
 * @param {string[]} words its arguments
 * @param {{ folder?: string, input?: string }} [options] the folder to run it in, and its standard input
 * @returns {Promise<{ code: number | null, output: string, told: string }>} the exit code, standard output and
 * standard error
 * @throws {NotFound}
 */
function run(program, words, { folder, input = '' } = {}) {
    return new Promise((resolve, reject) => {
        const child = spawn(program, words, { cwd: folder, env: { ...process.env, NO_COLOR: '1' } });
        const [output, told] = [child.stdout, child.stderr].map((stream) => {
            /** @type {string[]} */
            const pieces = [];
            stream.setEncoding('utf8').on('data', (piece) => pieces.push(piece));
            return pieces;
        });
        child.on('error', (cause) => reject(new NotFound(program, cause)));
        child.on('close', (code) => resolve({ code, output: output.join(''), told: told.join('') }));
        // A program that ends before it has read everything is no fault of ours: its exit code tells.
        child.stdin.on('error', () => {});
        child.stdin.end(input);
    });
}

module.exports = { NotFound, run };
