// SPDX-License-Identifier: MIT

// With TYPEMESH_TEST_FONT, or fc-match, which finds a font that is installed.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import load, { TypemeshError } from '../typemesh.js';

const fontFile = process.env.TYPEMESH_TEST_FONT ?? execFileSync('fc-match', ['-f', '%{file}', 'DejaVu Sans'], { encoding: 'utf8' });
const bytes = readFileSync(fontFile);
const typemesh = await load();
const font = typemesh.font(bytes);

/** What holds for every mesh. */
function check(mesh) {
    const { position, normal, uv, index, parts, statistics, bounds } = mesh;
    assert.equal(position.length, 3 * statistics.vertices);
    assert.equal(normal.length, position.length);
    assert.equal(uv.length, 2 * statistics.vertices);
    assert.equal(index.length, 3 * statistics.triangles);
    assert.ok(index.every((i) => i < statistics.vertices));
    let next = 0;
    for (const part of parts) {
        assert.equal(part.start, next, 'parts follow each other');
        next += part.count;
    }
    assert.equal(next, index.length, 'parts hold all triangles');
    for (let i = 0; i < position.length; i += 3) {
        const length = Math.hypot(normal[i], normal[i + 1], normal[i + 2]);
        assert.ok(Math.abs(length - 1) < 1e-5, `a normal of length ${length}`);
        for (let k = 0; k < 3; ++k) assert.ok(position[i + k] >= bounds.low[k] && position[i + k] <= bounds.high[k], `${position[i + k]} is beyond the bounds ${JSON.stringify(bounds)}`);
    }
}

test('a text is a closed mesh', () => {
    const mesh = typemesh.mesh('Hello world!', font);
    check(mesh);
    assert.ok(mesh.statistics.triangles > 500);
    assert.deepEqual(mesh.parts.map((p) => p.name), ['front', 'back', 'side']);
    assert.equal(mesh.openEdges(), 0);
    assert.deepEqual(mesh.warnings, []);
    assert.equal(mesh.contours().length, 6 * mesh.statistics.contourPoints);
});

test('every value of every option makes a mesh', () => {
    const values = {
        size: [0.5, 20], depth: [0, 0.5], tolerance: [0.01], crease: [120], 'bevel.width': [0.01], 'bevel.depth': [0.05],
        'bevel.points': [[0, 0, 0.2, 0.8, 1, 1]], 'bevel.steps': [3], embolden: [0.01, -0.005], 'outline.width': [0.01],
        'bend.cylinder': [180, -90], 'bend.radius': [3], 'bend.twist': [90], 'bend.wave': [0.1], 'warp.arc': [90], 'warp.flag': [0.1],
        'path.ring': [3, -3], 'path.wave': [0.3],
        'inflate.height': [1, 0.5], 'tube.radius': [0.02, 0.01],
        width: [4], letterSpacing: [0.1], lineSpacing: [1.5], indent: [1], maxLines: [1], ellipsis: ['…'],
        features: [{ liga: 0 }, { smcp: true }], language: ['tr'], script: ['Latn'],
    };
    const plain = typemesh.hash('Grün affix\ntwo', font);
    for (const option of typemesh.options) {
        const all = values[option.name] ?? option.choices ?? [true, false];
        const set = (value) => {
            const [group, inner] = option.name.split('.');
            if (inner === undefined) return { [group]: value };
            const needed = {
                bevel: { width: 0.01, profile: option.name === 'bevel.points' ? 'points' : 'round', points: [0, 0, 0.5, 0.9, 1, 1] },
                outline: { width: 0.01 },
                inflate: { height: 1 },
            };
            return { [group]: { ...needed[group], [inner]: value } };
        };
        const hashes = new Set();
        for (const value of all) {
            const mesh = typemesh.mesh('Grün affix\ntwo', font, set(value));
            check(mesh);
            if (option.name !== 'depth' || value > 0) assert.equal(mesh.openEdges(), 0, `${option.name} = ${value}`);
            hashes.add(mesh.hash());
        }
        const indifferent = ['fill', 'direction', 'letters', 'cached', 'features', 'language', 'script', 'justify', 'wrap', 'breaker', 'ellipsis', 'bevel.mode', 'merge', 'discretiser', 'markup'];
        if (!indifferent.includes(option.name)) assert.ok(hashes.size > 1 || !hashes.has(plain), `${option.name} changes the mesh`);
    }
    assert.equal(typemesh.hash('Grün affix\ntwo', font), plain, 'options of one text are gone with the next');
});

