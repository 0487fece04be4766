#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What the README names, on the Debians that people have: each is made in a folder of its own by debootstrap, and gets this tree
# as git has it, changes included. The rows of the table in docs/machines.md are written anew.
#
#     tests/systems/run.sh [OPTION...] [SUITE...]      bookworm, trixie and forky by default
#
#     --only A,B     these alone: tests, example, page, bench, pictures
#     --quick        tests/run.sh --quick instead of all tests
#     --work DIR     for the folders, 5 GB each; build/systems by default. What has been made there is used again
#     --table        runs nothing, writes the table of what the folders know
#
# bookworm and trixie must pass; forky, which changes from day to day, informs. Needs Debian and root. An hour a suite on two cores.
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"
. "$typemesh_root/tests/systems/debian.bash"
page=$typemesh_root/docs/machines.md work=$typemesh_root/build/systems
all="tests example page bench pictures" parts= suites= quick= run=yes
while [ $# -gt 0 ]; do
    case $1 in
        --only) parts=$(say "${2:-}" | tr , ' ') && shift ;;
        --quick) quick=--quick ;;
        --work) work=${2:-} && shift ;;
        --table) run= ;;
        -*) sed -n '3,16s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 2 ;;
        *) suites="$suites $1" ;;
    esac
    shift
done
parts=${parts:-$all}
for part in $parts; do
    case " $all " in *" $part "*) ;; *) stop "There is no part $part: $all" ;; esac
done
suites=${suites:-bookworm trixie forky}
mkdir -p "$work" && work=$(cd "$work" && pwd)

# The command of each part; it is run in the tree.
command_of() {  # command_of PART
    case $1 in
        tests) say "./tests/run.sh $quick" ;;
        example) say './examples/run.sh "Hello world!" && test -s hello.glb && test -s hello.png' ;;
        page) say './examples/web/run.sh --build && test -s build/web/site/index.html' ;;
        bench) say './bench/run.sh --quick' ;;
        pictures) say 'bash docs/pictures/make.sh' ;;
    esac
}

# In the system, with a /proc of its own; no mount outlives the command. A compiler's cache lies beside the folder.
inside() {  # inside FOLDER COMMAND
    unshare --mount --pid --fork sh -c '
        mount -t proc proc "$1/proc" && mount --bind /dev "$1/dev" &&
        exec env -i PATH=/usr/lib/ccache:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
            TYPEMESH_CMAKE_OPTIONS="$3" chroot "$1" /bin/bash -c "$2"' sh "$1" "$2" "${TYPEMESH_CMAKE_OPTIONS:-}"
}

make_system() {  # make_system SUITE FOLDER
    local mirror script
    mirror=$(this_debian)
    [ -n "$mirror" ] || stop "apt names no mirror of Debian"
    [ ! -e "$2/made" ] || return 0
    rm -rf "${2:?}"
    for script in "$1" trixie sid; do [ ! -e "/usr/share/debootstrap/scripts/$script" ] || break; done
    say "$1: debootstrap"
    debootstrap --variant=minbase --include=ca-certificates,git,ccache "$1" "$2" "${mirror% *}" \
        "/usr/share/debootstrap/scripts/$script" >"$2.bootstrap.log" 2>&1 || { tail -n 5 "$2.bootstrap.log" && return 1; }
    cp /etc/resolv.conf "$2/etc/" 2>/dev/null || true
    apt-config dump | grep '^Acquire::' >"$2/etc/apt/apt.conf.d/90this-machine"  # its way to the servers
    cp -r /usr/local/share/ca-certificates/. "$2/usr/local/share/ca-certificates/" 2>/dev/null || true  # whom it trusts
    inside "$2" update-ca-certificates >>"$2.bootstrap.log" 2>&1
    touch "$2/made"
}

# The tree, what git does not know left out. What was built there before stays, and is older than the tree.
copy_tree() {  # copy_tree FOLDER
    local tree=$1/typemesh
    mkdir -p "$tree"
    (cd "$tree" && find . -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +)
    (cd "$typemesh_root" && git ls-files -z | tar c --null -T - --ignore-failed-read) | tar xm -C "$tree"
}

# NAME VERSION of what matters, one a line.
versions() {  # versions FOLDER
    inside "$1" 'for p in g++ clang catch2 libharfbuzz-dev libfreetype-dev libicu-dev cmake; do
        v=$(dpkg-query -W -f "\${Version}" $p 2>/dev/null) || continue
        v=${v#*:}; v=${v%%-*}; v=${v%%+*}; p=${p#lib}; echo "${p%-dev} $v"; done' 2>/dev/null
}

run_suite() {  # run_suite SUITE; leaves SUITE.PART, "passed" or what failed, and SUITE.versions in the work folder
    local folder=$work/$1 part log status
    make_system "$1" "$folder" || { say "not made" >"$work/$1.tests" && return 1; }
    copy_tree "$folder"
    for part in $parts; do
        log=$work/$1.$part.log
        say "$1: $(command_of "$part")"
        status=0
        inside "$folder" "cd /typemesh && { $(command_of "$part"); }" >"$log" 2>&1 </dev/null || status=$?
        if [ $part = tests ]; then
            say "$(tail -n 1 "$log")${quick:+ (--quick)}"
        elif [ $status = 0 ]; then
            say passed
        else
            say "failed: $(tail -n 1 "$log")"
        fi | tee "$work/$1.$part"
        [ $status = 0 ] || failed="$failed $1/$part"
    done
    versions "$folder" >"$work/$1.versions"
}

# Replaces what stands between two marks of the page.
write_table() {
    local suite part
    {
        say "| | $(for suite in $suites; do printf '%s | ' "$suite"; done)"
        say "|---|$(for suite in $suites; do printf -- '---|'; done)"
        for name in g++ clang catch2 harfbuzz freetype icu cmake; do
            (cd "$work" && cat $(printf '%s.versions ' $suites) 2>/dev/null) | grep -q "^$name " || continue
            say "| $name | $(for suite in $suites; do
                printf '%s | ' "$(sed -n "s/^$name //p" "$work/$suite.versions" 2>/dev/null)"
            done)"
        done
        for part in $all; do
            say "| \`$(command_of "$part" | sed 's/ &&.*//; s/ $//')\` | $(for suite in $suites; do
                printf '%s | ' "$(cat "$work/$suite.$part" 2>/dev/null || echo -)"
            done)"
        done
    } | sed 's/ $//' >"$work/table"
    awk -v table="$work/table" '
        /^<!-- tests\/systems\/run.sh/ { print; print ""; while ((getline line <table) > 0) print line; print ""; skip = 1; next }
        /^<!-- end -->$/ { skip = 0 }
        !skip' "$page" >"$work/page" && cat "$work/page" >"$page"
}

failed=
if [ -n "$run" ]; then
    [ "$(id -u)" = 0 ] || stop "debootstrap and chroot need root."
    install_missing debootstrap
    for suite in $suites; do run_suite "$suite" || failed="$failed $suite"; done
fi
write_table
say "The table is written: $page"
for each in $failed; do say "failed: $each"; done
case " $failed" in *" bookworm"* | *" trixie"*) exit 1 ;; esac
