// SPDX-License-Identifier: MIT
// The panel's controls, their values, and the link that holds them.

// name: the name of the mesher's option, "bevel.width" for {bevel: {width}}; or a name of the page itself, after "page."
const range = (name, label, start, low, high, step, unit = "") => ({ kind: "range", name, label, start, low, high, step, unit });
const choice = (name, label, ...choices) => ({ kind: "choice", name, label, start: choices[0], choices });
const check = (name, label, start) => ({ kind: "check", name, label, start });
const words = (name, label, start, hint) => ({ kind: "words", name, label, start, hint });

export const groups = [
    { title: "Solid", open: true, controls: [
        range("depth", "Depth", 0.2, 0, 1, 0.01),
        range("bevel.width", "Bevel", 0.02, 0, 0.12, 0.002),
        choice("bevel.profile", "Profile", "chamfer", "round", "concave", "stepped", "engraved"),
        choice("bevel.mode", "Thin strokes", "clip", "fit", "fit_text"),
        choice("bevel.sides", "Bevels on", "both", "front", "back"),
        check("bevel.outward", "Put on outside", false),
        range("embolden", "Bolder", 0, -0.05, 0.1, 0.002),
        range("outline.width", "Hollow", 0, 0, 0.08, 0.002),
    ] },
    { title: "Shape", open: true, controls: [
        range("bend.cylinder", "Bend", 0, -360, 360, 10, "°"),
        range("bend.twist", "Twist", 0, -360, 360, 10, "°"),
        range("bend.wave", "Wave", 0, 0, 1, 0.02),
        range("warp.arc", "Arc", 0, -180, 180, 5, "°"),
        range("warp.flag", "Flag", 0, 0, 0.5, 0.01),
        range("path.ring", "Ring", 0, -8, 8, 0.25),
        range("path.wave", "Path wave", 0, 0, 1, 0.05),
        range("inflate.height", "Inflate", 0, 0, 2, 0.05),
    ] },
    { title: "Motion", open: true, controls: [
        choice("page.motion", "Letters", "still", "wave", "reveal", "scatter", "typewriter"),
    ] },
    { title: "Lines", open: true, controls: [
        range("width", "Width", 0, 0, 40, 0.5),
        choice("align", "Align", "centre", "start", "end", "left", "right", "justify"),
        choice("wrap", "Wrap", "word_or_grapheme", "word", "grapheme", "none"),
        choice("breaker", "Break lines", "first_fit", "total_fit"),
        choice("direction", "Direction", "automatic", "ltr", "rtl", "ttb"),
        range("letterSpacing", "Letter spacing", 0, -0.1, 0.5, 0.01),
        words("features", "Features", "", "smcp, liga=0"),
        words("language", "Language", "", "tr, zh-Hant"),
    ] },
    { title: "How it is made", open: false, controls: [
        range("size", "Size", 1, 0.1, 4, 0.05),
        choice("quality", "Quality", "high", "low", "normal", "best"),
        choice("discretiser", "Flattening", "certified", "two_lines", "adaptive"),
        choice("triangulator", "Triangles", "monotone", "delaunay"),
        choice("fill", "Fill rule", "font", "non_zero", "even_odd"),
        choice("normals", "Wall normals", "curve", "creased", "averaged", "shared", "cap"),
        choice("uv", "Texture", "em", "box", "cylindrical"),
        check("merge", "Merge letters", true),
    ] },
];

const all = groups.flatMap(g => g.controls);

// Of each of these sets one control at a time is not 0: moving one sets the others back.
const bends = ["bend.cylinder", "bend.twist", "bend.wave"];
const rivals = [
    { names: [...bends, "inflate.height"], words: "Letters are bent, twisted, waved or inflated" },
    { names: ["warp.arc", "warp.flag", "path.ring", "path.wave"], words: "Letters stand on an arc, a flag, a ring or a wave" },
];
// What has no effect while one of `by` is not 0, and what is said if it would have had one.
const idle = [
    { by: ["inflate.height"], name: "depth", words: "" },
    { by: ["inflate.height"], name: "bevel", words: "Inflated letters have no bevels." },
    { by: ["inflate.height"], name: "outline.width", words: "Inflated letters are not hollow." },
    { by: ["inflate.height"], name: "normals", words: "" },
    { by: bends, name: "outline.width", words: "Bent letters are not hollow." },
];
const isOf = (name, group) => name === group || name.startsWith(group + ".");
const shown = word => word.replaceAll("_", " ");
const id = name => "option-" + name.replace(".", "-");

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
        if (c.kind === "choice") input.append(...c.choices.map(v => new Option(shown(v), v)));
        if (c.kind === "range") Object.assign(input, { type: "range", min: c.low, max: c.high, step: c.step });
        if (c.low < 0) row.append(this.#tick(c, input));  // on which the slider stops more easily
        if (c.kind === "check") input.type = "checkbox";
        if (c.kind === "words") Object.assign(input, { type: "text", placeholder: c.hint, spellcheck: false });
        if (c.kind === "range") row.appendChild(document.createElement("output")).htmlFor = input.id;
        input.addEventListener("input", () => {
            this.values[c.name] = c.kind === "check" ? input.checked : c.kind === "range" ? Number(input.value) : input.value;
            this.#yield(c);
            this.#show(c);
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

    #isIdle(c) { return idle.some(i => isOf(c.name, i.name) && i.by.some(name => this.values[name] !== 0)); }

    /** What the page is to say about the values: sentences. */
    notes() {
        const silent = idle.filter(i => i.words && i.by.some(name => this.values[name] !== 0) &&
            this.values[i.name === "bevel" ? "bevel.width" : i.name] !== 0);
        return [this.setBack, ...silent.map(i => i.words)].filter(Boolean);
    }

    #show(c) {
        const value = this.values[c.name];
        if (c.kind === "check") c.input.checked = value;
        else if (c.input.value !== String(value)) c.input.value = value;
        if (c.kind === "range") {
            const shown = c.name === "width" && value === 0 ? "any" : value + c.unit;
            c.input.parentNode.querySelector("output").value = shown;
            c.input.setAttribute("aria-valuetext", shown);
        }
        for (const o of all)
            if (o.input) o.input.disabled = this.#isIdle(o);
    }

    set(name, value) {
        const c = all.find(one => one.name === name);
        if (!c) return;
        if (c.kind === "range") value = Math.min(c.high, Math.max(c.low, Number(value) || 0));
        if (c.kind === "check") value = value === true || value === "1";
        if (c.kind === "choice" && !c.choices.includes(value)) return;
        this.values[name] = value;
        this.#yield(c);
        this.#show(c);
    }

    /** How letters move. */
    get motion() { return this.values["page.motion"]; }

    reset() {
        for (const c of all) this.set(c.name, c.start);
    }

    /** As typemesh.mesh() takes them. */
    options() {
        const made = {};
        for (const c of all) {
            const value = this.values[c.name];
            if (c.name.startsWith("page.")) continue;
            if (this.#isIdle(c) || (c.name === "width" ? value === 0 : c.kind === "words" && value.trim() === "")) continue;
            const [first, second] = c.name.split(".");
            const stored = c.name === "features" ? features(value) : value;
            if (second) (made[first] ??= {})[second] = stored;
            else made[first] = stored;
        }
        if (this.motion !== "still") made.letters = true;
        if (made.bevel) made.bevel.depth = Math.min(made.bevel.width, made.depth / 2);  // two of them are no deeper than the solid
        return made;
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
