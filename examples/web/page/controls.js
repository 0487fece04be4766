// SPDX-License-Identifier: MIT
// The panel's controls, their values, and the link that holds them.

import { finishes } from "./looks.js";

// name: the name of the mesher's option, "bevel.width" for {bevel: {width}}; or a name of the page itself, after "page."
// choices: [value, words] each, the start first
const range = (name, label, start, low, high, step, unit = "") => ({ kind: "range", name, label, start, low, high, step, unit });
const choice = (name, label, ...choices) => ({ kind: "choice", name, label, start: choices[0][0], choices });
const check = (name, label, start) => ({ kind: "check", name, label, start });
const words = (name, label, start, hint) => ({ kind: "words", name, label, start, hint });

export const groups = [
    { title: "Look", open: true, controls: [
        choice("page.finish", "Made of", ["satin", "satin plastic"], ["gloss", "glossy plastic"], ["foil", "foil"], ["chrome", "chrome"], ["gold", "gold"], ["lacquer", "lacquer"], ["neon", "neon light"]),
        { kind: "colour", name: "page.colour", label: "Colour", start: "" },
        check("page.rainbow", "Each letter its own colour", false),
        choice("page.world", "Surroundings", ["auto", "as the page"], ["light", "light studio"], ["dark", "dark studio"], ["dusk", "dusk"], ["night", "night"]),
        choice("page.motion", "Letters", ["still", "stand still"], ["wave", "wave"], ["reveal", "grow one by one"], ["scatter", "fly apart and back"], ["typewriter", "are typed"],
            ["flag", "fly like a flag"], ["score", "roll up to a number"], ["breathe", "breathe in weight"]),
    ] },
    { title: "Letters", open: true, controls: [
        range("page.weight", "Weight", 800, 100, 900, 5),
        range("depth", "Depth", 0.2, 0, 1, 0.01),
        range("embolden", "Thicker strokes", 0, -0.05, 0.1, 0.002),
        range("outline.width", "Hollow: wall", 0, 0, 0.08, 0.002),
        range("inflate.height", "Inflate", 0, 0, 2, 0.05),
        range("tube.radius", "Outline tubes", 0, 0, 0.06, 0.002),
        range("letterSpacing", "Space between", 0, -0.1, 0.5, 0.01),
    ] },
    { title: "Edges", open: true, controls: [
        range("bevel.width", "Bevel", 0.03, 0, 0.12, 0.002),
        choice("bevel.profile", "Its form", ["round", "round"], ["chamfer", "flat"], ["concave", "hollowed out"], ["stepped", "steps"], ["engraved", "engraved"]),
        choice("bevel.mode", "Thin strokes", ["clip", "end in a ridge"], ["fit", "get a narrower bevel, each letter"], ["fit_text", "get a narrower bevel, all letters"]),
        choice("bevel.sides", "Bevels on", ["both", "both faces"], ["front", "the front"], ["back", "the back"]),
        check("bevel.outward", "Letters grow by the bevel", false),
    ] },
    { title: "Bend and lay out", open: false, controls: [
        range("bend.cylinder", "Round a column", 0, -360, 360, 10, "°"),
        range("bend.twist", "Twist", 0, -360, 360, 10, "°"),
        range("bend.wave", "Curtain", 0, 0, 1, 0.02),
        range("warp.arc", "Arc", 0, -180, 180, 5, "°"),
        range("warp.flag", "Pennant", 0, 0, 0.5, 0.01),
        range("path.ring", "On a ring", 0, -8, 8, 0.25),
        range("path.wave", "On waves", 0, 0, 1, 0.05),
    ] },
    { title: "Lines and languages", open: false, controls: [
        range("width", "Lines at most", 0, 0, 40, 0.5, " em"),
        range("lineSpacing", "Line spacing", 1, 0.5, 2, 0.05),
        choice("align", "Lines stand", ["centre", "in the middle"], ["start", "at their start"], ["end", "at their end"], ["left", "left"], ["right", "right"], ["justify", "stretched to the width"]),
        choice("wrap", "Lines end", ["word_or_grapheme", "after words, else letters"], ["word", "only after words"], ["grapheme", "after any letter"], ["none", "only where I say"]),
        choice("breaker", "Line ends are", ["first_fit", "chosen one by one"], ["total_fit", "chosen for even lines"]),
        choice("direction", "Text runs", ["automatic", "as its script does"], ["ltr", "to the right"], ["rtl", "to the left"], ["ttb", "down, in columns"]),
        words("features", "Font features", "", "smcp, liga=0"),
        words("language", "Language", "", "tr, zh-Hant"),
        check("page.tags", "Tags such as [b] are read", true),
    ] },
    { title: "How the mesh is made", open: false, controls: [
        range("size", "Size", 1, 0.1, 4, 0.05),
        choice("quality", "Curves are", ["high", "fine"], ["low", "coarse"], ["normal", "medium"], ["best", "finest"]),
        choice("discretiser", "Flattening", ["certified", "proven"], ["two_lines", "two lines a curve"], ["adaptive", "adaptive"]),
        choice("triangulator", "Triangles", ["monotone", "made fast"], ["delaunay", "not slender (Delaunay)"]),
        choice("fill", "Crossing outlines", ["font", "as the font says"], ["non_zero", "filled"], ["even_odd", "filled in turns"]),
        choice("normals", "Walls are shaded", ["curve", "as the curve"], ["creased", "with creases"], ["averaged", "averaged"], ["shared", "all smooth"], ["cap", "as the caps"]),
        choice("uv", "Texture runs", ["em", "along the faces"], ["box", "over the whole text"], ["cylindrical", "round each edge"]),
        check("merge", "Letters that meet are one", true),
    ] },
];

