// SPDX-License-Identifier: MIT
//
// The visible area of each layer of colour glyphs, as HarfBuzz paints them:
//
//     node colour_areas.mjs FONT FIRST STEP COUNT          prints "GLYPH AREA AREA ...", from the lowest layer, in square
//                                                          font units, as every_colour_glyph does with these arguments
//     node colour_areas.mjs FONT FIRST STEP COUNT FILE     compares with these lines of every_colour_glyph: layers of at
//                                                          least 1/10,000 em^2 may differ by 0.5 %
//
// Needs npm's harfbuzzjs beside it. Shapes are spans of rows, exact in x: nothing of the library is used. A glyph that
// differs is drawn again with 16 times as many rows. ROWS: 8192.
import { readFileSync } from "node:fs";
import * as hb from "harfbuzzjs";

const [path, first, step, most] = [process.argv[2], ...process.argv.slice(3).map(Number)];
const face = new hb.Face(new hb.Blob(readFileSync(path)), 0);
const font = new hb.Font(face);
const low = -face.upem;
let rows, height;  // the rows' middles
const divide = (number) => { rows = number, height = 3 * face.upem / number; };
const middle = (r) => low + (r + 0.5) * height;

const combine = (a, b, keeps) => a.map((spans, r) => {  // spans: [x0, x1, x2, x3, ...] ascending
    const other = b[r];
    if (spans.length === 0 && other.length === 0) return spans;
    const out = [];
    for (let i = 0, k = 0, inside = false; i < spans.length || k < other.length;) {
        const x = Math.min(spans[i] ?? Infinity, other[k] ?? Infinity);
        while (spans[i] === x) ++i;
        while (other[k] === x) ++k;
        const now = keeps(i % 2 === 1, k % 2 === 1);
        if (now !== inside) out.push(x);
        inside = now;
    }
    return out;
});
const both = (a, b) => (a === null ? b : b === null ? a : combine(a, b, (p, q) => p && q));
const without = (a, b) => combine(a, b, (p, q) => p && !q);
const either = (a, b) => (a === null || b === null ? null : combine(a, b, (p, q) => p || q));
const nothing = () => Array.from({ length: rows }, () => []);
const covered = (list) => list.reduce((all, l) => either(all, l), nothing());

/// The rows of closed polylines that wind around them.
function fill(polylines) {
    const crossings = Array.from({ length: rows }, () => []);
    for (const points of polylines)
        for (let i = 0; i < points.length; ++i) {
            const [a, b] = [points[i], points[(i + 1) % points.length]];
            if (a[1] === b[1]) continue;
            const up = a[1] < b[1], [p, q] = up ? [a, b] : [b, a];
            for (let r = Math.max(0, Math.ceil((p[1] - low) / height - 0.5)); r < rows && middle(r) < q[1]; ++r)
                if (middle(r) >= p[1])
                    crossings[r].push([p[0] + (q[0] - p[0]) * (middle(r) - p[1]) / (q[1] - p[1]), up ? 1 : -1]);
        }
    return crossings.map((row) => {
        row.sort((a, b) => a[0] - b[0]);
        const spans = [];
        let winding = 0;
        for (const [x, d] of row) {
            if (winding === 0) spans.push(x);
            winding += d;
            if (winding === 0) {
                if (spans.at(-1) === x) spans.pop();
                else spans.push(x);
            }
        }
        const joined = [];
        for (const x of spans) joined.at(-1) === x && joined.length % 2 === 0 ? joined.pop() : joined.push(x);
        return joined;
    });
}

let pen;
const draw = new hb.DrawFuncs();
draw.setMoveToFunc((x, y) => { pen.push([[x, y]]); });
draw.setLineToFunc((x, y) => { pen.at(-1).push([x, y]); });
draw.setCubicToFunc((ax, ay, bx, by, x, y) => {
    const [x0, y0] = pen.at(-1).at(-1);
    for (let i = 1; i <= 160; ++i) {
        const t = i / 160, s = 1 - t;
        pen.at(-1).push([s ** 3 * x0 + 3 * s * s * t * ax + 3 * s * t * t * bx + t ** 3 * x,
                         s ** 3 * y0 + 3 * s * s * t * ay + 3 * s * t * t * by + t ** 3 * y]);
    }
});
draw.setQuadraticToFunc((cx, cy, x, y) => {
    const [x0, y0] = pen.at(-1).at(-1);
    for (let i = 1; i <= 160; ++i) {
        const t = i / 160, s = 1 - t;
        pen.at(-1).push([s * s * x0 + 2 * s * t * cx + t * t * x, s * s * y0 + 2 * s * t * cy + t * t * y]);
    }
});
draw.setClosePathFunc(() => {});

