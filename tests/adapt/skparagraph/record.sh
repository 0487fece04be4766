#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Records anew what SkParagraph makes of the texts in record.mjs: recorded.txt. Needs node and npm, and the fonts that the
# tests install (another folder than Debian's in TYPEMESH_FONT_DIR).
set -eu
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$here/../../../build/skparagraph

mkdir -p "$build"
npm install --prefix "$build" --no-save --no-audit --no-fund canvaskit-wasm@0.42.0 >"$build/npm.log"
cp "$here/record.mjs" "$build"
node "$build/record.mjs" "${TYPEMESH_FONT_DIR:-/usr/share/fonts}" >"$build/recorded.txt"
mv "$build/recorded.txt" "$here"
