// SPDX-License-Identifier: MIT
//
// three-text. Its tolerance is in font units; it keeps letters until its cache is cleared.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { MeshGeometryBuilder, Text } from 'three-text/core';
import { depth, run } from './peer_program.mjs';

const wasm = readFileSync(createRequire(import.meta.url).resolve('harfbuzzjs/hb.wasm'));
Text.setHarfBuzzBuffer(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));

const made = (built) => ({ points: built.vertices, corners: built.indices });

run('three-text', async (file) => {
    const bytes = readFileSync(file);
    const font = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
    const unit = (await Text.create({ text: 'H', font, size: 1 })).loadedFont.upem / 2048;
    // What comes next to typemesh's 1/800 em, by the judge.
    const fidelity = { distanceTolerance: 5.12 * unit, angleTolerance: 0.5 }, simplification = { areaThreshold: 44 * unit * unit };
    const defaults = { distanceTolerance: 0.5, angleTolerance: 0.2 };
    const way = (setting, curveFidelity, geometryOptimization, state, solid, layout) => ({
        setting, solid, state, made,
        build: async (text) => {
            const all = { text, font, size: 1, depth, layout, geometryOptimization, curveFidelity };
            const laidOut = await Text.create(all);
            const builder = new MeshGeometryBuilder(laidOut.loadedFont, laidOut.fontId), built = builder.build(laidOut, all);
            if (state !== 'warm') builder.clearCache();
            return built;
        },
    });
    const wrapped = { width: 12, align: 'justify' }, ways = [];
    for (const state of ['reuse', 'warm']) {
        ways.push(way('1/400 em, simplified', fidelity, simplification, state, 'extruded'),
            way('its defaults', defaults, {}, state, 'extruded'),
            way('1/400 em, simplified', fidelity, simplification, state, 'wrapped', wrapped));
    }
    return ways;
});
