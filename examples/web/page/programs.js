// SPDX-License-Identifier: MIT
// The program for what is on the screen: in C++, as a command, in JavaScript. Each takes
// {text, options, file, others, weight, axis, advance}: options without those at their defaults, files of fonts for what the first
// one lacks, advance of the longest line in em; and for JavaScript material: what three.js makes one of.

const number = n => Number(n.toFixed(6)).toString();
const real = n => /[.e]/.test(number(n)) ? number(n) : number(n) + ".0";
const float = n => real(n) + "f";
const quoted = text => JSON.stringify(text).replace(/\u00a0/g, "\\u00a0");
const degrees = 57.29577951308232;

/** {.a = 1, .b = 2} of what is not undefined. */
const braced = (fields, pad = "") => {
    const all = Object.entries(fields).filter(([, v]) => v !== undefined).map(([k, v]) => `.${k} = ${v}`);
    const line = `{${all.join(", ")}}`;
    return line.length < 100 ? line : `{${all.join(",\n " + pad)}}`;
};
const tm = name => "typemesh::" + name;
const has = value => value !== undefined && value !== 0;
const bendOf = o => has(o.bend?.cylinder) ? "cylinder" : has(o.bend?.twist) ? "twist" : has(o.bend?.wave) ? "wave" : undefined;

/** How a text is bent, with the numbers that its width gives. */
function deformation({ options: o, advance }) {
    const kind = bendOf(o), width = advance || 1;
    if (kind === "cylinder") return { kind, type: tm("on_cylinder"), how: `{.radius = ${real(width * degrees / o.bend.cylinder)}}`, word: `cylinder:${number(width * degrees / o.bend.cylinder)}` };
    if (kind === "twist") return { kind, type: tm("twist"), how: `{.degrees_per_em = ${real(o.bend.twist / width)}, .across = 0.35}`, word: `twist:${number(o.bend.twist / width)}` };
    if (kind === "wave") return { kind, type: tm("displaced<typemesh::wave>"), how: `{{.height = ${real(o.bend.wave)}, .length = ${real(width)}}}`, word: `wave:${number(o.bend.wave)},${number(width)}` };
    return undefined;
}

/** The solid, and the headers that it needs. */
function solidOf(state) {
    const { options: o } = state, depth = o.depth ?? 0.2, bend = deformation(state), headers = [];
    if (has(o.inflate?.height)) {
        const solid = braced({ height: float(o.inflate.height) });
        return { code: `typemesh::inflated${solid}`, headers: ["typemesh/extrude/inflated.hpp"] };
    }
    if (has(o.tube?.radius)) return { code: `typemesh::tubed${braced({ radius: float(o.tube.radius) })}`, headers: ["typemesh/extrude/tubed.hpp"] };
    const bevelled = has(o.bevel?.width) && depth > 0, profile = o.bevel?.profile ?? "chamfer";
    const bevels = () => braced({
        depth: float(depth), width: float(o.bevel.width), bevel_depth: float(o.bevel.depth ?? o.bevel.width),
        sides: o.bevel.sides && tm(`bevel_sides::${o.bevel.sides}`),
        mode: o.bevel.mode && tm(`bevel_mode::${o.bevel.mode}`), outward: o.bevel.outward ? "true" : undefined,
        profile: profile === "chamfer" ? undefined : tm(`${profile}_profile()`) }, "        ");
    const normals = o.normals && !bevelled ? `<typemesh::${o.normals}_normals>` : "<>";
    let type = bevelled ? tm("bevelled") : depth > 0 ? tm("extruded" + normals) : tm("flat");
    let code = type + (bevelled ? bevels() : depth > 0 ? braced({ depth: float(depth) }) : "{}");
    if (bevelled) headers.push("typemesh/extrude/bevelled.hpp");
    if (bend) {
        code = `typemesh::bent<${bend.type}, ${type}>{\n        .solid = ${code},\n        .how = ${bend.how}}`;
        headers.push("typemesh/extrude/bent.hpp", `typemesh/bend/${bend.kind === "cylinder" ? "on_cylinder" : bend.kind}.hpp`, ...bend.kind === "wave" ? ["typemesh/bend/displaced.hpp"] : []);
    } else if (has(o.outline?.width)) {
        code = `typemesh::outlined<${type}>{\n        .width = ${float(o.outline.width)}, .place = typemesh::outline_place::inner,\n        .ring = ${code}}`;
        headers.push("typemesh/extrude/outlined.hpp");
    }
    return { code, headers };
}

