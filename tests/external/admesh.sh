# SPDX-License-Identifier: MIT
#
# admesh finds nothing to mend in the STL of any text and of any kind of solid: no disconnected, degenerate or reversed facet.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
command -v admesh >/dev/null 2>&1 || { echo "admesh is not installed"; exit 77; }

checked=0 kinds=0
look() {  # look NAME: into text.stl
    admesh -nfudv "$scratch/text.stl" >"$scratch/report" 2>&1 || fail "admesh failed: $1"
    awk -F: '
        /Total disconnected facets/ || /Degenerate facets/ || /Edges fixed/ || /Facets removed/ || /Facets added/ || /Facets reversed/ || /Backwards edges/ {
            split($2, n, " "); ++lines; if (n[1] != 0) { print; bad = 1 }
        }
        END { exit bad || lines != 7 }' "$scratch/report" || fail "admesh complains: $1"
}
check() {  # check FONT TEXT OPTION...
    "$TYPEMESH_TEXT_TO_MESH" --font "$1" --output "$scratch/text.stl" "${@:3}" -- "$2" >/dev/null 2>"$scratch/losses" || fail "text_to_mesh failed: $*: $(cat "$scratch/losses")"
    look "$*"
    checked=$((checked + 1))
}
check_kind() {
    write_kind "$scratch/text.stl" "$@" || return
    look "$1"
    kinds=$((kinds + 1))
}
for_every_kind check_kind
for_every_text check
for_every_bevel check
echo "$checked texts, $kinds other kinds"
[ "$failures" = 0 ] && [ "$checked" -gt 90 ] && [ "$kinds" -ge 25 ]
