// SPDX-License-Identifier: MIT
//
// three.js' TextGeometry. TTFLoader.mjs is its loader of fonts, which run.sh makes find its parser in the package.
import { readFileSync } from 'node:fs';
import { Font } from 'three/addons/loaders/FontLoader.js';
import { TextGeometry } from 'three/addons/geometries/TextGeometry.js';
import { TTFLoader } from './TTFLoader.mjs';
import { bevelWidth, depth, run } from './peer_program.mjs';

// The loader makes an em 100 / 72 sizes.
const size = 0.72;

function made(geometry) {
    const points = geometry.attributes.position.array;
    return { points, corners: Uint32Array.from({ length: points.length / 3 }, (_, i) => i) };
}

run('three.js TextGeometry', async (file) => {
    const bytes = readFileSync(file);
    const font = new Font(new TTFLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength)));
    const way = (curveSegments, bevel) => ({
        setting: `${curveSegments} segments a curve`, solid: bevel ? 'bevelled' : 'extruded', state: 'cold', made,
        build: async (text) => new TextGeometry(text, {
            font, size, curveSegments, depth: bevel ? depth - 2 * bevelWidth : depth, bevelEnabled: bevel,
            bevelThickness: bevelWidth, bevelSize: bevelWidth, bevelOffset: -bevelWidth, bevelSegments: 3,
        }),
    });
    return [way(3, false), way(4, false), way(12, false), way(4, true)];
});
