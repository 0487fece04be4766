// SPDX-License-Identifier: MIT
// page.mjs SITE BROWSER PICTURES RENEW: does to the page what a user would, and fails on whatever is not as it should be.

import { execFileSync, spawnSync } from "node:child_process";
import fs from "node:fs";
import http from "node:http";
import { createRequire } from "node:module";
import path from "node:path";

const [, , site, executablePath, pictures, renew] = process.argv;
const puppeteer = createRequire(import.meta.url)(path.join(process.env.NODE_PATH, "puppeteer-core"));
const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".json": "application/json" };
const held = new Map();  // files that arrive when the test says so, and who waits for each
const lost = new Set();  // files that are not there
const server = http.createServer((request, response) => {
    const file = path.join(site, new URL(request.url, "http://x").pathname.replace(/\/$/, "/index.html"));
    if (!file.startsWith(site) || !fs.existsSync(file) || lost.has(path.basename(file))) return response.writeHead(404).end();
    const answer = () => {
        response.writeHead(200, { "content-type": types[path.extname(file)] ?? "application/octet-stream" });
        fs.createReadStream(file).pipe(response);
    };
    if (held.has(path.basename(file))) held.get(path.basename(file)).push(answer);
    else answer();
});
await new Promise(done => server.listen(0, "127.0.0.1", done));
const home = `http://127.0.0.1:${server.address().port}/`;

const browser = await (puppeteer.default ?? puppeteer).launch({
    executablePath, protocolTimeout: 300000,
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
           "--font-render-hinting=none", "--force-color-profile=srgb"],
});
const page = await browser.newPage();
page.setDefaultTimeout(120000);
let failures = 0, passes = 0;
const check = (good, words) => {
    if (good) ++passes;
    else console.log(`FAILED: ${words}`), ++failures;
};
page.on("console", m => { if (["error", "warn"].includes(m.type())) check(false, `the console says: ${m.text()}`); });
page.on("pageerror", e => check(false, `the page throws: ${e.message}`));
page.on("requestfailed", r => check(false, `not loaded: ${r.url()}`));
page.on("response", r => check(r.status() < 400, `${r.status()}: ${r.url()}`));
page.on("request", r => check(/^(data|blob):/.test(r.url()) || r.url().startsWith(home), `the network is used: ${r.url()}`));

// --- what a user sees --------------------------------------------------------------------------------------------------------

const value = id => page.$eval("#" + id, e => e.value ?? e.textContent);
const message = () => page.$eval("#message", e => e.hidden ? "" : e.textContent);
const measured = () => page.evaluate(() => Number(document.documentElement.dataset.measured ?? 0));
async function settled(before) {
    await page.waitForFunction(n => Number(document.documentElement.dataset.measured ?? 0) > n || !document.getElementById("message").hidden, {}, before);
}
/** Opens the page; nothing moves in it, unless `still` is false. */
async function open(hash = "", { width = 1000, height = 640, dark = false, still = true } = {}) {
    await page.setViewport({ width, height });
    await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: dark ? "dark" : "light" },
        { name: "prefers-reduced-motion", value: still ? "reduce" : "no-preference" }]);
    await page.goto("about:blank");
    await page.goto(home + hash, { waitUntil: "domcontentloaded", timeout: 120000 });
    if (width === 1000) await page.addStyleTag({ content: "header { height: 42px; overflow: hidden; }" });  // two lines in some systems' fonts
    if (!still) await page.addStyleTag({ content: "#presets { visibility: hidden; }" });  // one of them breathes
    await settled(0);
}
/** Does something that changes the mesh, and waits until it has been made and measured. */
async function change(doing) {
    const before = await measured();
    await doing();
    await settled(before);
}
const put = (selector, to) => page.$eval(selector, (e, v) => {
    if (e.type === "checkbox") e.checked = v;
    else e.value = v;
    e.dispatchEvent(new Event("input", { bubbles: true }));
    e.dispatchEvent(new Event("change", { bubbles: true }));
}, to);
const set = (selector, to) => change(() => put(selector, to));

/** The canvas as it is now, without what lies over it: times and letters of this system's fonts. */
async function canvas() {
    await page.evaluate(() => {
        const sheet = document.getElementById("bare") ?? document.head.appendChild(Object.assign(document.createElement("style"), { id: "bare" }));
        sheet.textContent = ".bare :is(#presets, #bar, #numbers, #notes, #caption) { visibility: hidden; }";
        document.documentElement.classList.add("bare");
    });
    const seen = await (await page.$("#canvas")).screenshot({ encoding: "base64" });
    await page.evaluate(() => document.documentElement.classList.remove("bare"));
    return seen;
}
/** The share of pixels that differ visibly from the stored picture is small; its size is the same. */
async function compare(name) {
    const seen = await canvas();
    const file = path.join(pictures, name + ".png");
    if (renew === "yes") {
        fs.mkdirSync(pictures, { recursive: true });
        fs.writeFileSync(file, Buffer.from(seen, "base64"));
    }
    if (!fs.existsSync(file)) return check(false, `there is no picture ${name}.png`);
    const share = await page.evaluate(async (a, b) => {
        const read = async data => {
            const image = await createImageBitmap(await (await fetch("data:image/png;base64," + data)).blob());
            const pen = new OffscreenCanvas(image.width, image.height).getContext("2d");
            pen.drawImage(image, 0, 0);
            return pen.getImageData(0, 0, image.width, image.height);
        };
        const [one, two] = [await read(a), await read(b)];
        if (one.width !== two.width || one.height !== two.height) return `${one.width} × ${one.height} pixels, not ${two.width} × ${two.height}`;
        let others = 0;
        for (let i = 0; i < one.data.length; i += 4)
            if ([0, 1, 2].some(k => Math.abs(one.data[i + k] - two.data[i + k]) > 40)) ++others;
        return 4 * others / one.data.length;
    }, seen, fs.readFileSync(file).toString("base64"));
    check(share < 0.02, `${name}.png: ${share >= 0 ? (100 * share).toFixed(1) + " % of the pixels are others" : share}`);
}
const rest = ms => new Promise(done => setTimeout(done, ms));
const pick = name => page.$eval("#font", (e, v) => { e.value = v; e.dispatchEvent(new Event("change", { bubbles: true })); }, name);
const drop = (name, bytes) => page.evaluate((name, text) => {
    const files = new DataTransfer();
    files.items.add(new File([Uint8Array.from(atob(text), c => c.charCodeAt(0))], name));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true }));
}, name, bytes.toString("base64"));

// --- what is to be seen ------------------------------------------------------------------------------------------------------

