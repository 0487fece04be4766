// SPDX-License-Identifier: MIT

// node measure.mjs MESH_HASH MILLISECONDS NAME=TYPEMESH.WASM...      rows of the table of times; see measure.sh

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

import load from './package/typemesh.js';

const [program, milliseconds, ...modules] = process.argv.slice(2);
const file = execFileSync('fc-match', ['-f', '%{file}', 'DejaVu Sans'], { encoding: 'utf8' });
const prose = 'The quick brown fox jumps over the lazy dog, 0123456789 times. '.repeat(20);
const bevel = { width: 0.02, profile: 'round' };
const cases = [
    ['"Hello world!", cold', 'Hello world!', { cached: false }],
    ['"Hello world!", cold, round bevels', 'Hello world!', { cached: false, bevel }],
    ['"Hello world!", cold, hollow', 'Hello world!', { cached: false, outline: { width: 0.02 } }],
    ['"Hello world!", cold, quality best', 'Hello world!', { cached: false, quality: 'best' }],
    ['"Hello world!", cold, round a column', 'Hello world!', { cached: false, bend: { cylinder: 180 } }],
    ['"Hello world!", cold, inflated', 'Hello world!', { cached: false, inflate: { height: 1 } }],
    ['"Hello world!", cached', 'Hello world!', {}],
    ['"Hello world!", on a ring, cached', 'Hello world!', { path: { ring: 2 } }],
    ['200 characters, a paragraph, cold', prose.slice(0, 200), { cached: false, width: 20 }],
    ['200 characters, a paragraph, cached', prose.slice(0, 200), { width: 20 }],
    ['1,000 characters, cached', prose.slice(0, 1000), {}],
    ['1,000 characters, flat, cached', prose.slice(0, 1000), { depth: 0 }],
];
const words = (some, before = '') =>
    Object.entries(some).flatMap(([name, value]) =>
        typeof value === 'object' ? words(value, `${before}${name}.`) : [`${before}${name}=${value}`]);

const loaded = [];
for (const one of modules) {
    const [name, path] = one.split('=');
    const typemesh = await load(readFileSync(path));
    loaded.push({ name, typemesh, font: typemesh.font(readFileSync(file)) });
}
const round = (n) => (n < 100 ? n.toFixed(1) : n.toFixed(0));
console.log(`| text | vertices | native, µs | ${loaded.map((l) => `${l.name}, µs | times native`).join(' | ')} |`);
console.log(`|---|---:|---:|${'---:|---:|'.repeat(loaded.length)}`);
for (const [label, text, options] of cases) {
    const cells = [];
    let native = Infinity;
    let vertices = 0;
    const meshers = loaded.map(({ typemesh, font }) => typemesh.mesher(font, options));
    const least = meshers.map(() => Infinity);
    for (let round = 0; round < 3; ++round) { // in turns, so that other work of the machine meets all alike
        const command = [text, '--font', file, '--time', String(milliseconds / 3), ...words(options)];
        const native_run = JSON.parse(execFileSync(program, command, { encoding: 'utf8' }));
        native = Math.min(native, native_run.microseconds);
        vertices = native_run.vertices;
        meshers.forEach((mesher, i) => {
            const end = performance.now() + milliseconds / 3;
            do least[i] = Math.min(least[i], mesher.mesh(text).statistics.microseconds);
            while (performance.now() < end);
            if (mesher.mesh(text).hash() !== native_run.hash) throw new Error(`${label}: the mesh differs from the native one`);
        });
    }
    for (const one of least) cells.push(`${round(one)} | ${(one / native).toFixed(2)}`);
    console.log(`| ${label} | ${vertices} | ${round(native)} | ${cells.join(' | ')} |`);
}
