# SPDX-License-Identifier: MIT
#
# Of Doxygen's warnings leaves those that matter. A member without words of its own is described well enough
#   - if a comment before it in its header speaks of it by name: that of its type, say, which draws the arrays,
#   - if it shares the words of an overload, or
#   - if it is a constructor, an assignment or a deduction guide, or listed in plain.txt, the first file given.
function is_spoken_of(file, last, name,  line, n, found, pattern) {
    pattern = "(^|[^A-Za-z0-9_])" name "([^A-Za-z0-9_]|$)"
    while (!found && (getline line < file) > 0) {
        if (++n == last) continue
        if (line ~ ("^(    )?[a-z\\[].*[ *&]" name "(\\(| = |;)")) {
            found = 1
        } else if (n < last && line ~ /\/\/\// && line !~ /@ref/) {
            sub(/.*\/\/\/<?/, "", line)
            found = line ~ pattern
        }
    }
    close(file)
    return found
}
FNR == NR {
    if ($0 !~ /^#/) for (i = 1; i <= NF; ++i) plain[$i] = 1
    next
}
/: warning: Member .* is not documented\.$/ {
    split($0, at, ":")
    name = $0
    sub(/^.*: warning: Member /, "", name)
    name = name ~ /^operator\(\)/ ? "operator()" : name ~ /^operator/ ? "operator" : name
    sub(/[ (\[<)].*/, "", name)
    type = $0
    sub(/ is not documented\.$/, "", type)
    sub(/^.*(struct|class|namespace|file) /, "", type)
    sub(/<.*/, "", type)
    sub(/^.*::/, "", type)
    if (name == type || name in plain || is_spoken_of(at[1], at[2] + 0, name)) next
    if ($0 ~ /\(function\) of namespace/ && is_guide(at[1], at[2] + 0, name)) next
}
{ print; status = 1 }
END { exit status }
function is_guide(file, last, name,  line, n, found) {
    while ((getline line < file) > 0 && ++n <= last + 1) if (n >= last && line ~ /->/) found = 1
    close(file)
    return found
}