const figures = [];
/** A part of this test: all of them, or those that TYPEMESH_WEB_PARTS names, with commas between. What it throws is its failure alone. */
async function part(name, run) {
    if (process.env.TYPEMESH_WEB_PARTS && !process.env.TYPEMESH_WEB_PARTS.split(",").includes(name)) return;
    const begun = performance.now(), before = failures;
    await run().catch(e => check(false, `${name}: ${e.stack}`));
    for (const answers of held.values()) for (const answer of answers) answer();
    held.clear();
    lost.clear();
    await page.keyboard.up("Control");
    console.log(`${name}: ${failures === before ? "good" : "FAILED"}, ${((performance.now() - begun) / 1000).toFixed(0)} s`);
}
const ready = async () => Number(await page.evaluate(() => document.documentElement.dataset.ready));
const hash = () => page.evaluate(() => globalThis.page.mesh.hash());
const at = name => `#option-${name.replace(".", "-")}`;
const programs = [];  // of what is on the screen, to be compiled
const program = () => page.evaluate(() => {
    const { mesh, shown, programs, programState, made } = globalThis.page, state = programState(), { text, file: font, others } = state;
    const one = shown === text ? mesh : made(state);  // a score shows wheels with all digits
    const { vertices, triangles } = one.statistics, code = programs.cpp(state);
    const packed = a => btoa([...new Uint8Array(a.buffer, a.byteOffset, a.byteLength)].map(b => String.fromCharCode(b)).join(""));
    const [position, index] = [packed(one.position), packed(one.index)];
    return { code, command: programs.command(state), javascript: programs.javascript(state), font, others, vertices, triangles, position, index };
});
const unhurried = () => page.waitForFunction(() => document.getElementById("loading").hidden && globalThis.page.mesh.statistics.missing === 0);
const bundled = JSON.parse(fs.readFileSync(path.join(site, "fonts.json"))), offered = bundled.map(f => f.name);
const loading = () => page.$eval("#loading", e => e.hidden ? "" : e.textContent);

await part("first", async () => {
    await open();
    figures.push(`first mesh on screen: ${await ready()} ms after the page was asked for, in a browser that is just starting`);
    const again = [];
    for (let i = 0; i < 3; ++i) await open(), again.push(await ready());
    figures.push(`    the same in a browser that runs: ${Math.min(...again)} to ${Math.max(...again)} ms`);
    check(await message() === "" && await value("open-edges") === "0", "the first mesh is closed");
    const frames = await page.evaluate(() => [false, true].map(moves => {  // ms until a frame is drawn, the least
        const { stage } = globalThis.page, gl = stage.renderer.getContext(), pixel = new Uint8Array(4), times = [];
        for (let i = 0; i < 15; ++i) {
            const begun = performance.now();
            stage.renderer.shadowMap.needsUpdate = moves;
            stage.drawNow();
            gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
            times.push(performance.now() - begun);
        }
        return Math.min(...times);
    }));
    figures.push(`a frame of the first text, drawn in software without a graphics card: ${frames[0].toFixed(0)} ms, ${frames[1].toFixed(0)} ms with a new shadow, as letters that move need`);
    await compare("solid");
});

// The same mesh as the native program's, if that is there.
await part("native", async () => {
    await open();
    if (process.env.TYPEMESH_MESH_HASH) {
        const fonts = JSON.parse(fs.readFileSync(path.join(site, "fonts.json"), "utf8"));
        const font = path.join(site, fonts[0].file);
        const options = await page.evaluate(() => globalThis.page.options);
        const named = Object.entries(options).flatMap(([k, v]) => typeof v === "object" ? Object.entries(v).map(([s, w]) => `${k}.${s}=${w}`) : [`${k}=${v}`]);
        const native = execFileSync(process.env.TYPEMESH_MESH_HASH, ["Hello world!", "--weight", String(await page.evaluate(() => globalThis.page.weight)), "--font", font, ...named], { encoding: "utf8" }).trim();
        check(native.includes(await hash()), `the native program's mesh has the hash ${native}, the page's ${await hash()}`);
    }
});

// Typing: the time of a change with 200 characters whose letters are there.
await part("typing", async () => {
    await open();
    await change(() => page.$eval("#text", e => {
        e.value = "Typing stays quick with two hundred characters. ".repeat(5).slice(0, 200);
        e.dispatchEvent(new Event("input", { bubbles: true }));
    }));
    const changes = [];
    for (let i = 0; i < 20; ++i) {
        await page.$eval("#text", (e, i) => { e.value = e.value.slice(0, 199) + "aeiou"[i % 5]; e.dispatchEvent(new Event("input", { bubbles: true })); }, i);
        changes.push(await page.evaluate(() => globalThis.page.lastChange));
    }
    changes.sort((a, b) => a - b);
    const shown = await value("change");
    check(/^[\d.,]+ ms$/.test(shown) && Number.parseFloat(shown) > 0 && Number.parseFloat(shown) <= Math.max(...changes) + 0.5, `the page shows the median of its changes: ${shown}`);
    await page.waitForFunction(() => / ms$/.test(document.getElementById("cached").value));
    const making = await value("cached");
    check(/^[\d.,]+ ms$/.test(making) && Number.parseFloat(making) > 0, `and in what time a mesh is made: ${making}`);
    check(/drawing not included.*With no letter built before: [\d.,]+ ms$/.test(await page.$eval("#making", e => e.title)), "and what that is");
    figures.push(`a change of 200 characters: ${changes[10].toFixed(1)} ms (median of 20), ${changes[19].toFixed(1)} ms at most`);
    await page.focus("#text");
    await change(() => page.keyboard.type("!"));
    check((await value("text")).endsWith("!") || (await value("text")).includes("!"), "what is typed comes into the text");
});

// Every option, and each of its values. Short texts cannot be bent to the ends of the sliders.
await part("options", async () => {
    await open("#text=Aé here&bevel.width=0.02", { width: 420, height: 320 });  // little to draw
    const hidden = await page.$$eval("#groups details", all => all.filter(e => !e.open).length);
    check(hidden >= 2, "what few people need is folded");
    await page.$$eval("#groups details", all => all.forEach(e => { e.open = true; }));
    const ids = await page.$$eval("#groups input, #groups select", all => all.map(e => e.id));
    check(ids.length >= 20, "the panel has its controls");
    for (const id of ids) {
        const [kind, was, values] = await page.$eval("#" + id, e => [e.type, e.type === "checkbox" ? e.checked : e.value,
            e.type === "select-one" ? [...e.options].map(o => o.value) : e.type === "checkbox" ? [!e.checked] :
            e.type === "range" ? [e.min, e.max] : e.type === "color" ? ["#00aa55"] : e.id.endsWith("features") ? ["kern=0, liga"] : ["tr"]]);
        for (const v of values) {
            if (String(v) === String(was)) continue;
            await set("#" + id, v);
            check(await message() === "", `${id} = ${v}: ${await message()}`);
            const flat = id === "option-depth" && Number(v) === 0;
            if (!flat) check(await value("open-edges") === "0", `${id} = ${v}: open edges ${await value("open-edges")}`);
        }
        await set("#" + id, was);
        check(kind !== "text" || await message() === "", `${id} is set back`);
    }
    await set("#option-features", "toolong");
    check(/tag/.test(await message()), "a tag of seven letters is refused in words");
    check(Number((await value("triangles")).replace(/,/g, "")) > 0, "and the mesh stays");
    await set("#option-features", "");
});

