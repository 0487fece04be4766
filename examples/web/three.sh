#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# usage: examples/web/three.sh FOLDER
#
# Fetches three.js from npm's registry and unpacks it as FOLDER/three. npm does it where it is installed. Elsewhere python3 does,
# for Debian's npm needs hundreds of packages; the registry's address is then the one of NPM_CONFIG_REGISTRY or of an .npmrc, or
# the npm of Debian's package npm, which is fetched for it and not installed. What arrives is compared with the sum below.
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"

version=0.187.0  # the page is tested with this one
sha512=422bbb47e0a687c0acb59b18d6e24e4969d595fa3b66d34b57b985f0996d9372c1dc0b43bbd71166572744a90093c638cfa28ac37e73ed8ed4addee3598f1eb4
mkdir -p "$1"
folder=$(cd "$1" && pwd)
[ "$(cat "$folder/three/fetched" 2>/dev/null)" != "$version" ] || exit 0
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT

set_registry() {  # prints nothing where none is set
    [ -z "${NPM_CONFIG_REGISTRY:-${npm_config_registry:-}}" ] || { say "${NPM_CONFIG_REGISTRY:-$npm_config_registry}" && return; }
    cat "${HOME:-/}/.npmrc" /usr/etc/npmrc /usr/local/etc/npmrc /etc/npmrc 2>/dev/null |
        sed -nE "s/^[[:space:]]*registry[[:space:]]*=[[:space:]]*[\"']?([^\"'[:space:]]+).*/\1/p" | head -n 1
}
# From Debian's package npm: plainly if apt-get knows it, else by package lists of one's own.
registry_of_debian() {
    local options
    command -v apt-get >/dev/null 2>&1 && command -v dpkg-deb >/dev/null 2>&1 || return 0
    mkdir -p "$fresh/lists/partial" "$fresh/cache/archives/partial"
    options=(-o APT::Sandbox::User="$(id -un)")
    (
        cd "$fresh" && { apt-get "${options[@]}" download npm || {
            options+=(-o "Dir::State::lists=$fresh/lists" -o "Dir::Cache=$fresh/cache" -o Acquire::Retries=1)
            apt-get "${options[@]}" update && apt-get "${options[@]}" download npm
        }; } && dpkg-deb -x npm_*.deb npm
    ) >"$fresh/log" 2>&1 || return 0
    grep -rhE --include='*.js' "^ *registry: 'https://[^']+'," "$fresh/npm" | head -n 1 | cut -d "'" -f 2
}
# Fetches an address, if one is given, and compares the file with the sum. Environment variables name proxies, as for other programs.
cat >"$fresh/fetch.py" <<'END'
import hashlib, shutil, sys, urllib.request
file, wanted, address = sys.argv[1:4]
try:
    if address:
        with urllib.request.urlopen(address, timeout=60) as answer, open(file, "wb") as out:
            shutil.copyfileobj(answer, out)
    with open(file, "rb") as made:
        if hashlib.sha512(made.read()).hexdigest() != wanted:
            sys.exit("What has arrived is another file than the page is tested with.")
except (OSError, ValueError) as error:
    sys.exit(f"three.js could not be fetched: {error}")
END

say "This fetches three.js $version"
file=$fresh/three-$version.tgz
address=
if command -v npm >/dev/null 2>&1; then
    if ! (cd "$fresh" && npm pack "three@$version" --silent) >"$fresh/log" 2>&1; then
        explain_failure "$fresh/log" "npm's registry"
        stop "npm could not fetch three.js."
    fi
else
    registry=$(set_registry)
    [ -n "$registry" ] || registry=$(registry_of_debian)
    if [ -z "$registry" ]; then
        [ ! -e "$fresh/log" ] || explain_failure "$fresh/log" "The package servers"
        stop "three.js comes from npm's registry, whose address is not known here: set NPM_CONFIG_REGISTRY to it, or install npm."
    fi
    address=${registry%/}/three/-/three-$version.tgz
fi
python3 "$fresh/fetch.py" "$file" $sha512 "$address" || exit 1
tar -xzf "$file" -C "$fresh"
say "$version" >"$fresh/package/fetched"
rm -rf "$folder/three"
mv "$fresh/package" "$folder/three"
