// SPDX-License-Identifier: MIT
//
// npm's earcut and libtess on the glyphs that the native triangulators.cpp has written; the same rows.
//
//     node triangulators.mjs POLYGONS [quick]
//
// Earcut wants each outer loop with its holes: they are found beforehand, and not timed.
import { createReadStream } from 'node:fs';
import { createInterface } from 'node:readline';
import earcut from 'earcut';
import libtess from 'libtess';

const passes = process.argv[3] ? 4 : 10;

function signedArea(loop) {
    let twice = 0;
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) twice += loop[j] * loop[i + 1] - loop[i] * loop[j + 1];
    return twice / 2;
}

function contains(loop, x, y) {
    let inside = false;
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2)
        if (loop[i + 1] > y !== loop[j + 1] > y &&
            x < loop[i] + (loop[j] - loop[i]) * (y - loop[i + 1]) / (loop[j + 1] - loop[i + 1])) inside = !inside;
    return inside;
}

// Each filled loop with the holes in it, as earcut takes them. A loop is a hole where an odd number of others contain it.
function grouped(loops) {
    const depth = loops.map((a) => loops.filter((b) => b !== a && contains(b, a[0] + 0.25, a[1] + 0.25)).length);
    return loops.flatMap((outer, i) => {
        if (depth[i] % 2) return [];
        const points = [...outer], holes = [];
        loops.forEach((hole, k) => {
            if (depth[k] !== depth[i] + 1 || !contains(outer, hole[0] + 0.25, hole[1] + 0.25)) return;
            holes.push(points.length / 2);
            points.push(...hole);
        });
        return [{ points, holes }];
    });
}

const areaOf = (a, b, c, d, e, f) => Math.abs((c - a) * (f - b) - (d - b) * (e - a)) / 2;

function areaOfEarcut(groups) {
    let sum = 0;
    for (const { points, holes } of groups) {
        const t = earcut(points, holes);
        for (let i = 0; i < t.length; i += 3) {
            const [a, b, c] = [t[i] * 2, t[i + 1] * 2, t[i + 2] * 2];
            sum += areaOf(points[a], points[a + 1], points[b], points[b + 1], points[c], points[c + 1]);
        }
    }
    return sum;
}

const tessellator = new libtess.GluTesselator();
tessellator.gluTessCallback(libtess.gluEnum.GLU_TESS_VERTEX_DATA, (vertex, out) => out.push(vertex[0], vertex[1]));
tessellator.gluTessCallback(libtess.gluEnum.GLU_TESS_COMBINE, (at) => [at[0], at[1], 0]);
tessellator.gluTessCallback(libtess.gluEnum.GLU_TESS_EDGE_FLAG, () => {});
tessellator.gluTessProperty(libtess.gluEnum.GLU_TESS_WINDING_RULE, libtess.windingRule.GLU_TESS_WINDING_NONZERO);
tessellator.gluTessNormal(0, 0, 1);

function byLibtess(loops) {
    const out = [];
    tessellator.gluTessBeginPolygon(out);
    for (const loop of loops) {
        tessellator.gluTessBeginContour();
        for (let i = 0; i < loop.length; i += 2) {
            const at = [loop[i], loop[i + 1], 0];
            tessellator.gluTessVertex(at, at);
        }
        tessellator.gluTessEndContour();
    }
    tessellator.gluTessEndPolygon();
    return out;
}

function areaOfLibtess(loops) {
    const t = byLibtess(loops);
    let sum = 0;
    for (let i = 0; i + 5 < t.length; i += 6) sum += areaOf(t[i], t[i + 1], t[i + 2], t[i + 3], t[i + 4], t[i + 5]);
    return sum;
}

function row(peer, { font, tolerance, glyphs }, work, area) {
    let best = Infinity, wrong = 0, points = 0;
    for (const g of glyphs) {
        wrong += Math.abs(area(g) - g.area) > 1e-5 * g.area;
        for (const loop of g.loops) points += loop.length / 2;
    }
    for (let pass = 0; pass < passes; ++pass) {
        const start = performance.now(), before = process.cpuUsage();
        for (const g of glyphs) work(g);
        const used = process.cpuUsage(before);
        best = Math.min(best, (performance.now() - start) * 1000, used.user + used.system);
    }
    console.log(['cut', peer, font, tolerance, (points / glyphs.length).toFixed(1), (best / glyphs.length).toFixed(3), wrong,
        'node'].join('\t'));
}

const sets = new Map();
for await (const line of createInterface({ input: createReadStream(process.argv[2]) })) {
    const glyph = JSON.parse(line), key = glyph.font + glyph.tolerance;
    if (!sets.has(key)) sets.set(key, { ...glyph, glyphs: [] });
    if (glyph.simple) glyph.groups = grouped(glyph.loops);
    sets.get(key).glyphs.push(glyph);
}
console.log('columns\tcut\tpeer\tfont\ttolerance\tpoints_a_glyph\ttime_us_a_glyph\twrong\tclock');
for (const set of sets.values()) {
    if (set.simple) {
        const byEarcut = (g) => {
            for (const { points, holes } of g.groups) earcut(points, holes);
        };
        row('earcut', set, byEarcut, (g) => areaOfEarcut(g.groups));
    }
    row('libtess', set, (g) => byLibtess(g.loops), (g) => areaOfLibtess(g.loops));
}
