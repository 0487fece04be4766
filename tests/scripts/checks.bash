# SPDX-License-Identifier: MIT
#
# For the scripts of this folder: checks of a script that ran, and stand-ins for the programs that it calls. $scratch is an
# empty folder, $status the script's; it has written $scratch/out and $scratch/err, and its calls are in $scratch/calls.
export scratch
bin=$scratch/bin
passed=0
failed=0
check() {  # check 'SENTENCE' COMMAND...
    local sentence=$1
    shift
    if "$@" >/dev/null; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAILED: %s\n  status %s; written:\n' "$sentence" "$status" && tail -q -n 15 "$scratch/out" "$scratch/err" | cut -c 1-200 | sed 's/^/  | /'
    fi
}
says() { grep -qE -- "$1" "$scratch/out" "$scratch/err"; }
called() { grep -qE -- "$1" "$scratch/calls"; }
called_not() { ! called "$1"; }
succeeds() { [ "$status" = 0 ]; }
fails() { [ "$status" != 0 ]; }
stand_in() {  # stand_in NAME, its body on standard input; every call is recorded
    # shellcheck disable=SC2016  # for the stand-in
    { printf '#!/usr/bin/env bash\necho "%s $*" >>"$scratch/calls"\n' "$1" && cat; } >"$bin/$1" && chmod +x "$bin/$1"
}
