// SPDX-License-Identifier: MIT
//
// Compares the area that text_to_mesh covers with what resvg draws, for each file. run.sh calls it.
//
//     node --expose-gc areas.mjs PROGRAM RESULT.tsv FILES.txt     FILES.txt names a file a line; resvg-js is in NODE_PATH
//
// Opacities are made 1 for both, because a mesh covers a place or does not. A line of the result: file, what became of it,
// the area of resvg and of the mesh as a share of the larger side's square, the difference in percent, warnings.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const { Resvg } = createRequire(import.meta.url)('@resvg/resvg-js');
const [program, result, list] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'typemesh-svg-'));
const [input, output] = [join(folder, 'in.svg'), join(folder, 'out.obj')];

function drawnArea(text) {
    const picture = new Resvg(text, { fitTo: { mode: 'width', value: 2048 }, font: { loadSystemFonts: false } }).render();
    const pixels = picture.pixels;  // a new copy at each call
    let sum = 0;
    for (let i = 3; i < pixels.length; i += 4) sum += pixels[i];
    return sum / 255 / Math.max(picture.width, picture.height) ** 2;
}

function meshArea(file) {
    const at = [[0, 0]];
    let sum = 0;
    for (const line of readFileSync(file, 'latin1').split('\n')) {
        const words = line.split(' ');
        if (words[0] === 'v') at.push([+words[1], +words[2]]);
        if (words[0] !== 'f') continue;
        const [a, b, c] = words.slice(1).map((w) => at[parseInt(w)]);
        sum += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    return sum;
}

const rows = [], counts = { same: 0, blank: 0, refused: 0, unread: 0 };
let worst = 0, worstFile = '';
for (const file of readFileSync(list, 'utf8').trim().split('\n')) {
    const text = readFileSync(file, 'utf8').replace(/((?:fill-|stroke-|stop-)?opacity)\s*([=:])\s*("?)[\d.]+/g, '$1$2$31');
    writeFileSync(input, text);
    globalThis.gc();  // pictures are large, and node does not see that
    let area;
    try {
        area = drawnArea(text);
    } catch (trouble) {
        rows.push([file, 'unread', 0, 0, 0, trouble.message]);
        ++counts.unread;
        continue;
    }
    const made = spawnSync(program, ['--svg', input, '--depth', '0', '--tolerance', '0.00002', '--output', output], { encoding: 'utf8' });
    const said = made.stderr.trim().replaceAll('\n', ' / ');
    if (made.status !== 0) {
        const kind = area === 0 && said.includes('blank') ? 'blank' : 'refused';
        ++counts[kind];
        rows.push([file, kind, area, 0, 0, said]);
        continue;
    }
    const own = meshArea(output), off = ((own - area) / Math.max(area, 1e-9)) * 100;
    if (Math.abs(off) > worst) [worst, worstFile] = [Math.abs(off), file];
    ++counts.same;
    rows.push([file, 'drawn', area.toFixed(6), own.toFixed(6), off.toFixed(3), said]);
}
writeFileSync(result, rows.map((r) => r.join('\t')).join('\n') + '\n');
rmSync(folder, { recursive: true });
const over = rows.filter((r) => r[1] === 'drawn' && Math.abs(r[4]) > 0.5).length;
console.log(`${counts.same} drawn, ${counts.blank} blank in both, ${counts.refused} refused, ${counts.unread} that resvg refuses`);
console.log(`${over} differ by more than 0.5 %; the worst by ${worst.toFixed(3)} %: ${worstFile}`);
process.exit(counts.refused === 0 && over === 0 ? 0 : 1);
