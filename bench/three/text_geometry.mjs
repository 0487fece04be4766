// SPDX-License-Identifier: MIT
//
// Writes the bevelled mesh that three.js makes of each text, carved in and put on: FOLDER/0.three-in.obj,
// FOLDER/0.three-out.obj and so on. The em is 1, the whole depth 0.2, as in text_to_mesh; the bevel is one slope.
//
//     node text_geometry.mjs FONT WIDTH FOLDER TEXT...
import { readFileSync, writeFileSync } from 'node:fs';
import { Font } from 'three/addons/loaders/FontLoader.js';
import { TextGeometry } from 'three/addons/geometries/TextGeometry.js';
import { TTFLoader } from './TTFLoader.mjs';

const [fontFile, widthText, folder, ...texts] = process.argv.slice(2);
const width = Number(widthText), depth = 0.2;
const bytes = readFileSync(fontFile);
const font = new Font(new TTFLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength)));

// The loader makes an em 100 / 72 sizes.
function bevelled(text, bevelOffset) {
    return new TextGeometry(text, {
        font, size: 0.72, depth: depth - 2 * width,
        bevelEnabled: true, bevelThickness: width, bevelSize: width, bevelOffset, bevelSegments: 1,
    });
}

function partOf(heights) {
    const within = (low, high) => heights.every((z) => z > low - 1e-6 && z < high + 1e-6);
    const back = -width, front = depth - width;
    if (within(front, front)) return 'front';
    if (within(back, back)) return 'back';
    return within(front - width, front) ? 'front_bevel' : within(back, back + width) ? 'back_bevel' : 'side';
}

function write(path, geometry) {
    const at = geometry.attributes.position.array;
    const lines = [];
    for (let i = 0; i < at.length; i += 3) lines.push(`v ${at[i]} ${at[i + 1]} ${at[i + 2]}`);
    for (let i = 0, v = 1; i < at.length; i += 9, v += 3)
        lines.push(`usemtl ${partOf([at[i + 2], at[i + 5], at[i + 8]])}`, `f ${v} ${v + 1} ${v + 2}`);
    writeFileSync(path, lines.join('\n') + '\n');
}

texts.forEach((text, i) => {
    write(`${folder}/${i}.three-in.obj`, bevelled(text, -width));
    write(`${folder}/${i}.three-out.obj`, bevelled(text, 0));
});
