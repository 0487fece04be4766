#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Installs what the benchmarks need, builds them, runs them all and writes their pages. README.md explains the parts.
#
#     bench/run.sh                    everything, into docs/benchmarks/: within an hour on 2 cores
#     bench/run.sh --quick            fewer runs, into build/bench/pages/: within five minutes
#     bench/run.sh --only A,B         only these parts: thesis, d3dx, peers, kernels, compile, pictures. For the other parts the pages
#                                     keep what was measured before
#     bench/run.sh --pages            measures nothing, writes the pages anew
#
# A part that fails is named and skipped, and the others run; its output is kept. All rows: build/bench/rows/.
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$typemesh_root/cmake/setup.sh"
here=$typemesh_root/bench work=$typemesh_root/build/bench
all_parts="thesis d3dx kernels compile peers pictures" parts= quick= pages=$typemesh_root/docs/benchmarks
while [ $# -gt 0 ]; do
    case $1 in
        --quick) quick=--quick pages=$work/pages ;;
        --only) parts=$(say "${2:-}" | tr , ' ') && shift ;;
        --pages) parts=none ;;
        *) sed -n '3,14s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 2 ;;
    esac
    shift
done
parts=${parts:-$all_parts}
for part in $parts; do
    case " $all_parts none " in *" $part "*) ;; *) stop "There is no part $part: $all_parts" ;; esac
done

# Minutes that a part takes, in tenths, on an idle machine: for the time left. With --quick the second.
tenths_of() {
    local whole quickly
    case $1 in
        thesis) whole=22 quickly=7 ;;
        d3dx) whole=20 quickly=6 ;;
        kernels) whole=55 quickly=4 ;;
        peers) whole=115 quickly=12 ;;
        compile) whole=60 quickly=0 ;;
        pictures) whole=2 quickly=3 ;;
        *) whole=1 quickly=1 ;;
    esac
    if [ -n "$quick" ]; then say $quickly; else say $whole; fi
}

kernels="bench_outline bench_discretise bench_triangulate bench_delaunay bench_resolve bench_extrude bench_vertex bench_offset
    bench_text bench_paragraph bench_markup bench_morph bench_kinds bench_refine bench_threads"
[ -z "$quick" ] || kernels=bench_text

install_all() {
    install_missing g++ cmake ninja pkg-config harfbuzz freetype benchmark python3 matplotlib
    install_fonts fonts-dejavu-core fonts-liberation fonts-comic-neue fonts-hosny-amiri fonts-wqy-microhei \
        fonts-sawarabi-mincho fonts-inter-variable fonts-mplus
}

# --- the parts: rows to standard output, "at 35 %" or other words to standard error ------------------------------------------

run_thesis() { if [ -n "$quick" ]; then "$build/bench_thesis" time 3 1; else "$build/bench_thesis" time 100 20; fi; }
run_d3dx() { bash "$here/d3dx/run.sh" $([ -n "$quick" ] && say --protocol 5 --rounds 1 || say --protocol 20); }
run_peers() { bash "$here/peers/run.sh" $quick; }
run_compile() {
    if [ -n "$quick" ]; then
        printf 'skipped\tcompile times\tthey take minutes\n'
    else
        bash "$here/compile_times.sh" --rows 2
    fi
}
run_pictures() {
    mkdir -p "$pages"
    "$build/bench_thesis" triangles | "$python" "$here/pages/sheets.py" "$pages"
}
run_kernels() {
    local program number=0
    printf 'columns\tkernel\tprogram\tname\tcounter\tvalue\n'
    # shellcheck disable=SC2086  # a list of words
    for program in $kernels; do
        say "at $((100 * number / $(say $kernels | wc -w))) %: $program" >&2
        number=$((number + 1))
        if [ "$program" = bench_threads ]; then
            timeout 600 "$build/$program" --rows || printf 'skipped\t%s\tit ended with an error, or after 600 s\n' "$program"
            continue
        fi
        rm -f "$work/$program.json"
        # shellcheck disable=SC2046
        timeout 600 "$build/$program" --benchmark_out="$work/$program.json" --benchmark_out_format=json \
            --benchmark_min_time=$([ -n "$quick" ] && say 0.02 || say 0.2) \
            $([ -z "$quick" ] || say "--benchmark_filter=^(text|bevelled)/(hello|lorem)$") >"$work/$program.txt" 2>&1 ||
            printf 'skipped\t%s\tit ended with an error, or after 600 s\n' "$program"
        "$python" "$here/pages/kernel_rows.py" "$program" "$work/$program.json"
    done
}

