# SPDX-License-Identifier: MIT
#
# What the scripts of this folder share beside those of tests/external. tests/run.sh starts them in build/engines with
# TYPEMESH_TEXT_TO_MESH, TYPEMESH_TEST_DATA and NODE_PATH, as it starts the others. With TYPEMESH_KEEP_PICTURES they leave
# what they have drawn in that folder.
. "$(dirname "${BASH_SOURCE[0]}")/../external/common.bash"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

skip() {  # skip SENTENCE
    printf '%s\n' "$*"
    exit 77
}

# Compiles and links with this folder, the recipes and the tests' own headers in sight. The last word must be a library
# where libraries are needed: they are looked for in order.
compile_cpp() {  # compile_cpp PROGRAM STANDARD SOURCE_OR_FLAG...
    local program=$1 standard=$2
    shift 2
    # shellcheck disable=SC2046,SC2086  # lists of words
    ${CXX:-g++} "-std=$standard" -O1 -Wall -Wextra -I"$root/include" -I"$root/examples" -I"$root/tests" \
        $(pkg-config --cflags harfbuzz) -o "$program" "$@" || { fail "$program does not compile" && exit 1; }
}

# What pkg-config says of packages, for compile_cpp, which is strict with our own headers alone.
flags_of() {  # flags_of PACKAGE...
    pkg-config --cflags --libs "$@" | sed 's/\(^\| \)-I/\1-isystem /g'
}

# A program of Catch2's test cases. Its main() is compiled once in build/engines.
compile_tests() {  # compile_tests PROGRAM SOURCE_OR_FLAG...
    local main=$PWD/catch_main.o program=$1
    shift
    if pkg-config --exists catch2-with-main; then
        main=$(pkg-config --cflags --libs catch2-with-main)
    elif [ ! "$main" -nt "$root/tests/support/main.cpp" ]; then
        compile_cpp "$main" c++20 -c "$root/tests/support/main.cpp"
    fi
    # shellcheck disable=SC2046,SC2086  # lists of words
    compile_cpp "$program" c++20 "$@" $main $(pkg-config --libs harfbuzz)
}

# A display without a screen, drawn by Mesa's llvmpipe, for as long as the script runs. Without -noreset it starts anew when
# its last client leaves, and the next one may find nobody.
open_display() {
    command -v Xvfb >/dev/null 2>&1 || skip "Xvfb is not installed"
    Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp -extension MIT-SHM -noreset \
        >"$scratch/xvfb" 2>&1 3>"$scratch/display" &
    # shellcheck disable=SC2064  # this process
    trap "kill $! 2>/dev/null; rm -rf '$scratch'" EXIT
    for _ in $(seq 40); do
        [ ! -s "$scratch/display" ] || break
        sleep 0.5
    done
    [ -s "$scratch/display" ] || { fail "Xvfb does not start: $(cat "$scratch/xvfb")" && exit 1; }
    DISPLAY=:$(cat "$scratch/display")
    export DISPLAY LIBGL_ALWAYS_SOFTWARE=1
}
