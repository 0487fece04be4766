// SPDX-License-Identifier: MIT
//
// Serves a folder to this machine alone: browsers load no modules from files.
//
//     node three_serve.js FOLDER      prints the port
const fs = require('fs'), http = require('http'), path = require('path');
const folder = fs.realpathSync(process.argv[2]);
const types = {'.html': 'text/html', '.js': 'text/javascript', '.glb': 'model/gltf-binary'};
const server = http.createServer((request, response) => {
    const file = path.join(folder, path.normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname)));
    fs.readFile(file, (error, bytes) => {
        response.writeHead(error ? 404 : 200, {'Content-Type': types[path.extname(file)] || 'application/octet-stream'});
        response.end(error ? '' : bytes);
    });
});
server.listen(0, '127.0.0.1', () => console.log(server.address().port));