run_part() {  # run_part PART
    local part=$1 rows=$work/rows/$1.tsv status=0 started
    started=$(date +%s)
    "run_$part" >"$rows.new" 2>"$work/$part.log" || status=$?
    if [ $status != 0 ]; then
        printf 'skipped\t%s\tit ended with %d: %s\n' "$part" $status "$(tail -n 1 "$work/$part.log" | tr '\t' ' ')" >>"$rows.new"
    fi
    printf 'ran\t%s\t%s\t%s\t%s\t%d\n' "$part" "$(date -u +%Y-%m-%d)" "$(revision)" "${quick:-whole}" \
        $(($(date +%s) - started)) >>"$rows.new"
    mv "$rows.new" "$rows"
    sed -n 's/^skipped	/  skipped: /p' "$rows"
}
revision() { git -C "$typemesh_root" rev-parse --short=10 HEAD 2>/dev/null || say -; }

# What runs, how far it is, and how long the whole still takes: in one line on a terminal, else every 30 s.
tell_part() {  # tell_part PART SECONDS_THOUGHT SECONDS_AFTERWARDS
    local every=30 end='\n' started now far expected=$2
    if [ -t 1 ]; then every=1 end='\033[K\r'; fi
    started=$(date +%s)
    while sleep $every && kill -0 $$ 2>/dev/null; do
        now=$(($(date +%s) - started))
        far=$(tail -n 1 "$work/$1.log" 2>/dev/null | sed -n 's/^at \([0-9]*\) %.*/\1/p')
        # A part that tells how far it is says itself how long it takes. One that does not, and takes longer than thought, may be
        # anywhere: a tenth of its time is left.
        if [ "${far:-0}" -gt 3 ]; then expected=$((now * 100 / far)); fi
        if [ "$expected" -le $now ]; then expected=$((now * 11 / 10)); fi
        printf "  %s, %d:%02d: %s; about %d min left$end" "$1" $((now / 60)) $((now % 60)) \
            "$(tail -n 1 "$work/$1.log" 2>/dev/null | cut -c 1-60)" $(((expected - now + $3 + 59) / 60))
    done
}

# --- everything --------------------------------------------------------------------------------------------------------------

mkdir -p "$work/rows" "$pages"
build=$typemesh_root/build/release/bench
install_all
python=$(python_with matplotlib)
wants() { case " $parts " in *" $1 "*) return 0 ;; esac && return 1; }
targets=
if wants thesis || wants pictures; then targets=bench_thesis; fi
if wants kernels; then targets="$targets $kernels"; fi
# shellcheck disable=SC2086  # a list of words
[ -z "$targets" ] || { say "Building" $targets && build_preset release $targets; } || say "Parts that could not be built are skipped."
left=0 thought=0 taken=0 # seconds: of parts to come, on an idle machine; of those that have run, thought and taken
for part in $parts; do left=$((left + 6 * $(tenths_of "$part"))); done
for part in $parts; do
    [ "$part" != none ] || continue
    own=$((6 * $(tenths_of "$part")))
    left=$((left - own))
    slower=$((thought > 0 && taken > thought ? 100 * taken / thought : 100)) # percent: other work on the machine
    say "$part"
    tell_part "$part" $((own * slower / 100)) $((left * slower / 100)) &
    teller=$!
    started=$(date +%s)
    run_part "$part"
    taken=$((taken + $(date +%s) - started)) thought=$((thought + own))
    kill $teller 2>/dev/null || true
    wait $teller 2>/dev/null || true
done
"$python" "$here/pages/render.py" "$work/rows" "$pages"
say "The pages are written: $pages/README.md"
