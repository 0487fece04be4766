// SPDX-License-Identifier: MIT
// engines.mjs SITE BROWSER TYPEMESH_JS: opens the bundled examples of examples/web/engines, and compares what they draw with the module's meshes.

import fs from "node:fs";
import http from "node:http";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [, , site, executablePath, script] = process.argv;
const puppeteer = createRequire(import.meta.url)(path.join(process.env.NODE_PATH, "puppeteer-core"));
const { load } = await import(pathToFileURL(script));
const typemesh = await load(), bytes = fs.readFileSync(path.join(site, "babylon", "font.ttf"));
const font = typemesh.font(bytes), bold = typemesh.font(bytes, { variations: { wght: 750 } });
let failures = 0, passes = 0;
const check = (good, words) => {
    if (good) ++passes;
    else console.log(`FAILED: ${words}`), ++failures;
};

const kinds = { ".js": "text/javascript", ".wasm": "application/wasm", ".glb": "model/gltf-binary" };
const server = http.createServer((request, response) => {
    const name = new URL(request.url, "http://x").pathname, file = path.join(site, name);
    if (name.endsWith("/")) {
        const body = name.includes("react") ? '<div id="root"></div>' : '<canvas id="canvas"></canvas>';
        return response.writeHead(200, { "content-type": "text/html" }).end(`<!doctype html><meta charset="utf-8"><title>example</title><link rel="icon" href="data:,">
<style>html, body, #root, canvas { width: 100%; height: 100%; margin: 0; overflow: hidden; } input { position: absolute; z-index: 1; }</style>
${body}<script type="module" src="main.js"></script>`);
    }
    if (!file.startsWith(site) || !fs.existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": kinds[path.extname(file)] ?? "application/octet-stream" });
    fs.createReadStream(file).pipe(response);
});
await new Promise(done => server.listen(0, "127.0.0.1", done));
const browser = await (puppeteer.default ?? puppeteer).launch({
    executablePath, protocolTimeout: 300000,
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--force-color-profile=srgb"],
});
const page = await browser.newPage();
await page.setViewport({ width: 640, height: 360 });
page.setDefaultTimeout(120000);
page.on("console", m => { if (m.type() === "error") check(false, `the console says: ${m.text()}`); });
page.on("pageerror", e => check(false, `the page throws: ${e.message}`));
const open = name => page.goto(`http://127.0.0.1:${server.address().port}/${name}/`, { waitUntil: "domcontentloaded" });
const told = name => page.evaluate(n => Number(document.documentElement.dataset[n] ?? 0), name);
const comes = (name, number) => page.waitForFunction((n, wanted) => Number(document.documentElement.dataset[n]) === wanted, {}, name, number).then(() => true, () => false);

/** Of the picture: the share that is not the background, and how many shades that has. */
async function picture(name) {
    await new Promise(done => setTimeout(done, 500));
    const seen = await page.screenshot({ encoding: "base64" });
    if (process.env.TYPEMESH_KEEP_PICTURES) fs.writeFileSync(path.join(process.env.TYPEMESH_KEEP_PICTURES, `${name}.png`), Buffer.from(seen, "base64"));
    const { share, shades } = await page.evaluate(async data => {
        const image = await createImageBitmap(await (await fetch("data:image/png;base64," + data)).blob());
        const pen = new OffscreenCanvas(image.width, image.height).getContext("2d");
        pen.drawImage(image, 0, 0);
        const { data: p } = pen.getImageData(0, 0, image.width, image.height), last = p.length - 4, found = new Set();
        let others = 0;
        for (let i = 0; i < p.length; i += 4)
            if ([0, 1, 2].some(k => Math.abs(p[i + k] - p[last + k]) > 24)) ++others, found.add(p[i] >> 3 << 10 | p[i + 1] >> 3 << 5 | p[i + 2] >> 3);
        return { share: 4 * others / p.length, shades: found.size };
    }, seen);
    check(share > 0.03 && share < 0.7 && shades > 20, `${name} shows a shaded text: ${(100 * share).toFixed(1)} % of the picture, ${shades} shades`);
    return seen;
}

// React-three-fiber.
const bevelled = { depth: 0.2, align: "centre", anchor: "middle", bevel: { width: 0.03, profile: "round" } };
const count = (text, options) => typemesh.mesh(text, bold, options).statistics.triangles;
await open("react_three_fiber");
check(await comes("triangles", count("React", bevelled)), `React-three-fiber has ${await told("triangles")} triangles`);
await picture("react_three_fiber");
await page.type("input", "!");
check(await comes("triangles", count("React!", bevelled)), `and follows what is typed: ${await told("triangles")}`);

// Babylon.js.
await open("babylon");
check(await comes("triangles", count("Babylon", { align: "centre", bevel: { width: 0.03, profile: "round" } })), `Babylon.js has ${await told("triangles")} triangles`);
const morph = typemesh.mesher(font).morph("breathes", "wght", { align: "centre", depth: 0.15 });
check(await comes("breathing", morph.at(morph.minimum).statistics.triangles), `and ${await told("breathing")} of the text that breathes`);
const earlier = await picture("babylon");
check(await picture("babylon") !== earlier, "which does");

// three.js plays a morph. Its places are those of the library: on each of the animation's lines one number is found for a weight, and
// then all vertices are to be there when the animation is played to it.
await open("three_morph");
await page.waitForFunction(() => globalThis.played);
const keys = await page.evaluate(() => {
    const { renderer, text, THREE, show } = globalThis.played;
    renderer.setAnimationLoop(null);
    globalThis.played.vertices = time => {
        show(time);
        text.updateMatrixWorld(true);
        const meshes = [], v = new THREE.Vector3(), all = [];
        text.traverse(node => { if (node.isMesh && node.matrixWorld.determinant() > 0) meshes.push(node); });
        for (let i = 0; i < meshes[0].geometry.attributes.position.count; ++i) all.push(...meshes[0].getVertexPosition(i, v).toArray());
        return all;
    };
    let triangles = 0;
    const { animation, duration } = globalThis.played, weights = animation.tracks.filter(t => t.name.endsWith(".morphTargetInfluences"));
    show(0);
    text.traverse(node => { if (node.isMesh && node.matrixWorld.determinant() > 0) triangles += node.geometry.index.count / 3; });
    return { times: [...new Set(weights.flatMap(t => [...t.times]))].sort((a, b) => a - b), duration, triangles };
});
const played = async time => Float64Array.from(await page.evaluate(t => globalThis.played.vertices(t), time));
const breathing = typemesh.mesher(font).morph(Array(4).fill("breathing!").join("\n"), "wght", { depth: 0.2, align: "start" });
const there = keys.times.filter(t => t <= keys.duration / 2 + 1e-6), at_keys = [];
for (const t of there) at_keys.push(await played(Math.min(t, keys.duration / 2 - 1e-9)));
let worst = 0, before = -1;
for (const weight of [100, 137, 250, 400, 555, 700, 811, 900]) {
    const wanted = Float64Array.from(breathing.at(weight).position);
    if (weight === 100) check(keys.triangles === breathing.at(weight).statistics.triangles, `the GLB has ${keys.triangles} triangles`);
    let best = { apart: Infinity };
    for (let k = 0; k + 1 < there.length; ++k) {
        const [a, b] = [at_keys[k], at_keys[k + 1]];
        if (a.length !== wanted.length || b.length !== wanted.length) continue;
        let along = 0, square = 0, apart = 0;
        for (let i = 0; i < a.length; ++i) along += (wanted[i] - a[i]) * (b[i] - a[i]), square += (b[i] - a[i]) ** 2;
        const share = Math.min(1, Math.max(0, along / square));
        for (let i = 0; i < a.length; ++i) apart = Math.max(apart, Math.abs(a[i] + share * (b[i] - a[i]) - wanted[i]));
        if (apart < best.apart) best = { apart, time: there[k] + share * (there[k + 1] - there[k]) };
    }
    check(best.time >= before, `a larger weight comes later: ${weight} at ${best.time}`);
    before = best.time;
    const shown = await played(Math.min(best.time, keys.duration / 2 - 1e-9));
    for (let i = 0; i < wanted.length; ++i) worst = Math.max(worst, Math.abs(shown[i] - wanted[i]));
}
check(worst < 4e-6, `vertices in three.js are ${worst} em from the library's`);
const { ms, vertices } = await page.evaluate(() => {
    const { show, duration, renderer, text } = globalThis.played, gl = renderer.getContext(), pixel = new Uint8Array(4);
    const frame = i => (show(duration * i / 60), gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel));  // until it is drawn
    frame(0);
    let least = Infinity, vertices = 0;
    for (let round = 0; round < 3; ++round) {
        const begun = performance.now();
        for (let i = 0; i < 60; ++i) frame(i);
        least = Math.min(least, performance.now() - begun);
    }
    text.traverse(node => { if (node.isMesh) vertices = Math.max(vertices, node.geometry.attributes.position.count); });
    return { ms: least, vertices };
});
await picture("three_morph");
console.log(`three.js plays 60 weights of a GLB of 40 letters, ${vertices} vertices, drawn in software at 640 x 360: ${ms.toFixed(0)} ms; vertices at most ${worst.toExponential(1)} em from the library's`);

await browser.close();
server.close();
console.log(`${passes} passed, ${failures} failed`);
process.exit(failures === 0 && passes > 0 ? 0 : 1);