const all = groups.flatMap(g => g.controls);

// Of each of these sets one control at a time is not 0: moving one sets the others back.
const bends = ["bend.cylinder", "bend.twist", "bend.wave"];
const rivals = [
    { names: [...bends, "inflate.height", "tube.radius"], words: "Letters are bent, twisted, waved, inflated or tubes" },
    { names: ["warp.arc", "warp.flag", "path.ring", "path.wave"], words: "Letters stand on an arc, a flag, a ring or a wave" },
];
// What has no effect while one of `by` is not 0, and what is said if it would have had one.
const idle = [
    { by: ["inflate.height"], name: "depth", words: "" },
    { by: ["inflate.height"], name: "bevel", words: "Inflated letters have no bevels." },
    { by: ["inflate.height"], name: "outline.width", words: "Inflated letters are not hollow." },
    { by: ["inflate.height"], name: "normals", words: "" },
    { by: ["tube.radius"], name: "depth", words: "" },
    { by: ["tube.radius"], name: "bevel", words: "Tubes have no bevels." },
    { by: ["tube.radius"], name: "outline.width", words: "Tubes are not hollow." },
    { by: ["tube.radius"], name: "normals", words: "" },
    { by: bends, name: "outline.width", words: "Bent letters are not hollow." },
    { by: ["page.motion"], is: "breathe", name: "bevel", words: "A text that breathes has no bevels." },
];
const isOf = (name, group) => name === group || name.startsWith(group + ".");
const id = name => "option-" + name.replaceAll(".", "-");

export class Controls {
    /** Makes the controls in `into`, calls `changed` after each change. */
    constructor(into, changed) {
        this.values = Object.fromEntries(all.map(c => [c.name, c.start]));
        this.setBack = "";  // what the last change has set back, as a sentence
        for (const group of groups) {
            const details = into.appendChild(document.createElement("details"));
            details.open = group.open;
            details.appendChild(document.createElement("summary")).textContent = group.title;
            for (const c of group.controls) details.append(this.#row(c, changed));
        }
    }

    #row(c, changed) {
        const row = document.createElement("div");
        row.className = "row " + c.kind;
        const label = row.appendChild(document.createElement("label"));
        label.textContent = c.label;
        label.htmlFor = id(c.name);
        const input = row.appendChild(document.createElement(c.kind === "choice" ? "select" : "input"));
        input.id = id(c.name);
        if (c.kind === "choice") input.append(...c.choices.map(([v, words]) => new Option(words, v)));
        if (c.kind === "range") Object.assign(input, { type: "range", min: c.low, max: c.high, step: c.step });
        if (c.low < 0) row.append(this.#tick(c, input));  // on which the slider stops more easily
        if (c.kind === "check") input.type = "checkbox";
        if (c.kind === "colour") input.type = "color";
        if (c.kind === "words") Object.assign(input, { type: "text", placeholder: c.hint, spellcheck: false });
        if (c.kind === "range") {
            const output = row.appendChild(document.createElement("output"));
            output.htmlFor = input.id;
            output.setAttribute("aria-live", "off");  // the slider says it
        }
        input.addEventListener("input", () => {
            this.values[c.name] = c.kind === "check" ? input.checked : c.kind === "range" ? Number(input.value) : input.value;
            this.#yield(c);
            this.#show(c);
            if (c.name === "page.weight" && this.motion === "breathe") this.set("page.motion", "still");
            changed();
        });
        if (c.kind === "range") input.addEventListener("dblclick", () => {
            input.value = c.start;
            input.dispatchEvent(new Event("input"));
        });
        c.input = input;
        this.#show(c);
        return row;
    }

    /** A mark at the slider's start. */
    #tick(c, input) {
        const list = document.createElement("datalist");
        list.id = input.id + "-start";
        list.append(new Option("", c.start));
        input.setAttribute("list", list.id);
        return list;
    }

