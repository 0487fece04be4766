# SPDX-License-Identifier: MIT
#
# Copies headers into the folder `to` as Doxygen is to read them, line by line: see make.sh.
#
#     the inline namespace   left out; what stands in it belongs to the group of its room
#     namespace detail       left out
#     what has no words      gets a reference where a concept asks for it: see contracts.txt
function contract_of(line,  i) {
    for (i = 1; i <= contracts; ++i) if (line ~ ("[ &*]" names[i])) return concepts[i]
    return ""
}
# Puts `words` before the lines that are held back.
function release(words,  i) {
    for (i = 1; i <= held; ++i) print (i == 1 && words != "" ? words " " hold[i] : hold[i]) > out
    held = 0
}
FNR == NR {
    if ($0 !~ /^#/) { names[++contracts] = $1; concepts[contracts] = $2 }
    next
}
FNR == 1 {
    room = FILENAME
    sub("/.*", "", room)
    out = to FILENAME
    inner = spoken = held = 0
}
/^namespace detail \{/ { inner = 1 }
inner {
    if (/^}  \/\/ namespace detail/) inner = 0
    print "" > out
    next
}
/^namespace typemesh/ {
    sub(/::inline TYPEMESH_ABI/, "")
    if (room !~ /hpp$/) $0 = $0 "  /** @room{" room "} */"
}
/^}  \/\/ namespace typemesh/ { if (room !~ /hpp$/) $0 = "/** @} */ " $0 }
/^    \/\/\// { spoken = 1 }
/^    (template <|requires)/ && !spoken {
    hold[++held] = $0
    next
}
/^    [a-z\[]/ && !/^    (template|requires)/ {
    contract = spoken || /\/\/\/</ ? "" : contract_of($0)
    hold[++held] = $0
    release(contract == "" ? "" : "/** As @ref typemesh::" contract " asks. */")
    spoken = 0
    next
}
{
    release("")
    print > out
}
/^    }/ || /^$/ || /^    [^\/]/ { if (!/^    (template|requires)/) spoken = 0 }