/** The path on which letters stand: lines of C++ that make `way`. */
function pathLines(o) {
    const { ring = 0, wave = 0 } = o.path ?? {};
    if (ring > 0) return [`way.circle({0.0, 0.0}, ${real(ring)});`];
    if (ring < 0) return [`way.move({0.0, ${real(-ring)}});`, "way.arc({0.0, 0.0}, 360.0);", "way.close();"];
    if (wave === 0) return undefined;
    return ["way.move({-48.0, 0.0});", "for (int i = -16; i < 16; ++i)",
            `    way.quadratic({(i + 0.5) * 3.0, i % 2 == 0 ? ${real(2 * wave)} : ${real(-2 * wave)}}, {(i + 1) * 3.0, 0.0});`];
}

const directions = { ltr: "left_to_right", rtl: "right_to_left", ttb: "top_to_bottom" };

/** What all C++ programs begin and end with. */
function cppFrame({ text, file, others = [], weight }, headers, body) {
    const opened = (name, number, file, how = "") => [`    auto ${name} = typemesh::harfbuzz_font::open(argc > ${number} ? argv[${number}] : ${quoted(file)}${how});`,
        `    if (!${name}) return std::puts(${name}.error().message()), 1;`];
    const open = weight === undefined ? opened("font", 1, file)
        : [`    const typemesh::variation axes[] = {{"wght", ${float(weight)}}};`, ...opened("font", 1, file, ", {.face = 0, .variations = axes}")];
    others.forEach((other, i) => open.push(...opened(`font${i + 2}`, i + 2, other)));
    if (others.length) open.push(`    typemesh::font_cascade fonts{*font, ${others.map((_, i) => `*font${i + 2}`).join(", ")}};`), headers.push("typemesh/text/font_cascade.hpp");
    return [
        "// g++ -std=c++20 -O2 -Itypemesh/include text.cpp $(pkg-config --cflags --libs harfbuzz) -o text && ./text FONT",
        ...["typemesh/adapt/harfbuzz.hpp", "typemesh/typemesh.hpp", ...headers].filter((h, i, all) => all.indexOf(h) === i).map(h => `#include <${h}>`),
        "#include <cstdio>", "#include <vector>", "",
        "int main(int argc, char** argv)", "{", ...open, "",
        `    const char* const text = ${quoted(text)};`,
        "    std::vector<typemesh::vec3> vertices;  // or a vertex type of your own", "    std::vector<std::uint32_t> indices;",
        ...body.map(line => line && "    " + line),
        '    std::printf("%zu vertices, %zu triangles\\n", vertices.size(), indices.size() / 3);', "}", ""].join("\n");
}

const featuresOf = o => Object.entries(o.features ?? {});
const featureLines = o => featuresOf(o).length === 0 ? [] :
    [`const typemesh::feature features[] = {${featuresOf(o).map(([tag, v]) => `{${quoted(tag)}, ${Number(v)}}`).join(", ")}};`];

/** What a text and a morph have in common, as lines that set `how`. */
function commonLines(o) {
    const all = {
        "shape.direction": directions[o.direction] && tm(`direction::${directions[o.direction]}`),
        "shape.language": o.language && quoted(o.language),
        "shape.letter_spacing": has(o.letterSpacing) ? real(o.letterSpacing) : undefined,
        "shape.features": featuresOf(o).length ? "features" : undefined,
        "layout.align": o.align && tm(`alignment::${o.align}`),
        "layout.line_spacing": o.lineSpacing === undefined ? undefined : real(o.lineSpacing),
        tolerance: o.quality && tm(`quality::${o.quality}`),
        size: has(o.size) && o.size !== 1 ? real(o.size) : undefined,
    };
    return Object.entries(all).filter(([, value]) => value !== undefined).map(([name, value]) => `how.${name} = ${value};`);
}