test('vertices know their letters', () => {
    const text = 'affix\nit', options = { letters: true, merge: false };
    const mesh = typemesh.mesh(text, font, options);
    const shared = mesh.letters.length < 7; // the font has a ligature
    assert.equal(mesh.letters.length, shared ? mesh.letters.length : 7);
    assert.equal(mesh.letter.length, mesh.statistics.vertices);
    assert.deepEqual(mesh.letters.map((l) => l.line).sort(), [...Array(mesh.letters.length - 2).fill(0), 1, 1]);
    const centre = mesh.letters.map(() => [Infinity, -Infinity]);
    mesh.letter.forEach((letter, i) => {
        const x = mesh.position[3 * i];
        centre[letter] = [Math.min(centre[letter][0], x), Math.max(centre[letter][1], x)];
    });
    mesh.letters.forEach((l, i) => assert.ok(Math.abs(l.pivot[0] - (centre[i][0] + centre[i][1]) / 2) < 1e-4, 'a pivot is a centre'));
    assert.equal(typemesh.mesh(text, font).letter.length, 0);
    assert.equal(typemesh.hash(text, font, options), typemesh.hash(text, font, { merge: false }));
});

test('a ring of letters', () => {
    const { bounds, statistics } = typemesh.mesh('round and round and', font, { path: { ring: 2 } });
    for (const k of [0, 1]) {
        assert.ok(bounds.high[k] < 3.1 && bounds.low[k] > -3.1, `letters stand on the ring: ${JSON.stringify(bounds)}`);
        assert.ok(bounds.high[k] > 2, 'outside it');
    }
    const inside = typemesh.mesh('round and round and', font, { path: { ring: -4 } }).bounds;
    assert.ok(inside.low[1] > -4.3 && inside.low[1] < -3, `inside it at its lower end: ${JSON.stringify(inside)}`);
    assert.throws(() => typemesh.mesh('a', font, { path: { ring: 2 }, warp: { arc: 20 } }), /one warp or path at a time/);
    assert.ok(statistics.triangles > 500);
});

test('bent, warped and inflated letters', () => {
    const text = 'Around', plain = typemesh.mesh(text, font), flat = plain.bounds, count = plain.statistics.vertices;
    const wide = ({ low, high }) => high[0] - low[0];
    const half = typemesh.mesh(text, font, { bend: { cylinder: 180 } });
    check(half);
    assert.ok(half.statistics.vertices > count, 'a bent letter has more points');
    // Half around a cylinder whose circumference is twice as long as the text, whose middle stays where it is.
    assert.ok(Math.abs(wide(half.bounds) / wide(flat) - 2 / Math.PI) < 0.05, `${wide(half.bounds)} of ${wide(flat)}`);
    const middle = ({ low, high }) => (low[0] + high[0]) / 2;
    assert.ok(Math.abs(middle(half.bounds) - middle(flat)) < 0.05 * wide(flat));
    const aligned = ['start', 'centre', 'end'].map((align) => typemesh.mesh(text, font, { align, bend: { cylinder: 180 } }).bounds).map(wide);
    for (const one of aligned) assert.ok(Math.abs(one - aligned[0]) < 1e-5, 'it bends alike wherever the line stands');
    const screw = typemesh.mesh(text, font, { bend: { twist: 360 }, bevel: { width: 0.01 } });
    check(screw);
    assert.equal(screw.openEdges(), 0);
    const stamp = typemesh.mesh(text, font, { warp: { arc: 90 }, inflate: { height: 1 } });
    check(stamp);
    assert.equal(stamp.openEdges(), 0);
    assert.deepEqual(stamp.parts.map((p) => p.name), ['front', 'back']);
    assert.ok(Math.abs(stamp.bounds.low[2] + stamp.bounds.high[2]) < 1e-5, 'a balloon is alike in front and behind');
    const neon = typemesh.mesh(text, font, { path: { ring: 3 }, tube: { radius: 0.02 } });
    check(neon);
    assert.equal(neon.openEdges(), 0);
    assert.deepEqual(neon.parts.map((p) => p.name), ['side']);
    assert.ok(Math.abs(neon.bounds.high[2] - 0.02) < 1e-5 && Math.abs(neon.bounds.low[2] + 0.02) < 1e-5, 'tubes are as deep as wide');
    const columns = typemesh.mesh('ab\ncd', font, { direction: 'ttb', bend: { cylinder: 90 } });
    assert.equal(columns.openEdges(), 0);
});

