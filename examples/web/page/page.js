// SPDX-License-Identifier: MIT
// Text, fonts and settings in, a mesh on the stage: the page's one loop.

import load from "typemesh";
import { Controls } from "./controls.js";
import { Fonts, lettersOf } from "./fonts.js";
import { History } from "./history.js";
import { finishes } from "./looks.js";
import { lessMotion } from "./motion.js";
import { isSame, linkOf, presets } from "./presets.js";
import { programs } from "./programs.js";
import { materials, rainbowOf, Stage, views } from "./stage.js";

const at = id => document.getElementById(id);
const start = { text: "Hello world!", view: "solid" };  // and what controls.js has
const maxCharacters = 100000, maxInLink = 2000;  // the latter as they stand in an address
const stage = openStage();
const controls = new Controls(at("groups"), () => changed());
const fonts = new Fonts((bytes, options) => (stage?.settle(), typemesh.font(bytes, options)));
let typemesh, mesher, measurer, mesh, morph, shown = "", later;  // shown: the text of the mesh

/** Nothing without WebGL: the mesh is then made, counted and saved, but not drawn. */
function openStage() {
    try {
        return new Stage(at("canvas"));
    } catch {
        at("canvas").hidden = true;
        return undefined;
    }
}

// --- fonts -------------------------------------------------------------------------------------------------------------------

function offer(entry) {
    if (fonts.offer(entry)) at("font").append(new Option(entry.name, entry.name));
}
function loading(words) {
    at("loading").textContent = words;
    at("loading").hidden = words === "";
}
async function fetched(name, url) {
    const early = globalThis.early?.url === url ? globalThis.early.answer : undefined;  // begun with the page
    globalThis.early = undefined;
    const answer = await (early ?? fetch(url)).catch(() => undefined);
    if (!answer?.ok) throw new Error(`${name} could not be loaded.`);
    return answer.arrayBuffer();
}
function setFonts() {
    stage?.settle();
    mesher?.free();
    measurer?.free();
    mesh = morph = undefined;
    mesher = typemesh.mesher(fonts.list());
    measurer = typemesh.mesher(fonts.list());
}
/** Sets the text in another font, calls `then` and gives whether that has not failed. Of several choices the newest counts, however slowly others arrive. */
async function choose(name, then = () => {}) {
    const entry = fonts.find(name);
    if (!entry) return true;  // the list of fonts has not come yet, and the page will begin with what its link says
    at("font").value = entry.name;
    if (!entry.font) loading(`Loading ${entry.name}…`);
    let failed;
    const chosen = await fonts.choose(entry).catch(e => (failed = e, true));
    if (!chosen) return true;
    loading("");
    at("font").value = fonts.used?.name ?? "";
    recalling = false;
    if (failed) {
        if (mesher) changed();  // in the font that is there
        say(failed.message);
        then();
        return false;
    }
    controls.setWeights(fonts.weights);
    fonts.weigh(controls.values["page.weight"]);
    fonts.suit(meshed().text);
    setFonts();
    changed();
    then();
    return true;
}
/** The page's fonts for the text's scripts are fetched; where letters are still missing, the others one after the other. */
async function lookFurther() {
    const lacks = () => mesh && !morph && !ticking && (fonts.awaits || mesh.statistics.missing > 0);  // what breathes is of one font
    if (searching || !lacks()) return;
    searching = true;
    note();
    try {
        while (lacks()) {
            const found = await fonts.openAnother(mesh.statistics.missing > 0);
            if (found) {
                fonts.suit(meshed().text);
                setFonts();
                changed();
            } else if (found === false) break;
        }
    } finally {
        searching = false;
        if (mesh) note();
    }
}
let searching = false, target;  // target: of a score
const noFont = /^No font has/;
async function take(files) {
    for (const file of files) {
        try {
            if (!typemesh) throw new Error("the page is not there yet: open the font again in a moment.");
            const entry = { name: file.name, bytes: await file.arrayBuffer() };
            if (/^wOF[F2]$/.test(String.fromCharCode(...new Uint8Array(entry.bytes.slice(0, 4)))))
                throw new Error("it is packed for web pages (WOFF). Open the same font as .ttf or .otf.");
            stage?.settle();
            entry.font = typemesh.font(entry.bytes);
            offer(entry);
            await choose(entry.name);
        } catch (e) {
            say(`${file.name}: ${e.message}`);
        }
    }
}