export function cpp(state) {
    const { options: o, axis } = state, font = state.others?.length ? "fonts" : "*font";
    if (axis) return cppMorph(state);
    const { code, headers } = solidOf(state), body = [], policies = [];
    const way = pathLines(o), warp = has(o.warp?.arc) ? `typemesh::arc{.degrees = ${real(o.warp.arc)}}` : has(o.warp?.flag) ? `typemesh::flag{.height = ${real(o.warp.flag)}}` : undefined;
    if (way) body.push("typemesh::plane_path way;", ...way), headers.push("typemesh/text/on_path.hpp", "typemesh/bend/plane_path.hpp"), policies.push("typemesh::on_path{&way, {.anchor = typemesh::path_anchor::middle}}");
    if (warp) policies.push(`typemesh::warped{${warp}}`), headers.push("typemesh/bend/warped.hpp", `typemesh/bend/${has(o.warp.arc) ? "arc" : "flag"}.hpp`);
    if (has(o.embolden)) policies.push(`typemesh::embolden{.by = ${float(o.embolden)}}`), headers.push("typemesh/extrude/embolden.hpp");
    if (o.triangulator === "delaunay") policies.push("typemesh::constrained_delaunay{}");
    if (o.discretiser === "two_lines") policies.push("typemesh::two_lines{}");
    body.push("typemesh::text_mesher mesher{", `    ${font}, ${[code, ...policies].join(",\n        ")}};`, "");
    const features = featureLines(o);
    body.push(...features);
    const isPage = has(o.width) || o.markup;
    if (o.markup) {
        headers.push("typemesh/markup/markup_styles.hpp");
        body.push("typemesh::markup tags;", "typemesh::markup_styles styles;  // styles.paints() has the colours; [b], [depth], [bevel], [mark] are solids of their own",
                  "if (auto read = tags.read(std::string_view{text}); !read) return std::puts(read.error().message()), 1;",
                  "if (auto set = styles.set(tags); !set) return std::puts(set.error().message()), 1;");
    }
    const set = (name, value) => value === undefined || body.push(`how.${name} = ${value};`);
    body.push("typemesh::text_options how;", ...commonLines(o));
    if (o.markup) set("shape.styles", "styles.spans()"), set("shape.boxes", "tags.boxes()");
    set("layout.width", has(o.width) ? real(o.width) : undefined);
    if (has(o.width)) set("layout.wrap", o.wrap && tm(`wrap_mode::${o.wrap}`));
    set("fill", o.fill && tm(`fill_rule::${o.fill}`));
    set("merge", o.merge ? "true" : undefined);
    if (isPage) {
        headers.push("typemesh/paragraph/paragraph.hpp");
        const even = o.breaker === "total_fit" ? ", typemesh::heap(), typemesh::unicode_analyser{}, typemesh::total_fit{.emergency_stretch = 0.5}" : "";
        if (even) headers.push("typemesh/paragraph/total_fit.hpp");
        body.push("", `typemesh::paragraph words{${font}${even}};`, "typemesh::glyph_run page;",
                  `if (auto set = words.set(${o.markup ? "tags.text()" : "text"}, how.shape); !set) return std::puts(set.error().message()), 1;`,
                  "if (auto done = words.lay_out(how.layout, page); !done) return std::puts(done.error().message()), 1;");
    }
    body.push("", `auto made = mesher.build(${isPage ? "page" : "text"}, typemesh::into(vertices, indices), how);`,
              "if (!made) return std::puts(made.error().message()), 1;");
    return cppFrame(state, headers, body);
}

function cppMorph(state) {
    const { options: o, axis } = state;
    const headers = ["typemesh/adapt/harfbuzz_axis.hpp", "typemesh/morph/axis_morph.hpp", "typemesh/vertex/array_sink.hpp"];
    if (o.markup) headers.push("typemesh/markup/markup.hpp");
    return cppFrame({ ...state, others: [], weight: undefined }, headers, [
        ...o.markup ? ["typemesh::markup tags;  // a morph takes the letters without what tags say of them",
                       "if (auto read = tags.read(std::string_view{text}); !read) return std::puts(read.error().message()), 1;"] : [],
        'auto weight = typemesh::harfbuzz_axis::open(*font, "wght");',
        "if (!weight) return std::puts(weight.error().message()), 1;",
        ...featureLines(o), "typemesh::morph_options how;", `how.depth = ${float(o.depth ?? 0.2)};`, ...commonLines(o), "",
        "typemesh::axis_morph morph{*weight};", `auto plan = morph.plan(${o.markup ? "tags.text()" : "text"}, how);`,
        "if (!plan) return std::puts(plan.error().message()), 1;", "",
        `for (double value = ${real(axis.minimum)}; value <= ${real(axis.maximum)}; value += 5.0) {  // one mesh a frame; the triangles stay`,
        "    const auto at = weight->coordinate(value);", "    const auto size = plan->size(plan->section_at(at));",
        "    vertices.resize(size.vertices);", "    indices.resize(size.indices());",
        "    if (!plan->write_at(at, typemesh::into(std::span{vertices}, std::span{indices}))) return 1;", "}"]);
}

