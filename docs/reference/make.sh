#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The API reference: every public name of the headers by Doxygen (1.9.4 or newer), with the pages of docs/stages/ before
# them. A public name without words is an error, and so is any other warning; undescribed.awk says what counts as words.
#
#     docs/reference/make.sh [FOLDER]     writes FOLDER/html/index.html; FOLDER: build/reference
#     docs/reference/make.sh --check      keeps nothing
#
# Ends with 77 where Doxygen is not installed.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
folder=$root/build/reference
case ${1-} in
    -h | --help) sed -n '3,9s/^# \{0,1\}//p' "$0" && exit 0 ;;
    --check) folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT ;;
    ?*) mkdir -p "$1" && folder=$(cd "$1" && pwd) ;;
esac
if ! command -v doxygen >/dev/null 2>&1; then
    echo "doxygen is not installed: the reference is neither made nor checked" >&2
    exit 77
fi

# Doxygen reads copies: in these, the inline namespace, which is not parted from the rest, is left out, and what
# stands in a header belongs to the group of its room.
rm -rf "$folder/headers"
mkdir -p "$folder/headers/typemesh"
cd "$root/include/typemesh"
for header in *.hpp */*.hpp; do
    case $header in compiled/*) continue ;; esac
    echo "$header"
done >"$folder/shown"
cut -d/ -f1 "$folder/shown" | grep -v hpp | sort -u | while read -r room; do mkdir -p "$folder/headers/typemesh/$room"; done
# shellcheck disable=SC2046  # names without blanks
awk -v to="$folder/headers/typemesh/" -f "$here/filter.awk" "$here/contracts.txt" $(cat "$folder/shown")

for page in "$root"/docs/stages/*.md; do
    room=$(basename "$page" .md)
    [ "$room" != README ] || room=main
    awk -v room="$room" -f "$here/pages.awk" "$page" >"$folder/headers/$room.dox"
done

# A group begins with its page, not with its list of names.
doxygen -l "$folder/layout.xml" >/dev/null
awk '/<group>/ { group = 1 } /<\/group>/ { group = 0 } !(group && /<detaileddescription/)
    group && /<briefdescription/ { print "    <detaileddescription title=\"In short\"/>" }' "$folder/layout.xml" >"$folder/groups_first.xml"

{
    cat "$here/Doxyfile"
    echo "INPUT = $folder/headers"
    echo "STRIP_FROM_PATH = $folder/headers"
    echo "STRIP_FROM_INC_PATH = $folder/headers"
    echo "LAYOUT_FILE = $folder/groups_first.xml"
    echo "HTML_EXTRA_STYLESHEET = $here/style.css"
    echo "OUTPUT_DIRECTORY = $folder"
    echo "WARN_LOGFILE = $folder/warnings"
} >"$folder/Doxyfile"
doxygen "$folder/Doxyfile"
status=0
awk -f "$here/undescribed.awk" "$here/plain.txt" "$folder/warnings" >"$folder/errors" || status=1
sed "s,^$folder/headers/,include/," "$folder/errors" >&2
exit $status
