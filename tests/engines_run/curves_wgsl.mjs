// SPDX-License-Identifier: MIT
//
//     node curves_wgsl.mjs BROWSER PAGE SHADER SCENES PROFILE
//
// Has the browser open the page, which draws all scenes and sends back what is wrong. Exits with 77 if there is no WebGPU.
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';

const [browser, page, shader, scenes, profile] = process.argv.slice(2);
const seconds = 240;
const server = http.createServer((request, response) => {
    const name = path.basename(decodeURIComponent(request.url));
    if (request.method === 'POST') {
        let body = '';
        request.on('data', (some) => { body += some; }).on('end', () => { response.end(); finish(JSON.parse(body)); });
    } else if (name === '') response.setHeader('Content-Type', 'text/html').end(fs.readFileSync(page));
    else if (name === 'shader') response.end(fs.readFileSync(shader));
    else if (name === 'scenes') response.end(JSON.stringify(fs.readdirSync(scenes)));
    else if (fs.existsSync(path.join(scenes, name))) response.end(fs.readFileSync(path.join(scenes, name)));
    else response.writeHead(404).end();
});
await new Promise((done) => server.listen(0, '127.0.0.1', done));
const started = spawn(browser, ['--headless=new', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
    '--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader', `--user-data-dir=${profile}`, '--no-first-run',
    `http://127.0.0.1:${server.address().port}/`], { stdio: 'ignore', detached: true });
const late = setTimeout(() => finish({ errors: [`Chromium has sent nothing within ${seconds} seconds`] }), 1000 * seconds);

/** Ends the browser and its own processes. */
function stop() {
    try {
        process.kill(-started.pid);
    } catch {  // it has ended by itself
        process.exit(1);
    }
}

let finished = false;
function finish({ missing, drawn = 0, inside = 0, outside = 0, soft = 0, errors = [] }) {
    if (finished) return;
    finished = true;
    clearTimeout(late);
    started.once('exit', () => process.exit(status));
    let status = 77;
    if (missing) return console.log(missing), stop();
    for (const one of errors) console.log(one);
    console.log(`${drawn} pictures drawn: ${inside} pixels inside and ${outside} outside are compared, ${soft} of them are smoothed`);
    const enough = drawn === fs.readdirSync(scenes).length && inside > 100000 && outside > 100000 && soft > 1000;
    status = errors.length === 0 && enough ? 0 : 1;
    stop();
}