/** For a shell. */
const shell = word => /^[\w.,:=/%+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;

/** A text without its tags, which have been read before: they are right. */
const untagged = text => text.replace(/\[\[|\[[^\]]*\]/g, found => found === "[[" ? "[" : "");

/** Whether text_to_mesh would take a text for an option or a file, or change it: it then reads it from a pipe. */
const isSpecial = text => /^\\?[-@]/.test(text) || text.includes("\\n");

export function command(state) {
    const { options: o, file, weight, axis } = state;
    const text = axis && o.markup ? untagged(state.text) : state.text, special = isSpecial(text);  // --morph reads no tags
    const words = ["text_to_mesh", ...special ? ["--text-file", "-"] : [text], "--font", file];
    if (!axis) for (const other of state.others ?? []) words.push("--fallback", other);
    const add = (option, value) => { if (value !== undefined) words.push(option, String(value)); };
    const some = v => has(v) ? number(v) : undefined;
    const addForm = () => {
        add("--embolden", some(o.embolden));
        add("--outline", some(o.outline?.width));
        add("--inflate", some(o.inflate?.height));
        add("--tube", some(o.tube?.radius));
        add("--bend", deformation(state)?.word ?? (has(o.warp?.arc) ? `arc:${number(o.warp.arc)}` : has(o.warp?.flag) ? `flag:${number(o.warp.flag)},${number(state.advance || 1)}` : undefined));
        if (has(o.path?.ring)) add("--path", `circle:${number(o.path.ring)}`);
        if (has(o.path?.wave)) add("--path", `wave:${number(o.path.wave)},6`);
    };
    if (axis) add("--morph", `wght=${axis.minimum}..${axis.maximum}`);
    else if (weight !== undefined) add("--variation", `wght=${weight}`);
    if (o.markup && !axis) words.push("--markup");
    add("--depth", o.depth === undefined ? undefined : number(o.depth));
    if (!axis && has(o.bevel?.width) && o.depth !== 0) {
        add("--bevel", number(o.bevel.width));
        if (o.bevel.depth !== undefined && o.bevel.depth !== o.bevel.width) add("--bevel-depth", number(o.bevel.depth));
        add("--profile", o.bevel.profile);
        add("--bevel-mode", o.bevel.mode);
        add("--bevel-sides", o.bevel.sides);
        if (o.bevel.outward) words.push("--bevel-out");
    }
    if (!axis) addForm();
    add("--letter-spacing", o.letterSpacing === undefined ? undefined : number(o.letterSpacing));
    if (!axis) add("--width", some(o.width));
    add("--align", o.align);
    add("--line-spacing", o.lineSpacing === undefined ? undefined : number(o.lineSpacing));
    if (!axis && has(o.width)) add("--wrap", { word_or_grapheme: "break", grapheme: "letter" }[o.wrap] ?? o.wrap), add("--breaker", o.breaker);
    add("--direction", o.direction);
    for (const [tag, v] of Object.entries(o.features ?? {})) add("--feature", `${tag}=${Number(v)}`);
    add("--language", o.language);
    add("--size", o.size);
    add("--quality", o.quality);
    if (!axis) for (const name of ["discretiser", "triangulator", "fill", "normals", "uv"]) add("--" + name, o[name]);
    if (!axis && o.merge !== undefined) words.push(o.merge ? "--merge" : "--no-merge");
    words.push("-o", "text.glb");
    return (special ? `printf %s ${shell(text)} | ` : "") + words.map(shell).join(" ") + "\n";
}

export function javascript({ text, options, file, others = [], weight, axis, material = {} }) {
    const how = weight === undefined || axis ? "" : `, { variations: { wght: ${weight} } }`, fonts = others.length && !axis ? "fonts" : "font";
    const shown = JSON.stringify(options, null, 4).replace(/"(\w+)":/g, "$1:");
    const show = ["const geometry = new THREE.BufferGeometry();", 'geometry.setAttribute("position", new THREE.BufferAttribute(mesh.position.slice(), 3));',
                  'geometry.setAttribute("normal", new THREE.BufferAttribute(mesh.normal.slice(), 3));', "geometry.setIndex(new THREE.BufferAttribute(mesh.index.slice(), 1));"];
    show.push("", `const letters = new THREE.Mesh(geometry, new THREE.MeshPhysicalMaterial(${JSON.stringify(material).replace(/"(\w+)":/g, " $1: ").replace("}", " }")}));`,
              "// scene.add(letters); metals want a scene.environment, which they mirror.");
    return ["// npm install three, and typemesh's own package: examples/web/package", 'import * as THREE from "three";', 'import load from "typemesh";', "", "const typemesh = await load();",
            "const bytesOf = async file => (await fetch(file)).arrayBuffer();", `const font = typemesh.font(await bytesOf(${quoted(file)})${how});`,
            ...fonts === "fonts" ? [`const fonts = [font, ...await Promise.all([${others.map(quoted).join(", ")}].map(bytesOf))];`] : [],
            ...axis ? [`const morph = typemesh.mesher(font).morph(${quoted(text)}, "wght", ${shown});`, `const mesh = morph.at(${axis.maximum});  // each frame another weight`]
                    : [`const mesh = typemesh.mesh(${quoted(text)}, ${fonts}, ${shown});`],
            "", ...show, ""].join("\n");
}

export const programs = { cpp, command, javascript };