test('options stay where they are set, and undefined is their default', () => {
    const mesher = typemesh.mesher(font, { depth: 0.5 });
    assert.equal(mesher.mesh('a').bounds.low[2], -0.5);
    assert.equal(mesher.mesh('a', { depth: 0.25 }).bounds.low[2], -0.25);
    assert.equal(mesher.mesh('a').bounds.low[2], -0.5);
    assert.equal(mesher.set({ depth: undefined, size: 2 }).mesh('a').bounds.low[2], Math.fround(-0.4));
    mesher.free();
});

test('a cold mesh equals the mesh from a warm cache', () => {
    const cold = typemesh.hash('Rag', font, { cached: false, bevel: { width: 0.03 } });
    assert.equal(typemesh.hash('Rag', font, { bevel: { width: 0.03 } }), cold);
    assert.equal(typemesh.hash('Rag', font, { bevel: { width: 0.03 } }), cold);
});

test('arrays are views of one memory, which end and outlive its growth', () => {
    const [one, other] = [typemesh.mesher(font), typemesh.mesher(font, { quality: 'best' })];
    const mesh = one.mesh('first');
    const kept = mesh.position;
    assert.equal(kept.buffer, mesh.index.buffer, 'no copy');
    assert.equal(mesh.position, kept, 'the same view as long as the memory stays');
    const before = [...kept.slice(0, 9)];
    const bytesBefore = typemesh.memoryBytes;
    other.mesh('The memory grows for this. '.repeat(400));
    assert.ok(typemesh.memoryBytes > bytesBefore);
    assert.equal(kept.length, 0, 'the browser has detached the old view');
    assert.deepEqual([...mesh.position.slice(0, 9)], before, 'the mesh has a new one');
    const copied = mesh.copy();
    one.mesh('second');
    assert.throws(() => mesh.position, TypeError);
    assert.equal(copied.position.length, copied.normal.length);
    one.free();
    assert.throws(() => one.mesh('third'), TypeError);
    other.free();
});

test('1,000 characters are rewritten without allocation', () => {
    const mesher = typemesh.mesher(font, { quality: 'low', features: { liga: 0 } });
    const letters = 'abcdefghijklmnopqrstuvwxyz0123456789 ';
    const line = (k) => Array.from({ length: 1000 }, (_, i) => letters[(i * 7 + k * (1 + (i % 5))) % letters.length]).join('');
    for (let k = 0; k < 40; ++k) mesher.mesh(line(k));
    const warm = typemesh.memoryBytes;
    for (let k = 0; k < 100; ++k) assert.equal(mesher.mesh(line(k)).statistics.glyphs, 1000);
    assert.equal(typemesh.memoryBytes, warm);
    mesher.free();
});

