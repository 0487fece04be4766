#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# usage: examples/web/harfbuzz.sh FOLDER
#
# Fetches HarfBuzz's source package from where this Debian takes its packages, and unpacks it as FOLDER/harfbuzz. The system's
# own lists of packages stay as they are: apt-get runs with a configuration of its own, made of the present one.
set -eu
mkdir -p "$1"
folder=$(cd "$1" && pwd)
[ ! -e "$folder/harfbuzz/src/harfbuzz.cc" ] || exit 0
apt=$folder/apt
rm -rf "$apt" "$folder/source"
mkdir -p "$apt/parts" "$apt/lists/partial" "$apt/cache/archives/partial" "$folder/source"
: >"$apt/sources.list"
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ ! -f "$list" ] || sed -nE 's/^[[:space:]]*deb[[:space:]]/deb-src /p' "$list" >>"$apt/sources.list"
done
for list in /etc/apt/sources.list.d/*.sources; do
    [ ! -f "$list" ] || sed -E 's/^Types:.*/Types: deb-src/' "$list" >"$apt/parts/$(basename "$list")"
done
options=(-o "Dir::Etc::sourcelist=$apt/sources.list" -o "Dir::Etc::sourceparts=$apt/parts" -o "Dir::State::lists=$apt/lists"
    -o "Dir::Cache=$apt/cache" -o APT::Sandbox::User=root)
apt-get "${options[@]}" update >"$folder/harfbuzz.log" 2>&1
(cd "$folder/source" && apt-get "${options[@]}" source --only-source harfbuzz >>"$folder/harfbuzz.log" 2>&1)
rm -rf "$folder/harfbuzz"
mv "$folder"/source/harfbuzz-*/ "$folder/harfbuzz"
rm -rf "$apt" "$folder/source"
