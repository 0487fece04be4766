#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Do drawings cover what another rasteriser draws? Takes some thousand icons and emoji of npm, and resvg-js, installs them in
# build/svg/, and compares areas: see areas.mjs. No part of tests/run.sh: it takes 10 to 30 minutes.
#
#     tests/svg/run.sh PROGRAM [EVERY]     text_to_mesh, built with pugixml; each EVERY-th file of a set, 8 by default
set -eu
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=$(realpath "$1") every=${2:-8} work=$root/build/svg
mkdir -p "$work"
npm install --prefix "$work" --no-save --no-audit --no-fund \
    @resvg/resvg-js simple-icons @mdi/svg bootstrap-icons openmoji @discordapp/twemoji >"$work/npm.log" 2>&1
for set in simple-icons/icons @mdi/svg/svg bootstrap-icons/icons openmoji/color/svg @discordapp/twemoji/dist/svg; do
    find "$work/node_modules/$set" -name '*.svg' | LC_ALL=C sort | awk -v every="$every" 'NR % every == 1'
done >"$work/files.txt"
cp "$root/tests/svg/areas.mjs" "$work/"
node --expose-gc "$work/areas.mjs" "$program" "$work/areas.tsv" "$work/files.txt"