    /** Sets back what cannot be had together with a control. */
    #yield(c) {
        this.setBack = "";
        if (this.values[c.name] === c.start) return;
        for (const { names, words } of rivals.filter(r => r.names.includes(c.name)))
            for (const other of all.filter(o => o !== c && names.includes(o.name) && this.values[o.name] !== o.start)) {
                this.values[other.name] = other.start;
                this.#show(other);
                this.setBack = `${words}, so ${other.label} is 0 again.`;
            }
    }

    #holds(i) { return i.by.some(name => i.is ? this.values[name] === i.is : this.values[name] !== 0); }
    #isIdle(c) { return idle.some(i => isOf(c.name, i.name) && this.#holds(i)); }

    /** What the page is to say about the values: sentences. */
    notes() {
        const silent = idle.filter(i => i.words && this.#holds(i) &&
            this.values[i.name === "bevel" ? "bevel.width" : i.name] !== 0);
        return [this.setBack, ...silent.map(i => i.words)].filter(Boolean);
    }

    #show(c) {
        const value = this.values[c.name];
        if (c.kind === "check") c.input.checked = value;
        else if (c.kind === "colour") c.input.value = value || this.colour;
        else if (c.input.value !== String(value)) c.input.value = value;
        if (c.kind === "range") {
            const shown = c.name === "width" && value === 0 ? "as suits" : value + c.unit;
            c.input.parentNode.querySelector("output").value = shown;
            c.input.setAttribute("aria-valuetext", shown);
        }
        if (c.name === "page.finish") all.filter(o => o.kind === "colour" && o.input).forEach(o => { o.input.value = this.colour; });
        for (const o of all)
            if (o.input) o.input.disabled = this.#isIdle(o);
    }

    set(name, value) {
        const c = all.find(one => one.name === name);
        if (!c) return;
        if (c.kind === "range") {
            if (value === "" || !Number.isFinite(Number(value))) return;
            value = Math.min(c.high, Math.max(c.low, Number(value)));
        }
        if (c.kind === "check") value = value === true || ["1", "true"].includes(value);
        if (c.kind === "colour") value = value.toLowerCase();
        if (c.kind === "choice" && !c.choices.some(([v]) => v === value)) return;
        if (c.kind === "colour" && !/^(#[0-9a-f]{6})?$/.test(value)) return;
        this.values[name] = value;
        this.#yield(c);
        this.#show(c);
    }

    /** How letters move. */
    get motion() { return this.values["page.motion"]; }
    /** The chosen colour, or the usual one of what letters are made of. */
    get colour() { return this.values["page.colour"] || finishes[this.values["page.finish"]].colour; }
    /** As stage.dress() takes it. */
    get look() { return { finish: this.values["page.finish"], colour: this.values["page.colour"], world: this.values["page.world"] }; }

    /** The slider goes with a text that breathes; without a weight it shows its own. */
    showWeight(weight) {
        const { input } = all.find(one => one.name === "page.weight"), shown = Math.round(weight ?? this.values["page.weight"]);
        input.value = shown;
        input.setAttribute("aria-valuetext", shown);
        input.parentNode.querySelector("output").value = shown;
    }

    /** Only fonts with an axis have a slider for it. */
    setWeights(axis) {
        const c = all.find(one => one.name === "page.weight");
        c.input.closest(".row").hidden = !axis;
        if (axis) Object.assign(c.input, { min: axis.minimum, max: axis.maximum });
        this.#show(c);
    }

    reset() {
        for (const c of all) this.set(c.name, c.start);
    }

    /** As typemesh.mesh() takes them. */
    options(text = "") {
        const made = {};
        if (this.values["page.tags"] && /\[[a-z/[]/.test(text)) made.markup = true;
        for (const c of all) {
            const value = this.values[c.name];
            if (c.name.startsWith("page.")) continue;
            if (this.#isIdle(c) || (c.name === "width" ? value === 0 : c.kind === "words" && value.trim() === "")) continue;
            const [first, second] = c.name.split(".");
            const stored = c.name === "features" ? features(value) : value;
            if (second) (made[first] ??= {})[second] = stored;
            else made[first] = stored;
        }
        if (this.motion !== "still" || this.values["page.rainbow"]) made.letters = true;
        if (["wave", "reveal", "scatter", "score"].includes(this.motion)) made.merge = false;
        const suited = made.width ? 0 : this.#suitedWidth(text);
        if (suited > 0) made.width = suited;
        if (made.bevel) made.bevel.depth = Math.min(made.bevel.width, made.depth / 2);  // two of them are no deeper than the solid
        return made;
    }

    /** Where a long text ends its lines, unless something says so: about twice as wide as all lines are high. 0: nowhere. */
    #suitedWidth(text) {
        const { direction, wrap } = this.values;
        if (!/[^\n]{49}/.test(text) || direction === "ttb" || wrap === "none" || ["breathe", "score"].includes(this.motion)) return 0;
        if ([...bends, "warp.arc", "warp.flag", "path.ring", "path.wave"].some(name => this.values[name] !== 0)) return 0;
        return Math.round(Math.max(12, 1.4 * Math.sqrt(text.length)));
    }

    /** What differs from the start, for a link. */
    changes() {
        return all.filter(c => this.values[c.name] !== c.start)
            .map(c => [c.name, c.kind === "check" ? (this.values[c.name] ? "1" : "0") : String(this.values[c.name])]);
    }
}

/** "smcp, liga=0" as {smcp: 1, liga: 0}. */
function features(text) {
    const made = {};
    for (const one of text.split(/[\s,]+/).filter(Boolean)) {
        const [tag, value] = one.split("=");
        made[tag] = value === undefined ? 1 : Number(value);
    }
    return made;
}