test('letters are meshes with places', () => {
    const mesher = typemesh.mesher(font);
    const whole = mesher.mesh('banana').copy();
    const letters = mesher.letters('banana');
    assert.equal(letters.meshes.length, 3);
    assert.equal(letters.mesh.length, 6);
    const places = (position, of, at) => of.map((v) => [0, 1, 2].map((k) => (position[3 * v + k] + at[k]).toFixed(4)).join());
    const placed = [];
    letters.mesh.forEach((m, i) => {
        const at = letters.translation.slice(3 * i, 3 * i + 3);
        for (const part of letters.meshes[m].parts)
            placed.push(...places(letters.position, [...letters.index.slice(part.start, part.start + part.count)], at));
    });
    const expected = places(whole.position, [...whole.index], [0, 0, 0]);
    assert.deepEqual(placed.sort(), expected.sort());
    mesher.free();
});

test('paragraphs are as wide as requested', () => {
    const text = 'In the beginning the Universe was created. This has made a lot of people very angry.';
    const mesh = typemesh.mesh(text, font, { width: 10, align: 'justify' });
    assert.ok(mesh.statistics.lines > 3);
    assert.ok(mesh.bounds.high[0] <= 10.2 && mesh.bounds.high[0] > 9.5);
});

test('fonts describe themselves, stand in for each other, and may be bytes', () => {
    assert.ok(font.unitsPerEm > 0 && font.glyphCount > 100 && font.faceCount === 1 && font.family !== '');
    assert.ok(font.has('abc') && !font.has('a\u{10FFFF}'));
    assert.equal(typemesh.hash('ab', [font, typemesh.font(bytes)]), typemesh.hash('ab', font));
    assert.equal(typemesh.hash('ab', bytes), typemesh.hash('ab', font));
    const mesh = typemesh.mesh('a\u{10FFFF}', font);
    assert.equal(mesh.statistics.missing, 1);
    assert.match(mesh.warnings[0], /^No font has a glyph for 1 of 2 characters; the first is U\+10FFFF, at 1\. Add another font\.$/);
    assert.match(typemesh.mesh('a\uD800', font).warnings.join(), /half of a character/);
});

test('tags are read', () => {
    const text = 'a[b]b[/b][colour=#c33]c[/] [size=2]d[/] [mark=#ff0]e[/][[';
    const options = { markup: true, bevel: { width: 0.02 }, letters: true };
    const mesh = typemesh.mesh(text, font, options);
    check(mesh);
    assert.equal(mesh.openEdges(), 0);
    assert.equal(mesh.tint.length, 4 * mesh.statistics.vertices);
    const tints = new Set();
    for (let i = 0; i < mesh.tint.length; i += 4) tints.add([...mesh.tint.subarray(i, i + 4)].join());
    assert.deepEqual([...tints].sort(), ['0,0,0,255', '204,51,51,0', '255,255,0,0']);
    assert.equal(mesh.letters.length, 7, 'six letters and a mark');
    const plain = typemesh.hash('abc', font);
    assert.notEqual(typemesh.hash('[b]abc[/b]', font, { markup: true }), plain);
    assert.equal(typemesh.hash('[colour=#123]abc', font, { markup: true }), plain, 'colours move nothing');
    assert.equal(typemesh.hash('abc', font, { markup: true }), plain);
    assert.equal(typemesh.mesh('[b]', font).tint.length, 0);
    for (const [wrong, at, words] of [['ab[b', 2, /^There is a tag without its \]/], ['a[/b]', 1, /^There is a closing tag/], ['[font=7]a', 0, /^\[font=/]])
        assert.throws(() => typemesh.mesh(wrong, font, { markup: true }), (e) => e instanceof TypemeshError && e.at === at && words.test(e.message));
});

test('vertices reach the bounds exactly, whatever depth tags ask for', () => {
    for (const text of ['[depth=0.5]ab[/]', '[depth=0.5]a[/]b', 'a[depth=0.05]b[/]', '[mark=#ff0]ab[/]']) {
        const { position, bounds } = typemesh.mesh(text, font, { markup: true });
        const [low, high] = [Infinity, -Infinity].map((start, k) => [0, 1, 2].map((c) =>
            position.filter((_, i) => i % 3 === c).reduce((a, b) => (k === 0 ? Math.min(a, b) : Math.max(a, b)), start)));
        assert.deepEqual(bounds, { low, high }, text);
        assert.ok(Math.abs(low[2] + 0.2) < 1e-6, `${text}: all backs lie in one plane`);
    }
});

