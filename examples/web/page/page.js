// SPDX-License-Identifier: MIT
// Text, fonts and settings in, a mesh on the stage: the page's one loop.

import load from "typemesh";
import { Controls } from "./controls.js";
import { saveGlb, savePng, saveStl } from "./downloads.js";
import { Stage, views } from "./stage.js";

const at = id => document.getElementById(id);
const start = { text: "Hello world!", view: "solid" };
const stage = new Stage(at("canvas"));
const controls = new Controls(at("groups"), () => update());
const fonts = [];  // {name, url or bytes, font}
let typemesh, mesher, measurer, used = "", mesh, shown = "", later;  // shown: the text of the mesh

// --- fonts -------------------------------------------------------------------------------------------------------------------

function offer(entry) {
    fonts.push(entry);
    at("font").append(new Option(entry.name, entry.name));
}
async function opened(entry) {
    if (!entry.font) {
        const answer = entry.bytes ?? await fetch(entry.url).then(r => r.ok ? r.arrayBuffer() : Promise.reject(new Error(`${entry.name} could not be loaded.`)));
        entry.font = typemesh.font(answer);
    }
    return entry.font;
}
/** The chosen font; the first one stands in for what it lacks. */
async function choose(name) {
    const entry = fonts.find(f => f.name === name) ?? fonts[0];
    const list = [await opened(entry)];
    if (entry !== fonts[0]) list.push(await opened(fonts[0]));
    mesher?.free();
    measurer?.free();
    mesh = undefined;
    mesher = typemesh.mesher(list);
    measurer = typemesh.mesher(list);
    used = entry.name;
    at("font").value = used;
}
async function take(files) {
    let taken = false;
    for (const file of files) {
        try {
            const entry = { name: file.name, bytes: await file.arrayBuffer() };
            await opened(entry);
            if (!fonts.some(f => f.name === entry.name)) offer(entry);
            else fonts.find(f => f.name === entry.name).font = entry.font;
            await choose(entry.name);
            taken = true;
        } catch (e) {
            say(`${file.name}: ${e.message}`);
        }
    }
    if (taken) update();
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
    const options = controls.options();
    try {
        make(at("text").value, options);
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
}
function show() {
    stage.show(mesh);
    const s = mesh.statistics;
    at("vertices").value = number(s.vertices);
    at("triangles").value = number(s.triangles);
    at("notes").textContent = mesh.warnings.join(" ");
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
        stage.drawNow();
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
    stage.moved = false;
    if (on) tick();
    else update();
}

// --- the link ----------------------------------------------------------------------------------------------------------------

let view = start.view;
function link() {
    const kept = new URLSearchParams(controls.changes());
    if (at("text").value !== start.text) kept.set("text", at("text").value);
    if (view !== start.view) kept.set("view", view);
    if (used !== fonts[0]?.name && fonts.find(f => f.name === used)?.url) kept.set("font", used);
    return kept.toString();
}
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
    stage.view = view = name;
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
at("font").addEventListener("change", () => choose(at("font").value).then(update, e => say(e.message)));
at("file").addEventListener("change", event => take(event.target.files));
at("fit").addEventListener("click", () => stage.fit());
at("ticker").addEventListener("click", () => toggle(!ticking));
at("glb").addEventListener("click", () => saveGlb(mesh, shown, stage.materials).catch(e => say(e.message)));
at("stl").addEventListener("click", () => saveStl(mesh, stage.materials).catch(e => say(e.message)));
at("png").addEventListener("click", () => savePng(stage));
at("link").addEventListener("click", async () => {
    const address = location.origin + location.pathname + (link() ? "#" + link() : "");
    history.replaceState(null, "", address);
    await navigator.clipboard?.writeText(address).catch(() => {});
    at("link").textContent = "Link is in the address";
    setTimeout(() => { at("link").textContent = "Copy link"; }, 1500);
});
at("reset").addEventListener("click", async () => {
    history.replaceState(null, "", location.pathname);
    recall();
    stage.moved = false;
    await choose(fonts[0].name);
    update();
});
at("panel").addEventListener("submit", event => event.preventDefault());
addEventListener("hashchange", () => { const font = recall(); choose(font).then(update, e => say(e.message)); });
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
    for (const [name, url] of Object.entries(bundled)) offer({ name, url });
    const font = recall();
    await choose(font);
    update();
    stage.drawNow();
    document.documentElement.dataset.ready = performance.now().toFixed(0);  // ms since the page was asked for
} catch (e) {
    say(e.message);
} finally {
    at("loading").hidden = true;
}
