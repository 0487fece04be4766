#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Compares the library of this tree with another revision. Both do the same work in turns. It prints processor times as shares
# of the other revision's times, with their spread over the rounds. The programs are instructions/kernels.cpp, compiled with
# both. On a busy machine it is better to count instructions: bench/instructions.sh --beside REVISION.
#
#     bench/compare.sh REVISION                 every kernel, 9 rounds
#     bench/compare.sh REVISION --rounds N KERNEL...
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$typemesh_root/cmake/setup.sh"
here=$typemesh_root/bench work=$typemesh_root/build/compare
usage() { sed -n '3,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 2; }
[ $# -gt 0 ] || usage
revision=$1 rounds=9 wanted=
shift
while [ $# -gt 0 ]; do
    case $1 in
        --rounds) rounds=$2 && shift ;;
        -*) usage ;;
        *) wanted="$wanted $1" ;;
    esac
    shift
done
install_missing g++ pkg-config harfbuzz python3
install_fonts fonts-liberation fonts-comic-neue fonts-inter-variable fonts-mplus
mkdir -p "$work"
git -C "$typemesh_root" rev-parse --verify --quiet "$revision^{commit}" >/dev/null || stop "There is no revision $revision."
git -C "$typemesh_root" worktree prune
rm -rf "$work/tree"
git -C "$typemesh_root" worktree add --force --detach "$work/tree" "$revision" >/dev/null 2>&1 ||
    stop "No worktree of $revision could be made in $work/tree."
trap 'git -C "$typemesh_root" worktree remove --force "$work/tree"' EXIT

say "This builds the kernels with both revisions"
for tree in "$typemesh_root" "$work/tree"; do
    program=$work/ours
    [ "$tree" = "$typemesh_root" ] || program=$work/theirs
    # shellcheck disable=SC2046  # a list of words
    "${CXX:-g++}" -std=c++20 -O3 -DNDEBUG -I"$tree/include" -I"$here" -DTYPEMESH_TEST_DATA="\"$typemesh_root/tests\"" \
        "$here/instructions/kernels.cpp" -o "$program" $(pkg-config --cflags --libs harfbuzz) ||
        stop "The kernels do not compile against $tree."
done
python3 "$here/instructions/in_turns.py" "$work/ours" "$work/theirs" "$rounds" $wanted
