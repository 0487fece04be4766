# SPDX-License-Identifier: MIT
#
# Turns a page of docs/stages/ into the page of its room's group, for Doxygen. Links lead to the groups of other rooms;
# what lies elsewhere in the repository is named without a link.
#
#     awk -v room=fill -f pages.awk docs/stages/fill.md        room=main: the first page of all
NR == 1 {
    sub(/^# /, "")
    print "/**"
    print room == "main" ? " * @mainpage " $0 : " * @defgroup " room " " $0
    next
}
# Doxygen lists the names itself.
/^<!-- synopsis -->/ { left_out = 1 }
/^<!-- end of synopsis -->/ { left_out = 0; next }
left_out { next }
/^```/ {
    code = !code
    if (code && $0 == "```") $0 = "```{.unparsed}"  # a drawing: no word of it is a name
}
!code {
    gsub(/@/, "\\@")
    while (match($0, /\[[^]]*\]\([^)]*\)/)) {
        link = substr($0, RSTART, RLENGTH)
        words = link
        sub(/^\[/, "", words)
        sub(/\].*/, "", words)
        to = link
        sub(/^.*\(/, "", to)
        sub(/\)$/, "", to)
        if (to ~ /^[a-z]+\.md$/) {
            sub(/\.md$/, "", to)
            words = "@ref " to " \"" words "\""
        }
        $0 = substr($0, 1, RSTART - 1) words substr($0, RSTART + RLENGTH)
    }
}
{ print " * " $0 }
END { print " */" }
