// SPDX-License-Identifier: MIT
//
// Lays texts out with SkParagraph (npm's canvaskit-wasm, 0.42.0; BSD-3) and records what it did, for
// tests/adapt/skparagraph.test.cpp. Run by record.sh; the fonts are those of Debian's packages, which the tests install.
//
//     node record.mjs FOLDER_OF_FONTS >recorded.txt
//
// Units: bytes of UTF-8, pixels at 64 pixels per em without hinting, widths in em. The lines of the file:
//
//     font NAME PATH BYTES CHECKSUM    FNV-1a, 64 bits, of the file
//     text NAME DIRECTION FONT...      in the order in which they are tried; the text itself is the next line, \n its breaks
//     layout WIDTH ALIGN
//     line FIRST LAST LEFT             where what is visible begins; white space at its end belongs to the line
//     run FONT ID@BYTE+X...            the line's glyphs from left to right, X from LEFT; not repeated where lines are
//                                      centred or justified
//     spread GLYPH+X...                from that glyph of the line on all stand X further right than in the left layout
//     box FIRST LAST LINE X~X          of a range of the text, line by line, in each from left to right
//     grapheme FIRST LAST X~X ltr|rtl
//     hit X LINE BYTE up|down          the place nearest to a point, X from the paragraph's left
import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

const CK = await createRequire(import.meta.url)('canvaskit-wasm/full')();
const folder = process.argv[2];
const em = 64;

const fonts = {
    dejavu: 'truetype/dejavu/DejaVuSans.ttf',
    liberation: 'truetype/liberation/LiberationSerif-Regular.ttf',
    inter: 'truetype/inter-vf/Inter-roman.var.ttf',
    amiri: 'opentype/fonts-hosny-amiri/Amiri-Regular.ttf',
    lohit: 'truetype/lohit-devanagari/Lohit-Devanagari.ttf',
    sawarabi: 'truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf',
};

const english = 'The quick AVATAR, To Ve and office fjord flows: “We. Ta Yo” offices — efficient Tyres. ' +
    'A VA-VAT Wave, 1.000 LT (see p. 12/13): self-evident.';
const texts = [
    { name: 'english', direction: 'ltr', fonts: ['dejavu'], widths: [7, 10, 14, 19, 33], text: english },
    { name: 'english-kerned', direction: 'ltr', fonts: ['liberation'], widths: [6, 8, 11, 16, 27], text: english },
    // SkParagraph fills a word that is longer than the line into the line where it stands. In CSS, and here, it begins a
    // line of its own: what is laid out has a break in place of the blank before it.
    { name: 'long-word', direction: 'ltr', fonts: ['inter'], widths: [4, 5, 6, 8, 11],
      text: 'A Donaudampfschifffahrtsgesellschaft of 1829,\nas its captain said.', laid: ['A D', 'A\nD'] },
    { name: 'arabic', direction: 'rtl', fonts: ['amiri'], widths: [5, 7, 10, 14, 21],
      text: 'يولد جميع الناس أحراراً متساوين في الكرامة والحقوق، وقد وهبوا عقلاً وضميراً وعليهم أن يعامل بعضهم بعضاً بروح الإخاء 2024.' },
    { name: 'hebrew-in-english', direction: 'ltr', fonts: ['dejavu'], widths: [7, 10, 14, 19, 33],
      text: 'The sign read "שלום עולם, ברוכים הבאים לעיר (12 ק״מ)" and, at 10:30, we drove on to תל אביב with 3 maps.' },
    { name: 'english-in-hebrew', direction: 'rtl', fonts: ['dejavu'], widths: [7, 10, 14, 19, 33],
      text: 'הספר Text Layout (1998, 2nd edition) יצא לאור ב־12 במאי; המחבר כתב: "hello, עולם!" ואז שתק.' },
    { name: 'japanese', direction: 'ltr', fonts: ['sawarabi'], widths: [5, 7, 10, 14, 21],
      text: 'すべての人間は、生まれながらにして自由であり、「尊厳と権利」とについて平等である。コンピューターで2024年にABCを読む。' },
    { name: 'hindi', direction: 'ltr', fonts: ['lohit'], widths: [5, 7, 10, 14, 21],
      text: 'सभी मनुष्यों को गौरव और अधिकारों के मामले में जन्मजात स्वतन्त्रता और समानता प्राप्त है। हिन्दी क्षत्रिय स्त्री 12 कर्म।' },
    { name: 'mixed', direction: 'ltr', fonts: ['dejavu'], widths: [7, 10, 14, 19, 33],
      text: 'Greek λόγος, Russian слово, العربية word 15% כתב ¼ and καλημέρα — мир (سلام) שלום.' },
    { name: 'fallback', direction: 'ltr', fonts: ['inter', 'amiri', 'lohit', 'sawarabi'], widths: [6, 8, 11, 16, 27],
      text: 'Peace is سلام على الجميع, in Hindi शान्ति (12), in Japanese 平和、 and “мир” in Russian.' },
    { name: 'fallback-marks', direction: 'ltr', fonts: ['lohit', 'inter', 'amiri'], widths: [6, 8, 11, 16, 27],
      text: 'é ệ ģ naïve कि का́ café Ǻ ﷲ ل́ا 5 क‍ष x̂y (صَفْحَة 7) end.' },
];

