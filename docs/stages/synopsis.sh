#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Writes the synopsis of each stage's page, between its two marks: the public names of the room's headers (synopsis.awk).
#
#     docs/stages/synopsis.sh
#     docs/stages/synopsis.sh --check      fails if a page differs from the headers, and changes nothing
set -eu
here=$(cd "$(dirname "$0")" && pwd)
headers=$here/../../include/typemesh
check=
case ${1-} in
    -h | --help) sed -n '3,6s/^# \{0,1\}//p' "$0" && exit 0 ;;
    --check) check=yes ;;
esac
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
status=0
for page in "$here"/*.md; do
    room=$(basename "$page" .md)
    [ "$room" != README ] || continue
    {
        echo '| header | name | |'
        echo '|---|---|---|'
        awk -f "$here/synopsis.awk" "$headers/$room"/*.hpp
    } >"$scratch/names"
    awk -v names="$scratch/names" '
        /^<!-- end of synopsis -->/ { inside = 0 }
        !inside { print }
        /^<!-- synopsis -->/ { inside = 1; found = 1; print ""; while ((getline line < names) > 0) print line; print "" }
        END { if (!found) exit 1 }' "$page" >"$scratch/page" || { echo "$page has no synopsis" && status=1 && continue; }
    if ! cmp -s "$page" "$scratch/page"; then
        if [ "$check" ]; then
            echo "docs/stages/$room.md differs from the headers: run docs/stages/synopsis.sh" && status=1
        else
            cp "$scratch/page" "$page"
        fi
    fi
done
exit $status