// The shape: each slider by its keys, what excludes each other, and what cannot be built.
await part("shape", async () => {
    await open();
    await page.$$eval("#groups details", all => all.forEach(e => { e.open = true; }));  // where sliders have the focus
    const straight = await hash();
    for (const name of ["bend.cylinder", "bend.twist", "bend.wave", "warp.arc", "warp.flag", "path.ring", "path.wave", "inflate.height", "tube.radius"]) {
        await page.focus(at(name));
        await change(() => page.keyboard.press("ArrowRight"));
        const step = await page.$eval(at(name), e => [Number(e.value), Number(e.step), e.getAttribute("aria-valuetext")]);
        check(step[0] === step[1] && step[2].startsWith(String(step[0])), `a key moves ${name} by a step: ${step}`);
        check(await hash() !== straight && await message() === "", `${name} changes the mesh: ${await message()}`);
        check(await value("open-edges") === "0", `${name}: open edges ${await value("open-edges")}`);
        await change(() => page.$eval(at(name), e => e.dispatchEvent(new MouseEvent("dblclick", { bubbles: true }))));
        check(await hash() === straight, `a double click sets ${name} back`);
    }
    await set(at("bend.twist"), "90");
    await set(at("bend.cylinder"), "180");
    check(await value("option-bend-twist") === "0", "one way to bend at a time");
    check(/so Twist is 0 again\.$/.test(await value("notes")), `which is told: ${await value("notes")}`);
    await set(at("warp.arc"), "60");
    check(await value("option-bend-cylinder") === "180", "an arc goes with a bend");
    await set(at("warp.arc"), "0");
    await set(at("inflate.height"), "1");
    const balloon = await hash();
    for (const name of ["depth", "bevel.width", "outline.width", "normals"])
        check(await page.$eval(at(name), e => e.disabled), `inflated letters have no ${name}`);
    check(/Inflated letters have no bevels/.test(await value("notes")), `which is told: ${await value("notes")}`);
    await set(at("tube.radius"), "0.02");
    check(await value("option-inflate-height") === "0" && /so Inflate is 0 again\./.test(await value("notes")), `tubes are not inflated, which is told: ${await value("notes")}`);
    for (const name of ["depth", "bevel.width", "outline.width", "normals"])
        check(await page.$eval(at(name), e => e.disabled), `tubes have no ${name}`);
    check(await value("open-edges") === "0", `tubes: open edges ${await value("open-edges")}`);
    await set(at("inflate.height"), "1");
    check(await value("option-tube-radius") === "0" && await hash() === balloon, "and a balloon has no tubes");
    await page.click("#link");
    const shape = await page.evaluate(() => location.hash);
    await open(shape);
    check(await hash() === balloon, "a link brings a balloon back");
    await set(at("inflate.height"), "0");
    check(await hash() === straight, "and without air it is as before");
    await open("#text=Hi&depth=0.4&bend.cylinder=360");
    check(/folds the letters/.test(await message()), `a text that is bent too tightly is told: ${await message()}`);
    await set(at("bend.cylinder"), "40");
    check(await message() === "", "and is built when it is bent less");
});

// Views.
await part("views", async () => {
    for (const [name, link] of [["bent", "#bend.cylinder=180"], ["inflated", "#inflate.height=1&text=Ra8"]]) {
        await open(link);
        await compare(name);
    }
    for (const view of ["wireframe", "normals", "texture", "contours"]) {
        await open(`#view=${view}&text=Ra8`);
        await compare(view);
    }
    await open("#view=contours&text=i");
    check(await page.evaluate(() => {
        const text = document.getElementById("text"), { page } = globalThis;
        text.value = "many words ".repeat(60);
        text.dispatchEvent(new Event("input", { bubbles: true }));
        return page.stage.group.children[0].geometry.attributes.position.array.length === 3 * page.mesh.statistics.vertices;
    }), "contours need memory, and letters are drawn all the same");
    await open("#page.motion=score&text=1984&view=contours");
    check(await page.evaluate(() => globalThis.page.shown) === "1984", "the contours of a score are its number's");
    await open("#text=" + encodeURIComponent("Dark and narrow"), { width: 360, height: 700, dark: true });
    await compare("phone-dark");
    check(await page.evaluate(() => document.scrollingElement.scrollWidth <= 360), "nothing is wider than a phone");
});

// A phone: while an option is used, the mesh is in view.
await part("phone", async () => {
    for (const [width, height] of [[360, 700], [390, 844], [740, 360], [820, 1180]]) {
        await open("#text=Phone", { width, height });
        const seen = await page.evaluate(() => {
            document.getElementById("png").scrollIntoView();
            const box = e => document.getElementById(e).getBoundingClientRect(), [stage, button] = [box("stage"), box("png")];
            return { stage: Math.min(stage.bottom, innerHeight) - Math.max(stage.top, 0), button: button.top >= 0 && button.bottom <= innerHeight + 1, wide: document.scrollingElement.scrollWidth };
        });
        check(seen.stage >= Math.min(240, 0.6 * height) && seen.button && seen.wide <= width, `at ${width} x ${height} the stage stays: ${JSON.stringify(seen)}`);
    }
});

// Presets: each is one click, and its link opens as it was made.
await part("presets", async () => {
    await open("", { width: 500, height: 400 });
    const names = await page.$$eval("#presets a", all => all.map(e => e.className));
    check(names.length >= 8, `there are ${names.length} presets`);
    for (const name of names) {
        await change(() => page.click(`#presets .${name}`));
        await unhurried();
        await rest(600);
        await page.waitForFunction(() => document.getElementById("open-edges").value !== "…");
        const [made, hash_of_link] = [await hash(), await page.evaluate(() => location.hash)];
        check(await message() === "" && await value("open-edges") === "0", `${name}: ${await message()} ${await value("open-edges")}`);
        check(await page.$eval(`#presets .${name}`, e => e.getAttribute("aria-current")) === "true", `${name} is marked as what is shown`);
        const claim = await page.evaluate(name => globalThis.page.presets.find(p => p.name === name).claim.replace("{triangles}", document.getElementById("triangles").value), name);
        check(claim !== "" && !/[{}]/.test(claim) && await value("caption") === claim, `${name} says what it shows: ${await value("caption")}`);
        check(await value("notes") === "" || /prefers less motion/.test(await value("notes")), `${name} has nothing to explain: ${await value("notes")}`);
        programs.push({ name, ...await program() });
        await open(hash_of_link, { width: 500, height: 400 });
        await unhurried();
        check(await hash() === made, `the link of ${name} opens as it was made`);
    }
});

