# SPDX-License-Identifier: MIT
#
# The module's meshes equal the native program's meshes, to the bit, for many scripts and all kinds of options.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
[ -x "${TYPEMESH_MESH_HASH:-}" ] || skip "the native program mesh_hash is not built"
command -v fc-match >/dev/null 2>&1 || skip "fontconfig is not installed"
node "$here/native.mjs" "$root/examples/web/package/typemesh.js" "$TYPEMESH_MESH_HASH"