let maps, clips, groups;
const mapped = ([x, y]) => { const m = maps.at(-1); return [m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5]]; };
const clip = (polylines) => clips.push(both(clips.at(-1), fill(polylines.map((p) => p.map(mapped)))));
const layer = () => { groups.at(-1).push(clips.at(-1)); };
const paint = new hb.PaintFuncs();
paint.setPushTransformFunc((xx, yx, xy, yy, dx, dy) => {
    const m = maps.at(-1);
    maps.push([m[0] * xx + m[2] * yx, m[1] * xx + m[3] * yx, m[0] * xy + m[2] * yy, m[1] * xy + m[3] * yy,
               m[0] * dx + m[2] * dy + m[4], m[1] * dx + m[3] * dy + m[5]]);
});
paint.setPopTransformFunc(() => { maps.pop(); });
paint.setPushClipGlyphFunc((glyph) => { pen = []; font.drawGlyph(glyph, draw, null); clip(pen); });
paint.setPushClipRectangleFunc((x0, y0, x1, y1) => clip([[[x0, y0], [x1, y0], [x1, y1], [x0, y1]]]));
paint.setPopClipFunc(() => { clips.pop(); });
paint.setColorFunc(layer);
paint.setLinearGradientFunc(layer);
paint.setRadialGradientFunc(layer);
paint.setSweepGradientFunc(layer);
paint.setPushGroupFunc(() => { groups.push([]); });
paint.setPopGroupFunc((mode) => {
    const source = groups.pop(), backdrop = groups.at(-1), s = covered(source), b = covered(backdrop);
    const cut = (list, by, keep) => list.map((l) => (keep ? both(l, by) : without(l, by)));
    const made = { 0: () => [], 1: () => source, 2: () => backdrop, 4: () => [...source, ...backdrop], 5: () => cut(source, b, true),
                   6: () => cut(backdrop, s, true), 7: () => cut(source, b, false), 8: () => cut(backdrop, s, false),
                   9: () => [...backdrop, ...cut(source, b, true)], 10: () => [...source, ...cut(backdrop, s, true)],
                   11: () => [...cut(backdrop, s, false), ...cut(source, b, false)] }[mode] ?? (() => [...backdrop, ...source]);
    groups[groups.length - 1] = made();
});

/// The areas of a glyph's layers; undefined without colours.
function areas_of(id) {
    maps = [[1, 0, 0, 1, 0, 0]], clips = [null], groups = [[]];
    if (!face.glyphHasColorPaint(id) && face.getGlyphColorLayers(id).length === 0) return undefined;
    font.paintGlyph(id, paint, null, 0, 0x000000ff);
    const layers = groups[0].filter((l) => l !== null);
    const areas = [];
    for (let above = nothing(), i = layers.length; i-- > 0; above = either(above, layers[i]))
        areas.unshift(without(layers[i], above).reduce((sum, row) => row.reduce((t, x, k) => t + (k % 2 ? x : -x), sum), 0) * height);
    return areas;
}

/// By how much the areas differ, as a part of the greater one; Infinity if there are not as many.
const difference = (ours, theirs) => (ours.length !== theirs.length ? Infinity : ours.reduce((worst, a, i) => {
    const greater = Math.max(a, theirs[i]);
    return greater < face.upem ** 2 / 10000 ? worst : Math.max(worst, Math.abs(a - theirs[i]) / greater);
}, 0));

const usual = Number(process.env.ROWS ?? 8192), allowed = 0.005;
const others = process.argv[6] && new Map(readFileSync(process.argv[6], "utf8").trim().split("\n").map((line) => {
    const [id, ...areas] = line.split(" ").map(Number);
    return [id, areas];
}));
let [done, compared, worst, wrong] = [0, 0, 0, 0];
for (let id = first; done < most && id < 65535; id += step) {
    divide(usual);
    let areas = areas_of(id);
    if (areas === undefined) continue;
    ++done;
    if (!others) {
        console.log([id, ...areas.map((a) => a.toFixed(1))].join(" "));
        continue;
    }
    const theirs = others.get(id) ?? [];
    let far = difference(areas, theirs);
    if (far > allowed && far < Infinity) {
        divide(16 * usual);
        far = difference(areas_of(id), theirs);
    }
    compared += areas.length;
    worst = Math.max(worst, far);
    if (far <= allowed) continue;
    ++wrong;
    console.log(`glyph ${id}: ${far === Infinity ? `${areas.length} layers and not ${theirs.length}` : `${(100 * far).toFixed(2)} %`}`);
}
if (others) {
    console.log(`${done} glyphs, ${compared} layers; ${wrong} differ by more than ${100 * allowed} %; the worst by ${(100 * worst).toFixed(2)} %`);
    process.exitCode = wrong === 0 ? 0 : 1;
}