// Tags.
await part("tags", async () => {
    await open("#text=" + encodeURIComponent("[b]A[/b] [colour=#ff0000]B[/colour] [size=2]C[/]"));
    check(await page.evaluate(() => globalThis.page.mesh.tint.length === 4 * globalThis.page.mesh.statistics.vertices && globalThis.page.mesh.tint.includes(255)), "tags colour letters");
    check(await value("open-edges") === "0" && await page.evaluate(() => globalThis.page.mesh.statistics.glyphs) === 5, "tags are no letters");
    await set("#text", "[b");
    check(/^Tags are not read yet: at character 1/.test(await value("notes")) && await message() === "", `a tag that is not complete is told: ${await value("notes")}`);
    await open("#bend.wave=0.1&text=" + encodeURIComponent("[b"));
    await page.click("#program summary");
    await page.waitForFunction(() => document.getElementById("code").textContent !== "");
    check(!/tags/.test(await value("code")), "the program of such a text has it as it stands");
    await set("#text", "[i");
    check(/"\[i"/.test(await value("code")), "and follows what is typed");
    await open("#text=" + encodeURIComponent("one two"));
    await page.$eval("#text", e => e.setSelectionRange(4, 7));
    await change(() => page.click("#tags [data-tag=b]"));
    check(await value("text") === "one [b]two[/]", `a button puts a tag around what is selected: ${await value("text")}`);
});

// Undo and redo, of text and options alike.
await part("undo", async () => {
    await open();
    check(await page.$eval("#undo", e => e.disabled), "there is nothing to undo yet");
    const origin = await hash();
    await set("#text", "Other");
    await rest(1100);
    await set("#option-depth", "0.5");
    check(await page.$eval("#undo", e => !e.disabled), "there is something to undo");
    await change(() => page.click("#undo"));
    check(await value("text") === "Other" && await value("option-depth") === "0.2", "Undo takes the last change back");
    await page.focus("#text");
    await page.keyboard.down("Control");
    await change(() => page.keyboard.press("z"));
    check(await value("text") === "Hello world!" && await hash() === origin, "Ctrl+Z takes the one before back");
    await change(() => page.keyboard.press("y"));
    check(await value("text") === "Other", "Ctrl+Y does it again");
    await page.keyboard.up("Control");
    await change(() => page.click("#undo"));
    await change(() => page.click("#redo"));
    check(await value("text") === "Other" && await page.$eval("#redo", e => !e.disabled), "so does Redo, as long as there is more");
    const comes = async (text, font) => {
        await page.waitForFunction((t, f) => document.getElementById("text").value === t && document.getElementById("font").value === f, {}, text, font);
        await rest(500);
    };
    const own_font = await value("font");
    await rest(1100);
    await change(() => pick("DejaVu Sans Bold"));
    const bold = await hash();
    await page.click("#undo");
    await comes("Other", own_font);
    await page.click("#undo");
    await comes("Hello world!", own_font);
    await page.focus("#canvas");
    await page.keyboard.down("Control");
    for (const font of [own_font, "DejaVu Sans Bold"]) {
        await page.keyboard.press("y");
        await comes("Other", font);
    }
    await page.keyboard.up("Control");
    check(await hash() === bold, "a change of the font is taken back, and done again");
});

// Weights.
await part("weights", async () => {
    await open();
    const origin = await hash();
    await set("#option-page-weight", "300");
    check(await hash() !== origin && await value("open-edges") === "0", "another weight is another mesh");
    await change(() => pick("DejaVu Sans Bold"));
    check(await page.$eval("#option-page-weight", e => e.closest(".row").hidden), "a font of one weight has no slider for it");
});

// A slow turn until the mesh is touched.
await part("turn", async () => {
    await open("", { still: false });
    const before_turn = await canvas(), band = await page.evaluate(async () => {
        const { stage } = globalThis.page;
        stage.turn(true);
        for (let i = 0; i < 100 && !stage.wires?.visible; ++i) await new Promise(done => setTimeout(done, 50));  // frames may be late
        const label = document.getElementById("label");
        return [stage.wires?.visible === true, stage.mirror.children.includes(stage.mirrored[0]), label.hidden ? "" : label.textContent];
    });
    check(band[0] && band[1], "a band of wires passes while it comes in, also in the mirror");
    check(band[2] === `${await value("triangles")} triangles, one closed mesh, 0 open edges`, `and says what is seen: ${band[2]}`);
    await rest(1500);
    check(await canvas() !== before_turn && await page.$eval("#turn", e => e.getAttribute("aria-pressed")) === "true", "the mesh turns by itself");
    await page.focus("#canvas");
    await page.keyboard.press("ArrowRight");
    await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
    check(await page.evaluate(() => !globalThis.page.stage.wires?.visible && document.getElementById("label").hidden), "no band of wires is left");
    const touched = await canvas();
    await rest(900);
    check(await canvas() === touched && await page.$eval("#turn", e => e.getAttribute("aria-pressed")) === "false", "and rests once it is touched");
    const turns = () => page.$eval("#turn", e => e.getAttribute("aria-pressed") === "true");
    const sample = name => change(() => page.$eval(`#presets .${name}`, e => e.click()));
    await sample("chrome");
    check(await turns(), "until there is another sample");
    await page.click("#turn");
    await sample("arabic");
    check(!await turns(), "unless somebody has ended the turning");
    await open();
    await page.focus("#canvas");
    await page.keyboard.press("ArrowRight");
    check(await page.evaluate(() => globalThis.page.stage.moved), "a key moves the camera");
    await sample("chrome");
    check(await page.evaluate(() => !globalThis.page.stage.moved), "and a sample is seen from the front, where nothing turns as well");
});

