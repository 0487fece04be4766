// SPDX-License-Identifier: MIT
// arrival.mjs BROWSER ADDRESS: how much arrives before the first letter, and when, over a line of 200 kB/s and 300 ms.

import { createRequire } from "node:module";
import path from "node:path";

const [, , executablePath, address] = process.argv;
const puppeteer = createRequire(import.meta.url)(path.join(process.env.NODE_PATH, "puppeteer-core"));
const browser = await (puppeteer.default ?? puppeteer).launch({
    executablePath, protocolTimeout: 300000,
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
});
const page = await browser.newPage(), line = await page.createCDPSession();
await line.send("Network.enable");
await line.send("Network.emulateNetworkConditions", { offline: false, latency: 300, downloadThroughput: 200000, uploadThroughput: 200000 });
const names = new Map(), bytes = new Map();
line.on("Network.requestWillBeSent", e => names.set(e.requestId, path.basename(new URL(e.request.url).pathname) || "index.html"));
line.on("Network.loadingFinished", e => bytes.set(names.get(e.requestId), e.encodedDataLength));
for (let attempt = 0; attempt < 30; ++attempt)
    if (await fetch(address).then(() => true, () => new Promise(done => setTimeout(done, 200, false)))) break;
await page.goto(address, { waitUntil: "domcontentloaded", timeout: 120000 });
await page.waitForFunction(() => document.documentElement.dataset.ready, { timeout: 120000 });
const ready = Number(await page.evaluate(() => document.documentElement.dataset.ready));
await browser.close();
const all = [...bytes.values()].reduce((a, b) => a + b, 0);
console.log(`the first letter at 200 kB/s, 300 ms: ${(ready / 1000).toFixed(1)} s after the page was asked for, ${bytes.size} files, ${all} bytes as sent`);
for (const [name, size] of bytes) console.log(`    ${String(size).padStart(7)} ${name}`);
const good = all <= 900000 && all > 100000;
if (!good) console.log("FAILED: at most 900,000 bytes were to be sent");
process.exit(good ? 0 : 1);
