#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Writes the man page of text_to_mesh, from what its --help says.
#
#     man_page.sh PROGRAM [FILE]      standard output without it
set -eu
[ $# -lt 2 ] || exec >"$2"
help=$("$1" --help)
version=$("$1" --version)
printf '%s\n' "$help" | awk -v version="$version" '
    function escaped(s) {
        gsub(/\\/, "\\e", s)
        gsub(/-/, "\\-", s)
        sub(/^[.'"'"']/, "\\\\\\&&", s)
        return s
    }
    function open(words) { if (words == in_verbatim) return; in_verbatim = words; print words ? ".nf" : ".fi" }
    function title(s) { open(0); print ".SH " s }
    BEGIN {
        print ".TH TEXT_TO_MESH 1 \"\" \"" escaped(version) "\""
        title("NAME")
    }
    NR == 1 { sub(/\.$/, ""); print "text_to_mesh \\- " escaped(tolower(substr($0, 1, 1)) substr($0, 2)); next }
    /^Usage: / { title("SYNOPSIS"); sub(/^Usage: /, ""); open(1); print escaped($0); next }
    /^[A-Z][^.]*:$/ { sub(/:$/, ""); title(toupper($0)); examples = /^Examples/; if (examples) open(1); next }
    !NF { if (!in_verbatim) print ".PP"; next }
    /^  [^ ]/ && !examples {
        open(0)
        entry = $0
        sub(/^  /, "", entry)
        words = ""
        if (match(entry, /  +/)) {
            words = substr(entry, RSTART + RLENGTH)
            entry = substr(entry, 1, RSTART - 1)
        } else if (length(entry) > 24 && entry !~ /}$/) {  # no room between the option and its words
            for (at = 24; at > 1 && substr(entry, at, 1) != " "; --at);
            words = substr(entry, at + 1)
            entry = substr(entry, 1, at - 1)
        }
        print ".TP"
        print ".B " escaped(entry)
        if (words != "") print escaped(words)
        next
    }
    { sub(/^ +/, ""); print escaped($0) }
    END { open(0) }
'
