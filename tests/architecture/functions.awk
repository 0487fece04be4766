# SPDX-License-Identifier: MIT
#
# Lists the functions of C++ headers: FILE NAME LINES PARAMETERS, LINES 0 for a declaration. No parser, but enough of one
# for a house with one style: a function is what has parentheses before its brace or semicolon in a namespace or class.
#
#     awk -f functions.awk HEADER...

FNR == 1 { begin() }
{
    line = $0
    if (in_comment) {
        if (!match(line, /\*\//)) next
        line = substr(line, RSTART + 2)
        in_comment = 0
    }
    if (continued || line ~ /^[ \t]*#/) {  # the preprocessor's
        continued = line ~ /\\$/
        next
    }
    gsub(/'(\\.|[^'\\])'/, "0", line)
    gsub(/"(\\.|[^"\\])*"/, "0", line)
    gsub(/\/\*([^*]|\*[^\/])*\*\//, " ", line)
    sub(/\/\/.*/, "", line)
    if (match(line, /\/\*/)) {
        line = substr(line, 1, RSTART - 1)
        in_comment = 1
    }
    for (i = 1; i <= length(line); ++i) take(substr(line, i, 1))
    take(" ")
}

function begin() {
    depth = 0         # of braces
    kind[0] = "outer"
    round = 0         # of parentheses in the head
    head = ""         # since the last brace or semicolon
    head_line = 0
    in_comment = continued = 0
}

# kind: "outer" holds declarations; "body" belongs to a function or is of no interest; "inner" is a part of the head.
function take(c,   what) {
    if (kind[depth] == "body") {
        if (c == "{") kind[++depth] = "body"
        if (c == "}") close_brace()
        return
    }
    if (kind[depth] == "inner") {
        if (c == "{") kind[++depth] = "inner"
        if (c == "}") --depth
        return
    }
    if (c == "(") ++round
    if (c == ")") --round
    if (c == "{") {
        what = kind_of_brace()
        if (what == "function") {
            name[depth + 1] = name_of(head)
            begun[depth + 1] = head_line
            parameters[depth + 1] = parameters_of(head)
            what = "body"
        } else if (depth + 1 in name) {
            delete name[depth + 1]
        }
        kind[++depth] = what
        if (what == "inner") head = head "0"
        else clear_head()
    } else if (c == "}") {
        close_brace()
    } else if (c == ";" && round == 0) {
        if (is_function(plain(head))) print short(FILENAME), name_of(head), 0, parameters_of(head)
        clear_head()
    } else if (c == ":" && head ~ /^ *(public|private|protected) *$/) {
        clear_head()
    } else {
        if (head_line == 0 && c != " " && c != "\t") head_line = FNR
        if (head_line != 0) head = head c
    }
}

function close_brace() {
    if (depth in name) {
        print short(FILENAME), name[depth], FNR - begun[depth] + 1, parameters[depth]
        delete name[depth]
    }
    if (depth > 0) --depth
    clear_head()
}

function clear_head() {
    head = ""
    head_line = round = 0
}

function kind_of_brace(   h) {
    if (round > 0 || head ~ /requires *(\([^()]*\))? *$/) return "inner"
    h = plain(head)
    if (h ~ /^ *((inline|export) +)*(namespace|class|struct|union|enum|extern 0)/) return "outer"
    if (!is_function(h)) return "inner"  # an initialiser
    # A member of a constructor's initialiser list; behind its brace the head ends with 0, behind its parenthesis with one.
    if (h ~ /\)[^()]*[^:]:[^:]/ && head ~ /[A-Za-z0-9_>] *$/ && head !~ /0 *$/) return "inner"
    return "function"
}

# A head without what may stand before a function: template parameters, attributes, requires clauses, specifiers with
# parentheses.
function plain(h,   i, c, angle) {
    while (match(h, /^ *template *</)) {
        angle = 0
        for (i = RSTART + RLENGTH - 1; i <= length(h); ++i) {
            c = substr(h, i, 1)
            if (c == "<") ++angle
            if (c == ">" && substr(h, i - 1, 1) != "-" && --angle == 0) break
        }
        h = substr(h, i + 1)
    }
    gsub(/\[\[[^]]*\]\]/, "", h)
    while (match(h, /(explicit|alignas|decltype|noexcept|requires|sizeof) *\(/))
        h = without_group(h, RSTART, RSTART + RLENGTH - 1)
    return h
}

function without_group(h, from, open,   i, c, level) {
    for (i = open; i <= length(h); ++i) {
        c = substr(h, i, 1)
        if (c == "(") ++level
        if (c == ")" && --level == 0) break
    }
    return substr(h, 1, from - 1) substr(h, i + 1)
}

function is_function(h,   at) {
    if (h ~ /^ *(using|typedef|friend +(class|struct)|concept|return) |^ *static_assert/) return 0
    if (h ~ /^[^(]*\( *\*/) return 0  # a pointer to a function
    sub(/operator *\( *\)/, "operator_call", h)
    gsub(/operator *[=!<>]+/, "operator_compare", h)
    at = match(h, /[A-Za-z0-9_>+*\/-] *\(/)
    return at && (index(h, "=") == 0 || index(h, "=") > at)
}

function start_of_parameters(h) {
    sub(/operator *\( *\)/, "operator_call", h)
    match(h, /[A-Za-z0-9_>=+*\/<!-] *\(/)
    return substr(h, RSTART + RLENGTH)
}

function name_of(head,   h) {
    h = plain(head)
    sub(/operator *\( *\)/, "operator_call", h)
    match(h, /[A-Za-z0-9_>=+*\/<!-] *\(/)
    h = substr(h, 1, RSTART)
    if (match(h, /operator.*$/)) {
        h = substr(h, RSTART)
        gsub(/ /, "_", h)
        return h
    }
    match(h, /[A-Za-z0-9_~]+ *$/)
    return RSTART ? substr(h, RSTART) : h
}

function parameters_of(head,   h, i, c, level, angle, commas, any) {
    h = start_of_parameters(plain(head))
    for (i = 1; i <= length(h); ++i) {
        c = substr(h, i, 1)
        if (c ~ /[({\[]/) ++level
        if (c == ")" && level == 0) break
        if (c ~ /[)}\]]/) --level
        if (c == "<") ++angle
        if (c == ">" && angle > 0 && substr(h, i - 1, 1) != "-") --angle
        if (c == "," && level == 0 && angle == 0) ++commas
        if (c !~ /[ \t]/) any = 1
    }
    return any ? commas + 1 : 0
}

function short(file) {
    sub(/^.*include\/typemesh\//, "", file)
    return file
}