test('letters of tags are merged unless merge is off', () => {
    const triangles = (text, options) => typemesh.mesh(text, font, { markup: true, letterSpacing: -0.2, ...options }).statistics.triangles;
    assert.notEqual(triangles('[b]oo[/]', {}), triangles('[b]oo[/]', { merge: false }));
    assert.equal(triangles('[b]oo[/]', { merge: false }), 2 * triangles('[b]o[/]', { merge: false }));
});

test('a font that is refused leaves no memory behind', () => {
    const open = (options, words) => assert.throws(() => typemesh.font(bytes, options), words);
    open({ variations: { toolong: 1 } }, /is not a tag/);
    const before = typemesh.memoryBytes;
    for (let i = 0; i < 200; ++i) open({ variations: { wght: 400, toolong: 1 } }, /is not a tag/);
    assert.ok(typemesh.memoryBytes - before < 2 * bytes.length, `${typemesh.memoryBytes - before} bytes are gone`);
});

const inter = execFileSync('fc-match', ['-f', '%{file}', 'Inter:variable=true'], { encoding: 'utf8' });
test('a text moves along an axis', { skip: !/Inter/.test(inter) && 'Inter is not installed as a variable font' }, () => {
    const font = typemesh.font(readFileSync(inter)), mesher = typemesh.mesher(font);
    const morph = mesher.morph('breathe', 'wght', { depth: 0.1 });
    assert.deepEqual([morph.minimum, morph.maximum], [100, 900]);
    const thin = morph.at(100), index = thin.index.slice(), first = thin.position.slice();
    check(thin);
    assert.equal(thin.openEdges(), 0);
    const wide = morph.at(900);
    check(wide);
    assert.deepEqual(wide.index, index, 'the triangles stay');
    assert.notDeepEqual(wide.position, first);
    assert.ok(wide.bounds.high[0] > first.reduce((all, x, i) => (i % 3 ? all : Math.max(all, x)), 0), 'bold letters are wider');
    assert.throws(() => thin.position, /no longer valid/);
    mesher.mesh('other');
    check(morph.at(500));
    assert.throws(() => morph.at('1'), TypeError);
    assert.throws(() => mesher.morph('a', 'wdth'), (e) => e instanceof TypemeshError && /axis/.test(e.message));
    const tagged = mesher.morph('[b]a[1]', 'wght').at(500).statistics.glyphs;
    assert.equal(tagged, 7, 'brackets are letters');
    assert.equal(mesher.morph('[b]a[[1]', 'wght', { markup: true }).at(500).statistics.glyphs, 4, 'until tags are read');
    assert.throws(() => mesher.morph('a[b', 'wght', { markup: true }), (e) => e.at === 1 && /^There is a tag without/.test(e.message));
    mesher.morph('b', 'wght');
    assert.throws(() => morph.at(500), /planned another/);
});

