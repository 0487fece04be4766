# SPDX-License-Identifier: MIT
#
# What the scripts of this folder share. tests/run.sh starts them in build/web with TYPEMESH_MESH_HASH.
set -eu
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

skip() {  # skip SENTENCE
    printf '%s\n' "$*"
    exit 77
}
fail() {  # fail SENTENCE
    printf '%s\n' "$*"
    exit 1
}
command -v node >/dev/null 2>&1 || skip "node is not installed"
[ -e "$root/examples/web/package/typemesh.wasm" ] || fail "examples/web/build.sh has made no typemesh.wasm"