const check = (condition, sentence) => { if (!condition) throw new Error(sentence); };
const px = (x) => String(Math.round(x * 1000) / 1000 + 0);
const fnv1a = (bytes) => {
    let h = 0xcbf29ce484222325n;
    for (const b of bytes) h = ((h ^ BigInt(b)) * 0x100000001b3n) & 0xffffffffffffffffn;
    return h.toString(16).padStart(16, '0');
};

const provider = CK.TypefaceFontProvider.Make();
const name_of = {};  // by the family's own name
for (const [name, path] of Object.entries(fonts)) {
    const bytes = readFileSync(join(folder, path));
    provider.registerFont(bytes, name);
    const family = CK.Typeface.MakeTypefaceFromData(new Uint8Array(bytes).buffer).getFamilyName();
    check(!(family in name_of), `two fonts are called ${family}`);
    name_of[family] = name;
    console.log('font', name, path, bytes.length, fnv1a(bytes));
}

function paragraph(t, align) {
    const style = new CK.ParagraphStyle({
        textAlign: { left: CK.TextAlign.Left, centre: CK.TextAlign.Center, justify: CK.TextAlign.Justify }[align],
        textDirection: t.direction === 'rtl' ? CK.TextDirection.RTL : CK.TextDirection.LTR,
        disableHinting: true,
        applyRoundingHack: false,
        textStyle: { fontFamilies: t.fonts, fontSize: em },
    });
    const builder = CK.ParagraphBuilder.MakeFromFontProvider(style, provider);
    builder.addText(t.laid ? t.text.replace(...t.laid) : t.text);
    return builder.build();
}

const bytes_before = (text, unit) => Buffer.byteLength(text.slice(0, unit));
const direction_of = (d) => (d.value === CK.TextDirection.RTL.value ? 'rtl' : 'ltr');

/// The lines, each with its runs of glyphs from left to right.
function lines_of(p, t) {
    const shaped = p.getShapedLines(), metrics = p.getLineMetrics();
    check(shaped.length === metrics.length, `${t.name}: ${shaped.length} lines of glyphs, ${metrics.length} lines`);
    return metrics.map((m, k) => ({
        first: bytes_before(t.text, m.startIndex),
        last: bytes_before(t.text, m.endIncludingNewline),
        left: m.left,
        runs: shaped[k].runs.map((r) => ({
            font: name_of[r.typeface.getFamilyName()],
            glyphs: [...r.glyphs].map((id, i) => ({ id, at: r.offsets[i], x: r.positions[2 * i] })),
        })),
    }));
}

function record_runs(line) {
    for (const r of line.runs) console.log('run', r.font, ...r.glyphs.map((g) => `${g.id}@${g.at}+${px(g.x - line.left)}`));
}

