// SPDX-License-Identifier: MIT
//
// What the peers under node share; the same commands, rows and files as peer_program.hpp. Times are medians of many runs, after
// some for node's compiler; of each run the shorter one of the wall's time and the processor's, which counts node's helping
// threads.
import { readFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';

export const depth = 0.2, bevelWidth = 0.02;  // in em

function judgedCharacters() {
    const all = [];
    for (let c = 0x21; c < 0x250; ++c)
        if (c < 0x7f || (c > 0xa0 && c !== 0xad)) all.push(c);
    return all;
}

async function microsecondsEach(seconds, work) {
    const runs = [], end = performance.now() + seconds * 1000;
    while (runs.length < 3 || (performance.now() < end && runs.length < 2000)) {
        const start = performance.now(), before = process.cpuUsage();
        await work();
        const wall = (performance.now() - start) * 1000, used = process.cpuUsage(before);
        runs.push(Math.min(wall, used.user + used.system));
    }
    runs.sort((a, b) => a - b);
    return runs[runs.length >> 1];
}

async function time(peer, texts, seconds, open) {
    let openFile, ways = [], warmedUp = false;
    for (const line of readFileSync(texts, 'utf8').split('\n').filter((line) => line)) {
        const [name, file, text] = line.split('\t');
        if (file !== openFile) ways = await open(openFile = file).catch(() => []);
        if (!warmedUp) {  // for node's compiler
            for (let round = 0; round < 2; ++round)
                for (const way of ways) await microsecondsEach(seconds, () => way.build(text));
            warmedUp = true;
        }
        for (const way of ways) {
            try {
                const mesh = way.made(await way.build(text));
                const each = await microsecondsEach(seconds, () => way.build(text));
                console.log(['time', peer, way.setting, way.solid, way.state, name, each.toFixed(3), mesh.corners.length / 3,
                    mesh.points.length / 3, 'node'].join('\t'));
            } catch (e) {
                console.error(`${peer}, ${way.setting}: ${name}: ${e.message}`);
            }
        }
    }
}

async function writeMeshes(peer, program, folder, font, open) {
    for (const [i, way] of (await open(font).catch(() => [])).entries()) {
        if (way.state === 'warm' || way.solid === 'wrapped') continue;
        const parts = [Buffer.from(`${peer}\t${way.setting}${way.solid === 'extruded' ? '' : ', ' + way.solid}\t${font}\n`)];
        for (const c of judgedCharacters()) {
            try {
                const mesh = way.made(await way.build(String.fromCodePoint(c)));
                parts.push(Buffer.from(Uint32Array.of(c, mesh.points.length / 3, mesh.corners.length / 3).buffer),
                    Buffer.from(Float32Array.from(mesh.points).buffer), Buffer.from(Uint32Array.from(mesh.corners).buffer));
            } catch { /* the judge counts what is missing */ }
        }
        writeFileSync(`${folder}/${program}.${i + 1}.${font.replaceAll('/', '_')}.meshes`, Buffer.concat(parts));
    }
}

// ways: what open(font file) promises: {setting, solid, state, build(text): promise, made(what was built): {points, corners}}
export async function run(peer, open) {
    const [program, command, a, b] = process.argv.slice(1);
    if (command === 'time') await time(peer, a, Number(b), open);
    else if (command === 'meshes') await writeMeshes(peer, basename(program, '.mjs'), a, b, open);
    else process.exitCode = 2;
}
