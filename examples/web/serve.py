# SPDX-License-Identifier: MIT
"""serve.py FOLDER PORT: serves a folder to this machine. Files that lie there compressed (.br, .gz) are sent so."""

import functools
import http.server
import os
import sys
import urllib.parse

KINDS = {".js": "text/javascript", ".wasm": "application/wasm", ".json": "application/json", ".ttf": "font/ttf", ".otf": "font/otf"}


class Handler(http.server.SimpleHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, **KINDS}

    def send_head(self):
        plain = self.translate_path(self.path)
        if os.path.isdir(plain) and not urllib.parse.urlsplit(self.path).path.endswith("/"):
            return super().send_head()  # sends on to the name with "/", on which relative links rest
        plain = os.path.join(plain, "index.html") if os.path.isdir(plain) else plain
        accepted = self.headers.get("Accept-Encoding", "")
        for ending, name in ((".br", "br"), (".gz", "gzip")):
            if name in accepted and os.path.isfile(plain + ending):
                return self.send_packed(plain, plain + ending, name)
        return super().send_head()

    def send_packed(self, plain, packed, name):
        file = open(packed, "rb")
        self.send_response(200)
        self.send_header("Content-Type", self.guess_type(plain))
        self.send_header("Content-Encoding", name)
        self.send_header("Content-Length", str(os.fstat(file.fileno()).st_size))
        self.end_headers()
        return file

    def send_response(self, code, message=None):
        self.is_there = code == 200
        super().send_response(code, message)

    def end_headers(self):
        named = self.is_there and os.path.basename(self.path).startswith("chunk-")
        self.send_header("Cache-Control", "max-age=31536000, immutable" if named else "no-cache")
        self.send_header("Vary", "Accept-Encoding")
        super().end_headers()

    def log_message(self, *words):
        pass


if __name__ == "__main__":
    handler = functools.partial(Handler, directory=sys.argv[1])
    with http.server.ThreadingHTTPServer(("127.0.0.1", int(sys.argv[2])), handler) as server:
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            pass