// --- the mesh ----------------------------------------------------------------------------------------------------------------

function say(words) {
    at("message").textContent = words;
    at("message").hidden = words === "";
}
const number = n => n.toLocaleString("en");

/** Makes the mesh of a text; after an error the last one stays. */
function make(text, options) {
    morph = undefined;
    const next = breathes() && !ticking ? mesher.morph(text, "wght", options) : undefined;
    mesh = next ? next.at(weightAt(performance.now())) : mesher.mesh(text, options);
    morph = next;
    shown = text;
}
/** Likewise; where tags are wrong, the text is shown as it stands. */
function makeMarked(text, options) {
    trouble = "";
    try {
        make(text, options);
    } catch (e) {
        if (!options.markup || !(e.at >= 0)) throw e;
        make(text, { ...options, markup: false });
        trouble = `Tags are not read yet: at character ${e.at + 1}, ${e.message[0].toLowerCase()}${e.message.slice(1)}`;
    }
}
let trouble = "";

/** The text that is meshed: for a score, ten digits for each of its digits. */
function meshed() {
    const text = at("text").value, digits = text.replace(/\D/g, "");
    if (controls.motion !== "score" || view === "contours" || digits === "" || digits.length > 6) return { text };
    return { text: Array(digits.length).fill("0123456789").join(" "), target: Number(digits), digits };
}
const breathes = () => controls.motion === "breathe" && fonts.weights && !lessMotion.matches && view !== "contours";

/** Makes the mesh anew, and ends a race; after an error the last one stays. */
function update() {
    if (!mesher) return;
    race(false);
    const began = performance.now(), { text, target, digits } = meshed(), next = { text, target, digits, options: controls.options(text) };
    try {
        if (text.length > maxCharacters)
            throw new Error(`This text has ${number(text.length)} characters. The page accepts at most ${number(maxCharacters)}, and the library any number.`);
        const [weighs, suits] = [fonts.weigh(controls.values["page.weight"]), fonts.suit(text)];
        if (weighs || suits) setFonts();
        makeMarked(text, next.options);
        count(performance.now() - began);
        last = next;
        say("");
    } catch (e) {
        say(e.message);
        mesh = morph = undefined;  // what is refused has ended the mesh that was there
        try {
            if (last) makeMarked(last.text, last.options);
        } catch { /* nor can it be made in these fonts: its picture stays */ }
    }
    remember();
    if (!mesh) return;
    show(last.target);
    if (!morph) controls.showWeight();
    clearTimeout(later);
    later = setTimeout(() => measure(last.text, last.options), 200);
    if (last !== next) return;
    tellProgram();
    lookFurther();
}
let last;  // what meshed() was for the last mesh, and its options
/** After a change of all but the text: a race goes on with it. */
function changed() {
    if (!ticking) return update();
    if (fonts.weigh(controls.values["page.weight"])) setFonts();
    remember();
}
/** Milliseconds with two digits or more. */
const inMs = ms => `${ms < 10 ? Number(ms.toPrecision(2)) : number(Math.round(ms))} ms`;
/** Of the last changes the median, without drawing, and without the first ones, which make all anew: letters, fonts that arrive. */
function count(ms) {
    lastChange = ms;
    if (isNew) return void (isNew = mesh?.statistics.missing > 0);
    changes.push(ms);
    if (changes.length > 21) changes.shift();
    at("change").closest("div").hidden = false;
    at("change").value = inMs([...changes].sort((a, b) => a - b)[changes.length >> 1]);
}
const changes = [];
let lastChange = 0, isNew = true;

const weightAt = time => {
    const { minimum, maximum } = fonts.weights;
    return minimum + (maximum - minimum) * (0.5 - 0.5 * Math.cos(time / 4200 * 2 * Math.PI));
};
/** The next frame of a text that breathes; whether there is one. */
function breath(time) {
    if (!morph) return false;
    mesh = morph.at(weightAt(time));
    controls.showWeight(weightAt(time));
    stage.move(mesh);
    label(`weight ${Math.round(weightAt(time))}`, stage.above);
    return true;
}
/** Words that stand above a place of the stage; nowhere if there is none. */
function label(words, spot) {
    const one = at("label");
    one.hidden = !spot;
    if (!spot) return;
    if (one.textContent !== words) one.textContent = words;
    const room = at("stage").clientWidth - one.offsetWidth, low = at("top").offsetHeight;
    one.style.transform = `translate(${Math.max(8, Math.min(room - 8, spot.x - one.offsetWidth / 2))}px, ${Math.max(low, spot.y - one.offsetHeight)}px)`;
}
const scanned = () => `${at("triangles").value} triangles${at("open-edges").value === "0" ? ", one closed mesh, 0 open edges" : ""}`;

