// SPDX-License-Identifier: MIT
// Text, fonts and settings in, a mesh on the stage: the page's one loop.

import load from "typemesh";
import { Controls } from "./controls.js";
import { saveGlb, savePng, saveStl } from "./downloads.js";
import { Fonts } from "./fonts.js";
import { lessMotion } from "./motion.js";
import { materials, Stage, views } from "./stage.js";

const at = id => document.getElementById(id);
const start = { text: "Hello world!", view: "solid" };
const maxCharacters = 100000, maxInLink = 2000;  // the latter as they stand in an address
const stage = openStage();
const controls = new Controls(at("groups"), () => update());
const fonts = new Fonts(bytes => typemesh.font(bytes));
let typemesh, mesher, measurer, mesh, shown = "", later;  // shown: the text of the mesh

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
    const answer = await fetch(url).catch(() => undefined);
    if (!answer?.ok) throw new Error(`${name} could not be loaded.`);
    return answer.arrayBuffer();
}
function setFonts() {
    mesher?.free();
    measurer?.free();
    mesh = undefined;
    mesher = typemesh.mesher(fonts.list());
    measurer = typemesh.mesher(fonts.list());
}
/** Sets the text in another font. Of several choices the newest counts, however slowly the others arrive. */
async function choose(name) {
    const entry = fonts.find(name);
    at("font").value = entry.name;
    if (!entry.font) loading(`Loading ${entry.name}…`);
    let failed;
    const chosen = await fonts.choose(entry).catch(e => (failed = e, true));
    if (!chosen) return;
    loading("");
    at("font").value = fonts.used?.name ?? "";
    if (failed) return say(failed.message);
    setFonts();
    update();
}
/** Where letters are missing, the fonts that come with the page are fetched one after the other. */
async function lookFurther() {
    if (searching) return;
    searching = true;
    while (mesh?.statistics.missing > 0 && !ticking) {
        const before = fonts.used;
        if (await fonts.openAnother()) {
            setFonts();
            update();
        } else if (fonts.used === before) break;
    }
    searching = false;
}
let searching = false;
async function take(files) {
    for (const file of files) {
        try {
            const entry = { name: file.name, bytes: await file.arrayBuffer() };
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
    mesh = mesher.mesh(text, options);
    shown = text;
}
/** Makes the mesh anew; after an error the last one stays on the stage. */
function update() {
    if (!mesher) return;
    const began = performance.now();
    const options = controls.options(), text = at("text").value;
    if (text.length > maxCharacters)
        return say(`This text has ${number(text.length)} characters. The page accepts at most ${number(maxCharacters)}, and the library any number.`);
    try {
        make(text, options);
        say("");
    } catch (e) {
        say(e.message);
        return;
    }
    show();
    at("change").value = (performance.now() - began).toFixed(1);
    clearTimeout(later);
    later = setTimeout(() => measure(options), 200);
    remember();
    lookFurther();
}
function show() {
    stage?.show(mesh, controls.motion);
    const s = mesh.statistics;
    at("vertices").value = number(s.vertices);
    at("triangles").value = number(s.triangles);
    const notes = [...controls.notes(), ...mesh.warnings];
    if (!stage) notes.unshift("This browser offers no WebGL, so the mesh is not drawn. It is made all the same and can be saved.");
    if (controls.motion !== "still" && lessMotion.matches) notes.push("Your system prefers less motion, so letters stay still.");
    if (controls.motion !== "still" && view === "contours") notes.push("Contours stay still.");
    if (shown.trim() === "") notes.push("There is no text: type one.");
    at("notes").textContent = notes.join(" ");
    for (const id of ["open-edges", "cold", "cached"]) at(id).value = "…";
}
/** What takes longer than a change should: once nothing has changed for a while. */
function measure(options) {
    if (ticking || !mesh) return;
    const cold = measurer.mesh(at("text").value, { ...options, cached: false });
    at("cold").value = number(Math.round(cold.statistics.microseconds));
    make(at("text").value, options);  // the same again: all its letters are there now
    at("cached").value = number(Math.round(mesh.statistics.microseconds));
    at("open-edges").value = number(mesh.openEdges());
    document.documentElement.dataset.measured = String(++measured);
}
let measured = 0;

// --- a thousand characters a frame -------------------------------------------------------------------------------------------

let ticking = false;
function tick() {
    const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
    const options = { ...controls.options(), width: 34, align: "left" };
    let frames = 0, since = performance.now(), number = 0;
    const frame = () => {
        if (!ticking) return;
        let text = String(++number).padStart(8, "0") + " ";
        while (text.length < 1000) text += text.length % 7 === 6 ? " " : letters[Math.floor(Math.random() * letters.length)];
        try {
            make(text, options);
        } catch (e) {
            say(e.message);
            return toggle(false);
        }
        show();
        stage?.drawNow();
        const now = performance.now();
        if (++frames >= 10 && now - since > 500) {
            at("rate").value = (1000 * frames / (now - since)).toFixed(0);
            frames = 0;
            since = now;
        }
        requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
}
function toggle(on) {
    ticking = on;
    at("ticker").setAttribute("aria-pressed", String(on));
    at("frames").hidden = !on;
    if (stage) stage.moved = false;
    if (on) tick();
    else update();
}

// --- the link ----------------------------------------------------------------------------------------------------------------

let view = start.view;
function link() {
    const kept = new URLSearchParams(controls.changes());
    if (at("text").value !== start.text && fitsLink()) kept.set("text", at("text").value);
    if (view !== start.view) kept.set("view", view);
    if (fonts.used && fonts.used !== fonts.first && fonts.used.load) kept.set("font", fonts.used.name);
    return kept.toString();
}
function fitsLink() { return new URLSearchParams({ text: at("text").value }).toString().length <= maxInLink; }
let remembering;
function remember() {  // browsers refuse more than some changes of the address a second
    clearTimeout(remembering);
    remembering = setTimeout(() => history.replaceState(null, "", link() ? "#" + link() : location.pathname), 250);
}
function recall() {
    const kept = new URLSearchParams(location.hash.slice(1));
    controls.reset();
    for (const [name, value] of kept) controls.set(name, value);
    at("text").value = kept.get("text") ?? start.text;
    look(views.includes(kept.get("view")) ? kept.get("view") : start.view);
    return kept.get("font");
}
function look(name) {
    view = name;
    if (stage) stage.view = name;
    at("view-" + name).checked = true;
    if (mesh) update();
}

// For the browser's console, and for tests.
globalThis.page = { get mesh() { return mesh; }, get options() { return controls.options(); } };

// --- begin -------------------------------------------------------------------------------------------------------------------

for (const name of views) {
    const label = at("views").appendChild(document.createElement("label"));
    label.innerHTML = `<input type="radio" name="view" id="view-${name}" value="${name}"><span>${name}</span>`;
    label.firstChild.addEventListener("change", () => look(name));
}
at("text").addEventListener("input", update);
at("font").addEventListener("change", () => choose(at("font").value));
at("file").addEventListener("change", event => take(event.target.files));
at("fit").addEventListener("click", () => stage?.fit());
at("ticker").addEventListener("click", () => toggle(!ticking));
at("glb").addEventListener("click", () => saveGlb(mesh, shown, materials).catch(e => say(e.message)));
at("stl").addEventListener("click", () => saveStl(mesh, materials).catch(e => say(e.message)));
at("png").addEventListener("click", () => stage ? savePng(stage) : say("There is no picture to save, because this browser has no WebGL."));
at("link").addEventListener("click", async () => {
    const address = location.origin + location.pathname + (link() ? "#" + link() : "");
    history.replaceState(null, "", address);
    await navigator.clipboard?.writeText(address).catch(() => {});
    at("link").textContent = fitsLink() ? "Link is in the address" : "Link has no text: it is too long for one";
    setTimeout(() => { at("link").textContent = "Copy link"; }, 1500);
});
at("reset").addEventListener("click", async () => {
    history.replaceState(null, "", location.pathname);
    recall();
    if (stage) stage.moved = false;
    await choose(fonts.first.name);
});
at("panel").addEventListener("submit", event => event.preventDefault());
addEventListener("hashchange", () => choose(recall()));
let inside = 0;
addEventListener("dragenter", event => { event.preventDefault(); ++inside; document.body.classList.add("dropping"); });
addEventListener("dragleave", () => { if (--inside === 0) document.body.classList.remove("dropping"); });
addEventListener("dragover", event => event.preventDefault());
addEventListener("drop", event => {
    event.preventDefault();
    inside = 0;
    document.body.classList.remove("dropping");
    take(event.dataTransfer.files);
});

try {
    const [library, bundled] = await Promise.all([load("typemesh.wasm"), fetch("fonts.json").then(r => r.json())]);
    typemesh = library;
    for (const [name, url] of Object.entries(bundled)) offer({ name, load: () => fetched(name, url) });
    await choose(recall());
    stage?.drawNow();
    document.documentElement.dataset.ready = performance.now().toFixed(0);  // ms since the page was requested
} catch (e) {
    loading("");
    say(e.message);
}
