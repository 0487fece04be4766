// SPDX-License-Identifier: MIT

// node sizes.mjs TYPEMESH.WASM      rows of the table of sizes, of a module linked with --profiling-funcs; see measure.sh
//
// What is inlined counts as part of what it is inlined into.

import { readFileSync } from 'node:fs';

const features = [ // the first that fits
    ['HarfBuzz: shaping, outlines of fonts', /^(void |bool |int |unsigned int )?_?(hb_|OT::|AAT::|CFF::|_hb|arabic_|collect_features_|setup_|data_create_|compose_|decompose_|preprocess_text|reorder|initial_reordering|final_reordering|get_(path|bounds)|_get_|hb_ot|find_syllables|override_|unicode_to_)|hb_|OT::|CFF::|_path_procs|_extents_/],
    ['Allocation, sorting and the like of the C and C++ libraries', /^(dl|std::__2::(__sort|__insertion|vector|basic_string)|str|mem|__|fmt_|pop_arg|printf|pad|sn?printf|vsn|malloc|free|operator |dispose|sys|wasi|emscripten|scalbn|fmod|atan|acos|cos|sin|cbrt|pow|exp|log|fopen|fwrite|wc)/],
    ['Tags', /markup|marked_words|ruby|highlight/],
    ['A text that breathes', /morph|harfbuzz_axis/],
    ['Text on a path, letters of vertices', /on_path|plane_path|path_walk|path_place|letter_row|text_letter|name_letters/],
    ['Bent, warped and inflated letters', /bent_surface|bent_caps|edge_bisection|curve_warper|warped<|membrane::|inflated_(corners|surface)::/],
    ['Bold and hollow letters', /embolden|outlined|boundary_mover|reflex_joins|inner_solid|cell_outlines|ring_cutter/],
    ['Bevels', /bevel|profile|sweep_inwards|inward_sweep|wavefront|kinetic|collapse|swept|moving_point|offset/],
    ['Paragraphs', /paragraph|line_(justifier|cut|pieces)|elision|text_pieces|total_fit|first_fit|best_lines/],
    ['Directions, line breaks, scripts', /unicode|bidi|grapheme|script|line_opportunities|text_analys|hyphen|visual_order/],
    ['Layout, fallback of fonts', /layout|shap|text_lines|line_(slices|writer|room|extent)|style_spans|bar_writer|stack_lines|laid_|item_glyph_style|item_settings|font_list|fallback|harfbuzz|column|glyph_run|glyph_style/],
    ['Merged letters, contours that cross', /resolv|cross|snap|arrangement|region_union|merger|merged|intersect|hot_pixel|fill|nest|touching|orient/],
    ['Delaunay triangles', /delaunay|flip|half_edges|in_circle|trapezoid|point_star/],
    ['Flattening', /discretis|certified|chord|flatten|subdivision|two_lines|hodograph|share_table|curve_emitter/],
    ['Monotone triangles', /monotone|chain|low_triangles|raise_low|coarse_loops|triangle_heights|sweep/],
    ['Walls, caps, normals, writing', /extruded|normals|write_|upright_walls|axes|place|arrange|stream|one_of/],
    ['The face: options, checks, exports', /web_|typemesh_web|settings|inspect|weld|closedness/],
    ['The rest of the mesher', /typemesh|text_to_mesh/],
];

const bytes = readFileSync(process.argv[2]);
let at = 8;
const number = () => {
    for (let value = 0, shift = 0; ; shift += 7) {
        const byte = bytes[at++];
        value += (byte & 127) * 2 ** shift;
        if (byte < 128) return value;
    }
};
const text = () => {
    const size = number();
    return bytes.toString('utf8', (at += size) - size, at);
};
let imported = 0;
let data = 0;
const sizes = [];
const names = new Map();
while (at < bytes.length) {
    const section = bytes[at++];
    const size = number();
    const end = at + size;
    if (section === 2)
        for (let left = number(); left > 0; --left) {
            text(), text();
            if (bytes[at++] !== 0) throw new Error('a function was expected among the imports');
            number(), ++imported;
        }
    if (section === 10)
        for (let left = number(); left > 0; --left) {
            const body = number();
            sizes.push(body);
            at += body;
        }
    if (section === 11) data = size;
    if (section === 0 && text() === 'name')
        while (at < end) {
            const kind = bytes[at++];
            const after = number() + at;
            if (kind === 1) for (let left = number(); left > 0; --left) names.set(number(), text());
            at = after;
        }
    at = end;
}
const sums = new Map([...features.map(([name]) => [name, 0]), ['Other functions', 0]]);
sizes.forEach((size, i) => {
    const name = names.get(i + imported) ?? '';
    const feature = features.find(([, pattern]) => pattern.test(name))?.[0] ?? 'Other functions';
    sums.set(feature, sums.get(feature) + size);
});
sums.set('Tables: Unicode, languages, kinds of shapers', data);
const all = sizes.reduce((a, b) => a + b, 0) + data;
console.log('| part | kB | of all |\n|---|---:|---:|');
for (const [name, size] of [...sums].sort(([, a], [, b]) => b - a))
    console.log(`| ${name} | ${(size / 1000).toFixed(0)} | ${((100 * size) / all).toFixed(0)} % |`);
