# SPDX-License-Identifier: MIT
#
# What the scripts of this folder share. tests/run.sh gives them TYPEMESH_TEST_DATA (the folder tests/) and has made the
# packages; they end with 0 when all is well, with 77 after a last line that says why they skip, else with 1.
set -u
root=$TYPEMESH_TEST_DATA/..
packages=$root/build/release/packages
failures=0

fail() {
    printf '%s\n' "$*"
    failures=$((failures + 1))
}

# The words of a command that failed; else nothing.
quietly() {  # quietly COMMAND...
    local output
    output=$("$@" 2>&1) || {
        printf '%s\n' "$*" "$output" | tail -n 20
        failures=$((failures + 1))
        return 1
    }
}

skip() {
    printf '%s\n' "$*"
    exit 77
}

# The README's program, as a file.
write_readme_program() {  # write_readme_program FILE
    awk '/^```cpp$/ { inside = 1; next } /^```$/ { if (inside) exit } inside' "$root/README.md" >"$1"
}