function show(to) {
    target = to;
    if (stage) {
        stage.dress(controls.look);
        const motion = controls.motion === "score" && target === undefined || morph ? "still" : controls.motion;
        stage.show(mesh, { motion, target, rainbow: controls.values["page.rainbow"], breathes: morph !== undefined });
    }
    const s = mesh.statistics;
    at("vertices").value = number(s.vertices);
    at("triangles").value = number(s.triangles);
    note();
    tellClaim();
    for (const id of ["open-edges", "cached"]) at(id).value = "…";
}
/** What there is to say of the mesh. */
function note() {
    const warnings = mesh.warnings.filter(words => !((searching || morph) && noFont.test(words)));
    const notes = [trouble, ...controls.notes(), ...warnings].filter(Boolean);
    if (!stage) notes.unshift("This browser offers no WebGL, so the mesh is not drawn. It is made all the same and can be saved.");
    if (controls.motion !== "still" && lessMotion.matches) notes.push("Your system prefers less motion, so letters stay still.");
    else if (controls.motion === "breathe" && !fonts.weights) notes.push("This font has one weight only, so it cannot breathe.");
    if (morph && mesh.statistics.missing > 0) notes.push("Only letters of the chosen font breathe.");
    if (controls.motion === "score" && target === undefined && view !== "contours") notes.push("Only a number of up to six digits rolls.");
    if (controls.motion !== "still" && view === "contours") notes.push("Contours stay still.");
    if (searching) notes.push("A font for these letters is on its way.");
    if (shown.trim() === "") notes.push("There is no text: type one.");
    const words = notes.join(" ");
    if (at("notes").textContent !== words) at("notes").textContent = words;
}
/** What takes longer than a change should: once nothing has changed for a while. */
function measure(text, options) {
    if (ticking || !mesh) return;
    stage?.settle();
    const marked = { ...options, markup: options.markup === true && !trouble };
    const cold = leastOf(() => measurer.mesh(text, { ...marked, cached: false }), 60);
    at("open-edges").value = number(morph ? mesh.openEdges() : cold.made.openEdges());
    const { ms } = leastOf(() => morph ? (mesh = morph.at(weightAt(performance.now()))) : (make(text, marked), mesh), 300);  // all letters are there now
    at("cached").value = inMs(ms);
    at("making").title = (morph ? "The next weight of this text" : "This text anew, with its letters built before") +
        `: the least of some times, drawing not included. With no letter built before: ${inMs(cold.ms)}`;
    document.documentElement.dataset.measured = String(++measured);
}
let measured = 0;
/** The last of some meshes, and the least of their times: other programs run as well. As browsers' clocks are coarse, some are timed together. */
function leastOf(makes, longest) {
    const began = performance.now();
    let made, ms = Infinity, together = 1, now = began, times = 0;
    do {
        const from = now;
        for (let i = 0; i < together; ++i) made = makes();
        now = performance.now();
        if (now - from < 0.5) together *= 2;
        else ++times, ms = Math.min(ms, (now - from) / together);
    } while (times === 0 || now - began < (times < 12 ? longest : 20));
    return { made, ms };
}

// --- a thousand characters a frame -------------------------------------------------------------------------------------------

