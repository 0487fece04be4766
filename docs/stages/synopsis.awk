# SPDX-License-Identifier: MIT
#
# The public names of headers, a row of a table each: the header, the name (a function with its parameters) and the first
# sentence of its comment. Overloads have one row. Headers are written as clang-format leaves them: what stands at the
# left margin of a namespace is a declaration.
#
#     awk -f synopsis.awk HEADER...

function first_sentence(text) {
    gsub(/[ \t]+/, " ", text)
    sub(/^ /, "", text)
    if (match(text, /[.:;] /)) text = substr(text, 1, RSTART)
    sub(/[.:;] *$/, "", text)
    gsub(/\|/, "\\|", text)
    return text
}
# Without the argument list of a template or of a requires clause at its start.
function without_brackets(text, from, to, i, c, depth) {
    depth = 0
    for (i = 1; i <= length(text); ++i) {
        c = substr(text, i, 1)
        if (c == from) ++depth
        if (c == to && --depth == 0) return substr(text, i + 1)
    }
    return ""
}
function show(text, name) {
    gsub(/[ \t]+/, " ", text)
    gsub(/\[\[nodiscard\]\] ?/, "", text)
    gsub(/decltype\(auto\)/, "auto", text)
    gsub(/\[\[(gnu::[a-z_]+|maybe_unused)\]\] ?/, "", text)
    if (text ~ /^template ?<> /) return
    while (text ~ /^(template|requires)/) {
        if (text ~ /^template/) text = without_brackets(text, "<", ">")
        else if (text ~ /^requires ?\(/) text = without_brackets(text, "(", ")")
        else if (match(text, / (class|struct) /)) text = substr(text, RSTART)
        else if (!sub(/^requires [^ ]+ (&& [^ ]+ )*/, "", text)) return
        sub(/^ /, "", text)
    }
    gsub(/^((inline|constexpr|static|extern) )+/, "", text)
    if (text ~ /^(typedef|using|namespace|static_assert|friend|template)/ || text ~ /operator/) return
    if (text ~ /^concept /) name = text = substr(text, 1, index(text " =", " =") - 1)
    else if (text ~ /^(class|struct|union|enum)/) {
        sub(/ final/, "", text)
        sub(/ ?[:{].*/, "", text)
        sub(/ ?;.*/, "", text)
        name = text
        if (text ~ /[<:]/) return  # a specialisation
    } else {
        if (text ~ /\(/) {
            name = substr(text, 1, index(text, "(") - 1)
            sub(/^.* [*&]*/, "", name)
            if (name == "" || text !~ / [*&]*[a-z_0-9]+\(/) return  # a deduction guide
            sub(/ requires ?\(.*\) /, " ", name)
            text = name substr(text, index(text, "("), length(text) - length(without_brackets(text, "(", ")")) - index(text, "(") + 1)
        } else {
            sub(/ ?[={;].*/, "", text)
            sub(/\[[^]]*\]$/, "", text)
            sub(/^.* [*&]*/, "", text)
            name = text
        }
    }
    sub(/^(class|struct|union|enum class|enum) /, "", text)
    if ((FILENAME, name) in seen || words == "") return
    seen[FILENAME, name] = 1
    header = FILENAME
    sub(/.*\//, "", header)
    gsub(/\|/, "\\|", text)
    print "| " (header == last ? "" : "`" header "`") " | `" text "` | " first_sentence(words) " |"
    last = header
}

FNR == 1 { inside = hidden = open = 0; words = "" }
/^namespace typemesh/ { inside = 1; hidden = /detail/; next }
/^namespace (detail|[a-z_]+) \{/ { ++hidden; next }
/^\}  \/\/ namespace/ { if (/typemesh/) inside = 0; else --hidden; next }
!inside || hidden { next }
open && /^#/ { next }
open && declared ~ /requires requires/ {  # its requirements are left out
    if ($0 !~ /^[a-z\[]/) next
    declared = ""
}
open {
    sub(/\/\/.*/, "")
    declared = declared " " $0
    if (declared ~ /requires requires/) next
    if (/[;{]/ || /^\}/) { open = 0; show(declared); words = "" }
    next
}
/^\/\/\// {
    line = $0
    sub(/^\/\/\/ ?/, "", line)
    if (line == "" || line ~ /^   /) ended = words != ""
    else if (!ended) words = words " " line
    next
}
/^$/ { words = ""; ended = 0; next }
/^#/ { next }
/^[a-z\[]/ {
    declared = $0
    sub(/\/\/.*/, "", declared)
    ended = 0
    if ($0 ~ /[;{]/) { show(declared); words = "" }
    else open = 1
}