/// How much further right than in the left layout the glyphs of a line stand.
function record_spread(line, left) {
    const glyphs = line.runs.flatMap((r) => r.glyphs), before = left.runs.flatMap((r) => r.glyphs);
    const ids = (all) => all.map((g) => `${g.id}@${g.at}`).join();
    check(ids(glyphs) === ids(before), `other glyphs in the line ${line.first} to ${line.last}`);
    const changes = [];
    let spread = 0;
    glyphs.forEach((g, k) => {
        const here = g.x - line.left - (before[k].x - left.left);
        if (Math.abs(here - spread) > 1 / 256) changes.push(`${k}+${px(spread = here)}`);
    });
    if (changes.length > 0) console.log('spread', ...changes);
}

/// Ranges of whole graphemes, spread over the text: a long one, a short one, and one within a word.
function ranges_of(t) {
    const graphemes = [...new Intl.Segmenter('en', { granularity: 'grapheme' }).segment(t.text)].map((g) => g.index);
    const n = graphemes.length;
    return [[n / 5, (4 * n) / 5], [n / 3, n / 2], [n / 2, n / 2 + 2]].map((r) => r.map((k) => graphemes[Math.floor(k)]));
}

/// Boxes that touch, which SkParagraph cuts where a run ends, are one.
function record_boxes(p, t) {
    for (const [first, last] of ranges_of(t)) {
        const boxes = p.getRectsForRange(first, last, CK.RectHeightStyle.Max, CK.RectWidthStyle.Tight)
            .map(({ rect }) => ({ left: rect[0], right: rect[2], top: rect[1] }))
            .sort((a, b) => a.top - b.top || a.left - b.left);
        const joined = [];
        for (const b of boxes) {
            const before = joined.at(-1);
            if (before?.top === b.top && b.left - before.right < 1 / 256) before.right = b.right;
            else joined.push(b);
        }
        const lines = p.getLineMetrics();
        let line = lines.findIndex((l) => l.endIncludingNewline > first), top = joined[0].top;
        for (const b of joined) {
            if (b.top !== top) ++line;
            top = b.top;
            console.log('box', bytes_before(t.text, first), bytes_before(t.text, last), line, `${px(b.left)}~${px(b.right)}`);
        }
    }
}

function record_graphemes(p, t) {
    for (let at = 0; at < t.text.length;) {
        const g = p.getGlyphInfoAt(at);
        if (g === null) { ++at; continue; }
        const { start, end } = g.graphemeClusterTextRange;
        console.log('grapheme', bytes_before(t.text, start), bytes_before(t.text, end),
            `${px(g.graphemeLayoutBounds[0])}~${px(g.graphemeLayoutBounds[2])}`, direction_of(g.dir));
        at = Math.max(end, at + 1);
    }
}

function record_hits(p, t, width) {
    p.getLineMetrics().forEach((m, k) => {
        for (let x = -20; x < width * em + 40; x += 53) {
            const hit = p.getGlyphPositionAtCoordinate(x, m.baseline - 10);
            const up = hit.affinity.value === CK.Affinity.Upstream.value;
            console.log('hit', x, k, bytes_before(t.text, hit.pos), up ? 'up' : 'down');
        }
    });
}

for (const t of texts) {
    console.log('text', t.name, t.direction, ...t.fonts);
    console.log(t.text.replaceAll('\n', '\\n'));
    t.widths.forEach((width, k) => {
        let left = [];
        for (const align of ['left', 'centre', 'justify']) {
            const p = paragraph(t, align);
            p.layout(width * em);
            const lines = lines_of(p, t);
            console.log('layout', width, align);
            if (align === 'left') left = lines;
            lines.forEach((line, n) => {
                console.log('line', line.first, line.last, px(line.left));
                if (align === 'left') record_runs(line);
                else record_spread(line, left[n]);
            });
            record_boxes(p, t);
            if (k === 1 && align === 'left') record_graphemes(p, t);
            if (k === 1 && align === 'left') record_hits(p, t, width);
            p.delete();
        }
    });
}