test('what is refused is said in a sentence', () => {
    const refuses = (run, type, words) => assert.throws(run, (e) => e instanceof type && words.test(e.message));
    refuses(() => typemesh.font(new Uint8Array(100)), TypemeshError, /^The data is not a font/);
    refuses(() => typemesh.font(bytes, { index: 5 }), TypemeshError, /^There is no face with that number/);
    refuses(() => typemesh.font(bytes, { variations: { wght: 700 } }), TypemeshError, /no such variation axis/);
    refuses(() => typemesh.mesh('a', font, { size: -1 }), TypemeshError, /outside its range: .*\(size\)$/);
    refuses(() => typemesh.mesh('a', font, { tolerance: 0 }), TypemeshError, /tolerance is not a positive/);
    refuses(() => typemesh.mesh('a', font, { bevel: { widht: 1 } }), TypeError, /^There is no option bevel\.widht: check its name\.$/);
    refuses(() => typemesh.mesh('a', font, { align: 'middle' }), TypeError, /^align must be one of start, end, left/);
    refuses(() => typemesh.mesh('a', font, { depth: '1' }), TypeError, /^depth must be a number, not "1"\.$/);
    refuses(() => typemesh.mesh('a', font, { features: { toolong: 1 } }), TypeError, /is not a tag/);
    refuses(() => typemesh.mesh('a', []), TypeError, /at least one font/);
    refuses(() => typemesh.mesh(5, font), TypeError, /^The text must be a string\.$/);
    const bent = (text, options, words) => refuses(() => typemesh.mesh(text, font, options), TypemeshError, words);
    bent('Hi', { depth: 0.4, bend: { cylinder: 360 } }, /^The deformation folds the letters: bend them less/);
    bent('Hello', { bend: { cylinder: 400 } }, /^The text is longer than the circumference/);
    bent('Hello', { warp: { arc: 400 } }, /^The text is longer than the circumference/);
    bent('Hello', { bend: { radius: 0 } }, /outside its range: .*\(radius\)$/);
    bent('Hello', { bend: { twist: NaN } }, /outside its range: .*\(degrees_per_em\)$/);
    bent('Hello', { bend: { twist: 90, wave: 0.1 } }, /^A text bends in one way at a time/);
    bent('Hello', { bend: { cylinder: 90, radius: 2 } }, /^A cylinder has degrees or a radius/);
    bent('Hello', { warp: { arc: 90, flag: 0.1 } }, /^A text has one warp or path at a time/);
    bent('Hello', { bend: { twist: 90 }, outline: { width: 0.01 } }, /^Hollow letters cannot be bent/);
    bent('Hello', { bend: { twist: 90 }, inflate: { height: 1 } }, /^Inflated letters cannot be bent/);
    bent('Hello', { inflate: { height: 1 }, bevel: { width: 0.01 } }, /^Inflated letters have no bevels/);
    bent('Hello', { inflate: { height: 1 }, outline: { width: 0.01 } }, /^Inflated letters cannot be hollow/);
    bent('Hello', { tube: { radius: 0.02 }, bend: { twist: 90 } }, /^Tubes cannot be bent/);
    bent('Hello', { tube: { radius: 0.02 }, bevel: { width: 0.01 } }, /^Tubes have no bevels/);
    bent('Hello', { tube: { radius: 0.02 }, outline: { width: 0.01 } }, /^Tubes cannot be hollow/);
    bent('Hello', { tube: { radius: 0.02 }, inflate: { height: 1 } }, /^Tubes cannot be inflated/);
    bent('Hello', { inflate: { height: 1, form: 'dome' }, depth: 0 }, /^A dome stands on walls/);
    refuses(() => typemesh.mesh('Hello world!', font, { bend: { radius: 0.5 } }), TypemeshError, /^The text is longer than the circumference/);
    assert.ok(typemesh.mesh('a', font).statistics.triangles > 0, 'all is well afterwards');
});

test('a font may be freed before its meshers', () => {
    const own = typemesh.font(bytes);
    const mesher = typemesh.mesher(own);
    const hash = mesher.mesh('abc').hash();
    own.free();
    assert.throws(() => typemesh.mesher(own), TypeError);
    assert.equal(mesher.mesh('abc', { cached: false }).hash(), hash);
    mesher.free();
});

test('empty texts are empty meshes', () => {
    for (const text of ['', ' ', '\n']) {
        const mesh = typemesh.mesh(text, font);
        check(mesh);
        assert.equal(mesh.index.length, 0);
        assert.equal(mesh.openEdges(), 0);
        assert.equal(mesh.contours().length, 0);
    }
});

test('instances of the module are apart', async () => {
    const another = await load(readFileSync(new URL('../typemesh.wasm', import.meta.url)));
    assert.throws(() => another.mesh('a', font), TypeError);
    assert.equal(another.hash('a', another.font(bytes)), typemesh.hash('a', font));
});