// A weight that breathes.
await part("breathing", async () => {
    await open("#page.motion=breathe&text=" + "breathing ".repeat(4), { still: false });
    const weights = await page.evaluate(() => {
        const { mesh, stage } = globalThis.page, begun = performance.now();
        for (let i = 0; i < 60; ++i) stage.breath(70 * i);
        return { ms: performance.now() - begun, vertices: mesh.statistics ? globalThis.page.mesh.statistics.vertices : 0 };
    });
    figures.push(`60 weights of a text of 40 letters, ${weights.vertices} vertices, without drawing: ${weights.ms.toFixed(0)} ms`);
    check(weights.vertices > 1000, `${weights.vertices} vertices breathe`);

    const slider = await value("option-page-weight");
    await page.waitForFunction(was => document.getElementById("option-page-weight").value !== was, {}, slider);  // it goes with the weight
    check(/^weight \d+$/.test(await page.$eval("#label", e => e.hidden ? "" : e.textContent)), "the weight is said");
    await set("#option-page-weight", "300");
    check(await page.$eval("#label", e => !/^weight/.test(e.hidden ? "" : e.textContent)), "only while it changes");
    check(await value("option-page-motion") === "still" && await value("option-page-weight") === "300", "and who moves it ends the breathing");

    await open("#page.motion=breathe&page.tags=0&text=" + encodeURIComponent("a[1]"), { width: 420, height: 320, still: false });
    check(await page.evaluate(() => globalThis.page.mesh.statistics.glyphs) === 4, "brackets breathe too where tags are not read");
    await open("#page.motion=breathe&text=" + encodeURIComponent("[b]a[/][[1]"), { width: 420, height: 320, still: false });
    check(await page.evaluate(() => globalThis.page.mesh.statistics.glyphs) === 4, "and where they are read, tags are no letters");
    await set("#text", "a[b");
    check(/^Tags are not read yet: at character 2/.test(await value("notes")), `a tag that is not complete is told: ${await value("notes")}`);
    await page.evaluate(() => globalThis.page.stage.turn(false));

    const fetched = [], asks = r => { if (/\/fonts\//.test(r.url())) fetched.push(r.url()); };
    page.on("request", asks);
    await open("#page.motion=breathe&text=" + encodeURIComponent("A\u3042"), { width: 420, height: 320, still: false });
    check(fetched.length === 1 && /^(?!.*No font).*Only letters of the chosen font breathe\.$/.test(await value("notes")), `what breathes is of one font: ${await value("notes")}`);
    page.off("request", asks);
    await open("#page.motion=breathe&view=contours&text=Air", { width: 420, height: 320, still: false });
    const rings = await hash();
    await rest(500);
    check(await hash() === rings, "contours do not breathe");
});

// Fonts.
await part("fonts", async () => {
    await open();
    const before = await hash();
    await change(() => drop("Dropped.ttf", fs.readFileSync(path.join(site, bundled[1].file))));
    check(await value("font") === "Dropped.ttf" && await hash() !== before, "a dropped font is used");
    const kept = await hash();
    await change(() => drop("web.woff2", Buffer.from("wOF2 and more")));
    check(/^web\.woff2: .*\.ttf or \.otf\.$/.test(await message()), `a font packed for web pages is refused in words: ${await message()}`);
    await drop("junk.ttf", Buffer.from("no font at all"));
    await page.waitForFunction(() => document.getElementById("message").textContent.startsWith("junk.ttf"));
    check(/^junk\.ttf: .+\.$/.test(await message()), `a file that is no font is refused in words: ${await message()}`);
    check(await hash() === kept && await value("font") === "Dropped.ttf", "and nothing else changes");
});

// Of two choices the newer one counts, though its font is there and the other's arrives late.
await part("choices", async () => {
    await open();
    const first = await hash();
    held.set(path.basename(bundled[2].file), []);
    await pick(offered[2]);
    check(await loading() === `Loading ${offered[2]}…`, `what is awaited is said: ${await loading()}`);
    await change(() => pick(offered[0]));
    check(await loading() === "", "nothing is awaited after another choice");
    for (const answer of held.get(path.basename(bundled[2].file))) answer();
    held.clear();
    await new Promise(done => setTimeout(done, 700));
    check(await value("font") === offered[0] && await hash() === first, `the newer choice counts: ${await value("font")}`);
    await change(() => pick(offered[2]));
    check(await value("font") === offered[2] && await hash() !== first, "the late font can be chosen afterwards");
    const late = path.basename(bundled[2].file);
    held.set(late, []);
    await page.goto("about:blank");
    await page.goto(home + "#font=" + encodeURIComponent(offered[2]), { waitUntil: "domcontentloaded" });
    await page.waitForFunction(name => document.getElementById("loading").textContent === `Loading ${name}…`, {}, offered[2]);
    const picked = path.basename(bundled[1].file);
    held.set(picked, []);
    await pick(offered[1]);
    for (const file of [late, picked]) {  // what was asked for first comes first
        for (const answer of held.get(file)) answer();
        held.delete(file);
        await rest(500);
    }
    await settled(0);
    check(await value("font") === offered[1], `so does a choice while the page begins: ${await value("font")}`);
});

// What the chosen font lacks comes from the page's fonts of its scripts, and only these are fetched.
await part("scripts", async () => {
    const fetched = [];
    page.on("request", r => { if (/\/fonts\//.test(r.url())) fetched.push(path.basename(r.url())); });
    const complete = () => page.waitForFunction(() => globalThis.page.mesh.statistics.missing === 0 && !/on its way/.test(document.getElementById("notes").textContent));
    const scripts = { Devanagari: "\u0928\u092e\u0938\u094d\u0924\u0947", Arabic: "\u0645\u0631\u062d\u0628\u0627", Japanese: "\u3053\u3093\u306b\u3061\u306f\u4e16\u754c", Hebrew: "\u05e9\u05dc\u05d5\u05dd", emoji: "\u{1f680}\u{1f389}" };
    for (const [name, words] of Object.entries(scripts)) {
        const own = bundled.find(f => f.name.endsWith(`(${name})`));
        if (!own) continue;
        fetched.length = 0;
        await open("#text=" + encodeURIComponent("A " + words), { width: 420, height: 320 });
        await complete();
        check(fetched.join() === [bundled[0], own].map(f => path.basename(f.file)).join(), `${name} comes from its own font: ${fetched}`);
        check(await value("notes") === "" && await message() === "", `and all is well: ${await value("notes")}`);
    }
    const world = Object.values(scripts).join(" ");
    await open("#text=" + encodeURIComponent(world), { width: 420, height: 320 });
    await complete();
    await rest(500);
    const mixed = await hash();
    await open("#font=DejaVu Sans&text=" + encodeURIComponent(scripts.Arabic), { width: 420, height: 320 });
    await change(() => pick(offered[0]));
    await set("#text", world);
    await complete();
    await rest(500);
    check(await hash() === mixed, "a text is set in the same fonts, whatever was shown before");
    await set("#text", "A\u{10FFFD}");
    await page.waitForFunction(() => /No font has a glyph/.test(document.getElementById("notes").textContent));
    check(true, "what no font of the page has is reported");
    await open();
});

// A tab whose frames are late, as a hidden one's are: by then other meshes have been made, and the memory has grown.
await part("late", async () => {
    const late = await browser.newPage(), said = [];
    late.setDefaultTimeout(120000);
    await late.setViewport({ width: 420, height: 320 });
    await late.evaluateOnNewDocument(() => {
        const ask = globalThis.requestAnimationFrame;
        globalThis.requestAnimationFrame = call => setTimeout(() => ask(call), 3000);
    });
    late.on("console", m => said.push(m.text()));
    await late.goto(home + "#text=" + "word ".repeat(40), { waitUntil: "domcontentloaded" });
    await late.waitForFunction(() => document.documentElement.dataset.measured === "1");
    await late.$eval("#text", e => { e.value = "other words ".repeat(80); e.dispatchEvent(new Event("input", { bubbles: true })); });
    await late.waitForFunction(() => document.documentElement.dataset.measured === "2");
    await rest(5000);
    check(said.length === 0, `a mesh that is drawn late is whole: ${said[0]}`);
    await late.close();
});

// Empty and long texts; their links.
await part("long", async () => {
    await open();
    await set("#text", "");
    check(/There is no text/.test(await value("notes")) && await message() === "", "an empty text is told");
    await set("#text", "word ".repeat(4000));
    check(await message() === "", "20,000 characters become a mesh");
    check(await value("caption") === "", "and are not the page's own text");
    await page.click("#link");
    await page.waitForFunction(() => /no text/.test(document.getElementById("link").textContent), { polling: "mutation" });  // it says so for two seconds
    check((await page.evaluate(() => location.href)).length < 2500, "their link is short, and the button says that it has no text");
    const long = await hash();
    await set("#text", "word ".repeat(40000));
    check(/200,000 characters/.test(await message()) && await hash() === long, `an overlong text is told: ${await message()}`);
});

// Link.
await part("link", async () => {
    await open("#text=Link&bevel.profile=chamfer&depth=0.3&view=normals");
    await page.click("#link");
    const address = await page.evaluate(() => location.hash), linked = await hash();
    await open(address);
    check(await hash() === linked && await value("option-bevel-profile") === "chamfer", "the link brings the mesh back");
    await change(() => page.click("#reset"));
    check(await value("text") === "Hello world!" && await value("option-bevel-profile") === "round", "Reset sets everything back");
});

// What stands before the #, and a # that changes before the fonts are known.
await part("address", async () => {
    await open("?from=here");
    await rest(400);
    check(await page.evaluate(() => location.search) === "?from=here", "the address keeps its query");
    held.set("fonts.json", []);
    await page.goto("about:blank");
    await page.goto(home, { waitUntil: "domcontentloaded" });
    await page.evaluate(() => { location.hash = "#text=Early"; });
    await rest(300);
    for (const answer of held.get("fonts.json")) answer();
    held.clear();
    await settled(0);
    check(await value("text") === "Early" && await page.evaluate(() => globalThis.page.mesh.statistics.glyphs) === 5, "a link that comes early is taken");
});

// Letters that move, and those of somebody who wants less motion.
await part("motion", async () => {
    for (const motion of ["wave", "reveal", "scatter", "typewriter", "flag", "score", "breathe"]) {
        await open(`#page.motion=${motion}&text=${motion === "score" ? "1984" : "They move"}`, { still: false });
        await page.evaluate(() => globalThis.page.stage.turn(false));  // only the letters
        const early = await canvas();
        let moved = false;  // a typewriter waits when all is written
        for (let i = 0; i < 8 && !moved; ++i, await rest(400)) moved = await canvas() !== early;
        check(moved, `letters move: ${motion}`);
        check(await message() === "" && await value("open-edges") === "0", `${motion}: ${await message()}`);
    }
    await open("#page.motion=wave&text=They move", { still: true });
    const still = await canvas();
    await rest(900);
    check(await canvas() === still && /prefers less motion/.test(await value("notes")), "letters stay where less motion is asked for");
    await open();
});

// Keys.
await part("keys", async () => {
    await open("#depth=0.3");
    await set("#option-depth", "0.4");  // there is something to undo
    const upright = await canvas();
    await page.focus("#canvas");
    for (let i = 0; i < 6; ++i) await page.keyboard.press("ArrowRight");
    const turned = await canvas();
    check(turned !== upright, "arrow keys turn the mesh");
    await page.keyboard.press("+");
    check(await canvas() !== turned, "plus zooms");
    const reached = new Set();
    await page.evaluate(() => document.activeElement.blur());
    for (let i = 0; i < 90; ++i) {
        await page.keyboard.press("Tab");
        reached.add(await page.evaluate(() => document.activeElement.id));
    }
    for (const id of ["canvas", "turn", "text", "font", "file", "undo", "option-depth", "ticker", "glb", "reset"]) check(reached.has(id), `the Tab key reaches ${id}`);
});

// Who types anywhere types the text; long texts end their lines; buttons that lead further.
await part("visitor", async () => {
    await open();
    await page.evaluate(() => document.activeElement.blur());
    await change(() => page.keyboard.type("Hi"));
    check(await value("text") === "Hi", `what is typed anywhere replaces the page's own text: ${await value("text")}`);
    await page.focus("#canvas");
    await change(() => page.keyboard.type("!"));
    check(await value("text") === "Hi!", `and comes after one's own: ${await value("text")}`);
    await set("#text", "one\r\ntwo");
    check(await page.evaluate(() => globalThis.page.mesh.statistics.lines) === 2, "pasted line ends are line ends");
    await set("#text", "A text that somebody pastes, without a line end anywhere. ".repeat(5));
    const { lines, width, height } = await page.evaluate(() => {
        const { low, high } = globalThis.page.mesh.bounds;
        return { lines: globalThis.page.mesh.statistics.lines, width: high[0] - low[0], height: high[1] - low[1] };
    });
    check(lines > 4 && width < 4 * height, `a long text ends its lines: ${lines} lines, ${width} by ${height}`);
    await set(at("wrap"), "none");
    check(await page.evaluate(() => globalThis.page.mesh.statistics.lines) === 1, "unless that is not wanted");
    await page.click("#show-program");
    check(await page.$eval("#program", e => e.open) && /mesher\.build/.test(await value("code")), "the code is one click away");
    check(await page.evaluate(() => [{ "text/plain": "words" }, {}].every(some => {
        const carried = new DataTransfer();
        for (const kind in some) carried.setData(kind, some[kind]);
        return document.getElementById("text").dispatchEvent(new DragEvent("drop", { dataTransfer: carried, bubbles: true, cancelable: true }));
    })), "words that are dragged go where they always go");
});

// A link with wrong values.
await part("values", async () => {
    await open("#depth=abc&embolden=&bevel.width=7&page.finish=wood&page.colour=%23FF8800&page.rainbow=true&view=upside&nothing=1&text=a%");
    check(await message() === "" && await value("notes") === "", `a link with wrong values has nothing to say: ${await message()} ${await value("notes")}`);
    const now = await page.evaluate(() => ["depth", "embolden", "bevel-width", "page-finish", "page-colour"].map(name => document.getElementById("option-" + name).value).join());
    check(now === "0.2,0,0.12,satin,#ff8800", `what is no value is passed over, what is too much is cut: ${now}`);
    check(await page.$eval(at("page.rainbow"), e => e.checked) && await page.$eval("#view-solid", e => e.checked), "and the rest is taken");
});

// What may be missing: WebAssembly, a font, the picture that the graphics card had.
await part("missing", async () => {
    const opened = async (before = () => {}) => {
        const other = await browser.newPage();
        other.on("pageerror", e => check(false, `with something missing the page throws: ${e.message}`));
        await other.evaluateOnNewDocument(before);
        await other.goto(home, { waitUntil: "domcontentloaded" });
        return other;
    };
    const told = other => other.waitForFunction(() => !document.getElementById("message").hidden).then(() => other.$eval("#message", e => e.textContent));
    let other = await opened(() => { delete globalThis.WebAssembly; });
    check(/no WebAssembly/.test(await told(other)) && await other.$eval("#loading", e => e.hidden), "a browser without WebAssembly is told");
    await other.click("#glb");
    check(/no mesh yet/.test(await other.$eval("#message", e => e.textContent)), "and that nothing can be saved");
    await other.close();
    lost.add("typemesh.wasm");
    other = await opened();
    check(/typemesh\.wasm could not be loaded: .*404/.test(await told(other)), "a module that is not there is told");
    await other.close();
    lost.clear();
    lost.add(path.basename(bundled[0].file));
    other = await opened();
    await other.waitForFunction(() => document.documentElement.dataset.measured);
    check(await other.$eval("#font", e => e.value) === offered[1], "where the first font is not there the page begins with the next");
    await other.close();
    lost.clear();
    other = await opened();
    await other.waitForFunction(() => document.documentElement.dataset.measured);
    const colours = () => other.evaluate(() => {
        const { stage } = globalThis.page, gl = stage.renderer.getContext(), pixels = new Uint8Array(4 * 32 * 32), seen = new Set();
        stage.turn(false);  // no band of wires
        stage.drawNow();
        gl.readPixels(gl.drawingBufferWidth / 2 - 16, gl.drawingBufferHeight / 2 - 16, 32, 32, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        for (let i = 0; i < pixels.length; i += 4) seen.add(pixels[i] > 1.5 * pixels[i + 2]);
        return seen.has(true);  // the letters are orange
    });
    check(await colours(), "the letters are drawn");
    await other.evaluate(async () => {
        const { stage } = globalThis.page, away = stage.renderer.getContext().getExtension("WEBGL_lose_context");
        const comes = name => new Promise(done => stage.canvas.addEventListener(name, done, { once: true }));
        const lost = comes("webglcontextlost"), restored = comes("webglcontextrestored");
        away.loseContext();
        await lost;
        await new Promise(done => setTimeout(done, 100));
        away.restoreContext();
        await restored;
        await new Promise(done => setTimeout(done, 100));
    });
    check(await colours(), "and again after the graphics card has lost them");
    await other.close();
});

// Files.
await part("files", async () => {
    const openToSave = async (...how) => {
        await open(...how);
        await page.evaluate(() => {
            globalThis.saved = [];
            URL.createObjectURL = blob => (saved.push(blob), "data:,");
            HTMLAnchorElement.prototype.click = () => {};
        });
    };
    await openToSave();
    for (const [id, begins] of [["glb", "glTF"], ["stl", null], ["png", "\x89PNG"]]) {
        const count = await page.evaluate(() => saved.length);
        await page.click("#" + id);
        await page.waitForFunction(n => saved.length > n, {}, count);
        const [size, head] = await page.evaluate(async () => [saved.at(-1).size, String.fromCharCode(...new Uint8Array(await saved.at(-1).slice(0, 4).arrayBuffer()))]);
        if (begins) check(head === begins && size > 1000, `${id}: ${size} bytes, ${JSON.stringify(head)}`);
        else check(size === 84 + 50 * Number((await value("triangles")).replace(/,/g, "")), `${id}: ${size} bytes for ${await value("triangles")} triangles`);
    }

    /** What was saved last, once the button has been clicked. */
    async function savedBy(id) {
        const count = await page.evaluate(() => saved.length);
        await page.click("#" + id);
        await page.waitForFunction(n => saved.length > n, {}, count);
        return Buffer.from(await page.evaluate(async () => [...new Uint8Array(await saved.at(-1).arrayBuffer())]));
    }
    const glb = await savedBy("glb"), nodes = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString());
    const words = await value("text");
    check(nodes.nodes.every(n => n.name), "every node of a GLB has a name");
    check(nodes.nodes.some(n => n.name === words && n.extras?.text === words), "a GLB holds its text");
    check(nodes.materials.some(m => m.name === "front") && nodes.materials.every(m => m.name), "a GLB's materials are named by their parts");
    await set("#text", "a[colour=#0000ff]b[/]");
    const tinted = await savedBy("glb"), said = JSON.parse(tinted.subarray(20, 20 + tinted.readUInt32LE(12)).toString());
    check(said.meshes[0].primitives.every(p => p.attributes.COLOR_0 !== undefined), "a GLB has the colours of tags");
    await set("#text", words);
    const stl = await savedBy("stl"), low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let t = 84; t < stl.length; t += 50)
        for (let i = 0; i < 9; ++i) {
            const at = stl.readFloatLE(t + 12 + 4 * i);
            low[i % 3] = Math.min(low[i % 3], at);
            high[i % 3] = Math.max(high[i % 3], at);
        }
    const own = await page.evaluate(() => globalThis.page.mesh.bounds);
    check(low[2] === 0, `an STL lies on z = 0, not ${low[2]}`);
    for (const k of [0, 1, 2]) {
        const ratio = (high[k] - low[k]) / (own.high[k] - own.low[k]);
        check(Math.abs(ratio - 10) < 1e-4, `an STL is in millimetres, ten a unit, not ${ratio}`);
    }
    const deep = await value("option-depth");
    await set("#option-depth", "0");
    await page.click("#stl");
    await page.waitForFunction(() => !document.getElementById("message").hidden);
    check(/depth must be more than 0/.test(await message()), "an STL without depth is refused in words");
    await set("#option-depth", deep);

    const triangles = bytes => (bytes.length - 84) / 50, shown = async () => Number((await value("triangles")).replace(/,/g, ""));
    await set("#text", "Hi");
    await set("#option-depth", "0.4");
    await set("#option-bend-cylinder", "360");
    check(/folds the letters/.test(await message()), `a text that is bent too tightly is refused: ${await message()}`);
    check(triangles(await savedBy("stl")) === await shown() && await value("open-edges") !== "", "and the mesh that is still seen can be saved");
    await openToSave("#page.motion=breathe&text=Air", { width: 420, height: 320, still: false });
    for (const id of ["glb", "stl"]) check((await savedBy(id)).length > 1000 && await message() === "", `a text that breathes is saved as ${id}: ${await message()}`);
    await openToSave("#page.motion=score&text=1984", { width: 420, height: 320, still: false });
    const number = triangles(await savedBy("stl"));
    check(number > 100 && number < 0.5 * await shown(), `a score is saved as its number: ${number} triangles`);
    await open();
});

// A thousand characters a frame.
await part("ticker", async () => {
    await open();
    await page.click("#ticker");
    await page.waitForFunction(() => Number(document.getElementById("rate").value) > 0);  // however slow
    figures.push(`1,000 new characters a frame: ${await value("rate")} frames a second, drawn in software without a graphics card`);
    const turned = await page.evaluate(() => (globalThis.page.stage.turn(true), globalThis.page.stage.turned));
    await put("#option-depth", "0.5");
    await page.waitForFunction(() => globalThis.page.mesh.bounds.high[2] - globalThis.page.mesh.bounds.low[2] > 0.45);
    check(await page.$eval("#ticker", e => e.getAttribute("aria-pressed")) === "true", "a slider changes the letters that race");
    await page.waitForFunction(was => globalThis.page.stage.turned !== was, {}, turned);
    check(await value("caption") === "", "a race has no claim");
    await change(() => page.click("#ticker"));
    check(await message() === "" && await page.evaluate(() => globalThis.page.shown) === "Hello world!", "afterwards the text is there again");
    await page.click("#ticker");
    await change(() => page.click("#presets .chrome"));
    check(await page.$eval("#ticker", e => e.getAttribute("aria-pressed")) === "false" && await page.$eval("#frames", e => e.hidden), "a sample ends the race");
    const chrome = await page.evaluate(() => globalThis.page.shown);
    await rest(500);
    check(await page.evaluate(() => globalThis.page.shown) === chrome && chrome === await value("text"), `and is what is seen: ${chrome}`);
});

// Accessibility, if npm's axe-core is there.
await part("axe", async () => {
    const axe = path.join(process.env.NODE_PATH, "axe-core", "axe.min.js");
    if (fs.existsSync(axe))
        for (const how of [{}, { dark: true }, { width: 360, height: 700 }, { width: 360, height: 700, dark: true }, { width: 740, height: 360 }]) {
            await open("", how);
            await page.$$eval("#panel details", all => all.forEach(e => { e.open = true; }));
            await page.evaluate(fs.readFileSync(axe, "utf8"));
            const found = await page.evaluate(async () => (await globalThis.axe.run()).violations.map(v => `${v.id}: ${v.nodes.map(n => n.target).join("; ")}`));
            check(found.length === 0, `axe, ${JSON.stringify(how)}: ${found.join(" | ")}`);
        }
});

// The programs for what was on the screen make the same meshes.
await part("programs", async () => {
    await open("#text=One two three four&width=6&align=left&embolden=0.01&features=kern%3D0&bevel.profile=chamfer&quality=low");
    programs.push({ name: "paragraph", ...await program() });
    await open("#text=hollow&outline.width=0.02&path.wave=0.3&triangulator=delaunay");
    programs.push({ name: "hollow", ...await program() });
    for (const [name, text] of [["dash", "-a@\\nb"], ["at", "@a"]]) {
        await open("#text=" + encodeURIComponent(text));
        programs.push({ name, ...await program() });
    }
    await open("#page.motion=breathe&text=" + encodeURIComponent("[b]tags[/] [[1]"), { still: false });
    programs.push({ name: "tagged", ...await program() });
    const folder = fs.mkdtempSync(path.join(site, "..", "programs-")), compiler = process.env.CXX ?? "c++";
    const flags = () => execFileSync("pkg-config", ["--cflags", "--libs", "harfbuzz"], { encoding: "utf8" }).trim().split(/\s+/);
    const include = path.join(site, "..", "..", "..", "include");
    if (spawnSync("pkg-config", ["--exists", "harfbuzz"]).status === 0)
        for (const { name, code, font, others, vertices, triangles, command, javascript, position, index } of programs) {
            const [source, binary, written] = [path.join(folder, `${name}.cpp`), path.join(folder, name), path.join(folder, `${name}.bytes`)];
            fs.writeFileSync(source, code.replace("    std::printf(", `    if (std::FILE* const file = std::fopen(argv[argc - 1], "wb")) {
        std::fwrite(vertices.data(), sizeof vertices[0], vertices.size(), file);
        std::fwrite(indices.data(), sizeof indices[0], indices.size(), file);
        std::fclose(file);
    }
    std::printf(`));
            const compiled = spawnSync(compiler, ["-std=c++20", "-O0", "-Wall", "-I", include, source, ...flags(), "-o", binary], { encoding: "utf8" });
            check(compiled.status === 0 && compiled.stderr === "", `the program for ${name} compiles: ${compiled.stderr}\n${code}`);
            if (compiled.status !== 0) continue;
            const said = spawnSync(binary, [...[font, ...others].map(f => path.join(site, "fonts", f)), written], { encoding: "utf8" }).stdout.trim();
            const same = said === `${vertices} vertices, ${triangles} triangles`;
            // Tags such as [b] are solids of their own, which the program names and leaves to its reader.
            if (/markup_styles/.test(code)) check(/^[1-9]\d+ vertices/.test(said), `the program for ${name} makes a mesh: ${said}`);
            else check(same, `the program for ${name} makes ${said}, the page ${vertices} and ${triangles}`);
            if (same && !/axis_morph/.test(code)) {  // what breathes has another weight by now
                const [mine, its] = [Buffer.concat([position, index].map(p => Buffer.from(p, "base64"))), fs.readFileSync(written)];
                const far = at => Math.abs(mine.readFloatLE(at) - its.readFloatLE(at)), places = Array.from({ length: 3 * vertices }, (_, i) => 4 * i);
                // A bend goes by the text's width, which the program has in six digits.
                const isSame = /typemesh::bent</.test(code) ? mine.subarray(12 * vertices).equals(its.subarray(12 * vertices)) && places.every(at => far(at) < 1e-5) : mine.equals(its);
                check(isSame && mine.length === its.length, `the program for ${name} makes the page's mesh: up to ${places.reduce((most, at) => Math.max(most, far(at) || 0), 0)} em away`);
            }
            if (process.env.TYPEMESH_TEXT_TO_MESH) {
                const words = command.replace(/--(font|fallback) /g, `$&${path.join(site, "fonts")}/`).replace("-o text.glb", `-o ${binary}.glb`);
                const ran = spawnSync("sh", ["-c", words.replace(/\btext_to_mesh\b/, () => process.env.TYPEMESH_TEXT_TO_MESH)], { encoding: "utf8" });
                check(ran.status === 0, `the command for ${name} runs: ${words}\n${ran.stderr}`);
            }
            fs.writeFileSync(path.join(folder, `${name}.mjs`), javascript);
            check(spawnSync("node", ["--check", path.join(folder, `${name}.mjs`)]).status === 0, `the JavaScript for ${name} is well formed`);
        }
    else console.log("    the programs are not compiled: pkg-config knows no harfbuzz");
    fs.rmSync(folder, { recursive: true });
});

// Without WebGL. What three.js says of it on the console is meant.
await part("blind", async () => {
    const blind = await browser.newPage();
    await blind.evaluateOnNewDocument(() => {
        const get = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return /webgl/.test(kind) ? null : get.call(this, kind, ...more); };
    });
    blind.on("pageerror", e => check(false, `without WebGL the page throws: ${e.message}`));
    await blind.goto(home, { waitUntil: "domcontentloaded" });
    await blind.waitForFunction(() => Number(document.documentElement.dataset.measured ?? 0) > 0);
    check(/offers no WebGL/.test(await blind.$eval("#notes", e => e.textContent)), "a browser without WebGL is told");
    check(Number((await blind.$eval("#triangles", e => e.value)).replace(/,/g, "")) > 0, "and the mesh is made");
    check(await blind.$eval("#loading", e => e.hidden), "and nothing goes on loading");
});

await browser.close();
server.close();
fs.writeFileSync(path.join(site, "..", "figures.txt"), figures.join("\n") + "\n");
console.log(figures.join("\n"));
console.log(`${passes} passed, ${failures} failed`);
process.exit(failures === 0 && passes > 0 ? 0 : 1);