let ticking = false, races = 0;
function tick() {
    const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789", own = ++races;
    let frames = 0, since = performance.now(), number = 0;
    const frame = () => {
        if (!ticking || own !== races) return;
        let text = String(++number).padStart(8, "0") + " ";
        while (text.length < 1000) text += text.length % 7 === 6 ? " " : letters[Math.floor(Math.random() * letters.length)];
        try {
            make(text, { ...controls.options(), width: 34, align: "left" });
        } catch (e) {
            update();
            return say(e.message);
        }
        show();  // it is drawn before the next call of this, which comes later in that frame
        const now = performance.now();
        if (now - since > (++frames < 10 ? 3000 : 500)) {
            const rate = 1000 * frames / (now - since);
            at("rate").value = rate < 10 ? Number(rate.toPrecision(2)) : rate.toFixed(0);
            frames = 0;
            since = now;
        }
        requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
}
function race(on) {
    if (ticking === on) return;
    ticking = on;
    at("ticker").setAttribute("aria-pressed", String(on));
    at("frames").hidden = !on;
    if (stage) stage.moved = false;
    if (!on) return;
    morph = undefined;
    controls.showWeight();
    tick();
}

// --- the link ----------------------------------------------------------------------------------------------------------------

let view = start.view;
const history = new History();
const fitsLink = () => new URLSearchParams({ text: at("text").value }).toString().length <= maxInLink;
/** All that the page is set to; the text only if `withText`. */
function kept(withText) {
    const all = new URLSearchParams(controls.changes());
    if (at("text").value !== start.text && withText) all.set("text", at("text").value);
    if (view !== start.view) all.set("view", view);
    if (fonts.used && fonts.used !== fonts.first && fonts.used.load) all.set("font", fonts.used.name);
    return all;
}
const link = () => kept(fitsLink()).toString();
let remembering, recalling = false;  // recalling: all is set but the font, which may still have to come
function remember() {  // browsers refuse more than some changes of the address a second
    if (recalling || !mesher) return;
    clearTimeout(remembering);
    history.keep({ set: kept(false).toString(), text: at("text").value, font: fonts.used?.name });
    at("undo").disabled = !history.canUndo;
    at("redo").disabled = !history.canRedo;
    const preset = [...at("presets").children].find(one => isSame(one.hash.slice(1), link()));
    const claimed = preset?.claim ?? (kept(true).toString() === "" ? "Type anything, drag it, or try a sample." : "");
    for (const one of at("presets").children) one.removeAttribute("aria-current");
    preset?.setAttribute("aria-current", "true");
    if (claim !== claimed && preset) at("presets").scrollLeft = preset.offsetLeft - (at("presets").clientWidth - preset.clientWidth) / 2;
    claim = claimed;
    tellClaim();
    remembering = setTimeout(() => globalThis.history.replaceState(null, "", link() ? "#" + link() : location.pathname + location.search), 250);
}
/** What a sample shows, with the figures of its mesh. */
function tellClaim() {
    const words = ticking ? "" : claim.replace("{triangles}", number(mesh?.statistics.triangles ?? 0));
    if (at("caption").textContent !== words) at("caption").textContent = words;
}
let claim = "";
/** Sets the page to what is kept, and gives the name of the font, which is to be chosen next. */
function recall(kept = new URLSearchParams(location.hash.slice(1))) {
    recalling = true;
    race(false);
    controls.reset();
    for (const [name, value] of kept) controls.set(name, value);
    at("text").value = kept.get("text") ?? start.text;
    changes.length = 0;
    isNew = at("change").closest("div").hidden = true;
    setView(views.includes(kept.get("view")) ? kept.get("view") : start.view);
    return kept.get("font");
}
function goTo(state) {
    if (!state) return;
    const kept = new URLSearchParams(state.set);
    kept.set("text", state.text);
    recall(kept);
    choose(state.font);
}
function setView(name) {
    view = name;
    if (stage) stage.view = name;
    at("view-" + name).checked = true;
}

// --- the program ---------------------------------------------------------------------------------------------------------------

/** Options without those that have the library's defaults. */
function pruned(options) {
    const movesEdges = options.embolden || options.outline?.width || options.tube?.radius;
    const usual = new Map(typemesh.options.map(o => [o.name, o.default ?? o.choices?.[0]])), kept = {};
    for (const [name, value] of Object.entries(options)) {
        if (value?.constructor === Object && name !== "features") {
            const inner = Object.fromEntries(Object.entries(value).filter(([k, v]) => v !== usual.get(`${name}.${k}`)));
            if (Object.keys(inner).some(k => ["width", "height", "cylinder", "twist", "wave", "arc", "flag", "ring", "radius"].includes(k))) kept[name] = inner;
        } else if (value !== usual.get(name) && name !== "letters" && !(name === "letterSpacing" && value === 0 && !movesEdges)) kept[name] = value;
    }
    return kept;
}
/** What programs.js takes. */
function programState() {
    const text = at("text").value, all = controls.options(text);
    const options = pruned({ ...all, markup: all.markup === true && !trouble }), bent = options.bend || options.warp?.flag;
    if (bent) stage?.settle();
    const { advance } = bent ? measurer.mesh(text, { ...options, bend: undefined, warp: undefined, depth: 0, bevel: undefined }).statistics : {};
    const { roughness, metalness, clearcoat } = finishes[controls.look.finish], material = { color: controls.colour, roughness, metalness, clearcoat };
    return { text, options, material, advance, file: fonts.used.file ?? fonts.used.name, others: fonts.othersFor(text), axis: morph && fonts.weights,
             weight: fonts.weights && controls.values["page.weight"] };
}
function tellProgram() {
    if (!at("program").open || !mesh) return;
    try {
        at("code").textContent = programs[at("language-of-program").value](programState());
    } catch (e) {
        at("code").textContent = e.message;
    }
}

// For the browser's console, and for tests.
globalThis.page = {
    get mesh() { return mesh; }, get options() { return controls.options(at("text").value); }, get lastChange() { return lastChange; },
    get weight() { return fonts.weights && controls.values["page.weight"]; }, get stage() { return stage; }, programs, programState, presets,
    get shown() { return shown; }, made({ text, options }) { stage?.settle(); return measurer.mesh(text, options); },
};

// --- begin -------------------------------------------------------------------------------------------------------------------

for (const name of views) {
    const label = at("views").appendChild(document.createElement("label"));
    label.innerHTML = `<input type="radio" name="view" id="view-${name}" value="${name}"><span>${name}</span>`;
    label.firstChild.addEventListener("change", () => (setView(name), changed()));
}
at("text").addEventListener("input", update);
at("font").addEventListener("change", async () => await choose(at("font").value) || mesher || choose(fonts.first?.name));
at("file").addEventListener("change", ({ target }) => {
    take([...target.files]);
    target.value = "";  // the same file may be opened again
});
at("fit").addEventListener("click", () => stage?.fit());
at("ticker").addEventListener("click", () => mesher && (ticking ? update() : race(true)));
const saving = (id, save) => at(id).addEventListener("click", () => {
    if (!mesh) say("There is no mesh yet that could be saved.");
    else import("./downloads.js").then(save).catch(e => say(e.message));
});
/** Of a score its number, and not the wheels that roll. */
function solid() {
    if (target === undefined) return { mesh, text: shown, tints: stage?.tints ?? mesh.tint };
    stage?.settle();
    const number = measurer.mesh(last.digits, last.options);
    return { mesh: number, text: last.digits, tints: controls.values["page.rainbow"] ? rainbowOf(number.letter) : number.tint };
}
saving("glb", d => {
    const { mesh, text, tints } = solid();
    return d.saveGlb(mesh, text, materials, tints);
});
saving("stl", d => d.saveStl(solid().mesh, materials));
saving("png", d => stage ? d.savePng(stage) : say("There is no picture to save, because this browser has no WebGL."));
at("link").addEventListener("click", async () => {
    const address = location.origin + location.pathname + location.search + (link() ? "#" + link() : "");
    globalThis.history.replaceState(null, "", address);
    const done = await navigator.clipboard?.writeText(address).then(() => true, () => false);
    at("link").textContent = !fitsLink() ? "Link has no text: it is too long for one" : !fonts.used?.load ? "Link has not your font" : done ? "Link copied" : "Link is in the address";
    setTimeout(() => { at("link").textContent = "Copy link"; }, 2000);
});
at("reset").addEventListener("click", async () => {
    globalThis.history.replaceState(null, "", location.pathname + location.search);
    recall();
    afresh();
    await choose(fonts.first?.name);
});
at("panel").addEventListener("submit", event => event.preventDefault());
addEventListener("hashchange", () => choose(recall(), afresh));
let rests = false;  // somebody has ended the turning
function afresh() {
    stage?.turn(!lessMotion.matches && !rests);
    stage?.fit();
}
lessMotion.addEventListener("change", () => changed());
at("undo").addEventListener("click", () => goTo(history.undo()));
at("redo").addEventListener("click", () => goTo(history.redo()));
addEventListener("keydown", event => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || !/^[zy]$/i.test(event.key)) return;
    event.preventDefault();
    goTo(event.shiftKey || event.key.toLowerCase() === "y" ? history.redo() : history.undo());
});
for (const preset of presets) {
    const one = at("presets").appendChild(document.createElement("a"));
    Object.assign(one, { href: linkOf(preset), className: preset.name, title: preset.title, claim: preset.claim });
    one.appendChild(document.createElement("span")).textContent = preset.label;
    one.addEventListener("click", () => location.hash === one.hash && afresh());
}
// Who types anywhere types the text; a text of the page's own is replaced.
addEventListener("keydown", event => {
    const { activeElement: where } = document, isFree = where === document.body || where === at("canvas") || where.parentNode === at("presets");
    if (!isFree || event.key.length !== 1 || event.key === " " || event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const box = at("text");
    box.focus();
    if (claim !== "") box.select();
    else box.setSelectionRange(box.value.length, box.value.length);
});
for (const button of at("tags").children) button.addEventListener("click", () => {
    const box = at("text"), { selectionStart: from, selectionEnd: to } = box, tag = button.dataset.tag;
    box.setRangeText(`[${tag}]${box.value.slice(from, to)}[/]`, from, to, "select");
    box.setSelectionRange(from + tag.length + 2, to + tag.length + 2);
    box.focus();
    update();
});
at("show-program").addEventListener("click", () => {
    at("program").open = true;
    tellProgram();  // before its "toggle" comes: there is where to scroll to
    at("program").scrollIntoView({ block: "start" });
    at("language-of-program").focus({ preventScroll: true });
});
at("program").addEventListener("toggle", tellProgram);
at("language-of-program").addEventListener("change", tellProgram);
at("copy").addEventListener("click", async () => {
    const done = await navigator.clipboard?.writeText(at("code").textContent).then(() => true, () => false);
    if (!done) getSelection().selectAllChildren(at("code"));
    at("copy").textContent = done ? "Copied" : "Press Ctrl+C";
    setTimeout(() => { at("copy").textContent = "Copy"; }, 1500);
});
if (stage) {
    stage.breath = breath;
    stage.onrestored = changed;
    stage.onscan = spot => (spot || !morph) && label(scanned(), spot);
    stage.covered = () => {
        const [all, top, bar] = ["stage", "top", "bar"].map(id => at(id).getBoundingClientRect());
        return { top: top.bottom - all.top, bottom: all.bottom - bar.top };
    };
    stage.ontouch = () => at("turn").setAttribute("aria-pressed", String(stage.turning));
    at("turn").addEventListener("click", () => stage.turn(!(rests = stage.turning)));
    stage.ontouch();
}
let inside = 0;
const dragging = (kind, call) => addEventListener(kind, event => {
    if (!event.dataTransfer.types.includes("Files")) return;  // words go where they always go
    event.preventDefault();
    call(event);
});
dragging("dragenter", () => { ++inside; document.body.classList.add("dropping"); });
dragging("dragleave", () => { if (--inside === 0) document.body.classList.remove("dropping"); });
dragging("dragover", () => {});
dragging("drop", event => {
    inside = 0;
    document.body.classList.remove("dropping");
    take([...event.dataTransfer.files]);
});

try {
    const [library, bundled] = await Promise.all([
        load("typemesh.wasm").catch(e => { throw new Error(globalThis.WebAssembly ? `typemesh.wasm could not be loaded: ${e.message}` :
            "This browser has no WebAssembly, or it is switched off. Without it the page cannot make meshes."); }),
        fetch("fonts.json").then(r => r.json()).catch(() => { throw new Error("The list of fonts could not be loaded: load the page again."); }),
    ]);
    typemesh = library;
    for (const { name, file, scripts } of bundled)
        offer({ name, file: file.split("/").pop(), letters: scripts && lettersOf(scripts), load: () => fetched(name, file) });
    let chosen = await choose(recall());
    for (const { name } of bundled) chosen ||= await choose(name);
    stage?.settle();
    document.documentElement.dataset.ready = performance.now().toFixed(0);  // ms since the page was requested
} catch (e) {
    loading("");
    say(e.message);
}
