#!/bin/sh
# SPDX-License-Identifier: MIT
#
# 14_clock, 15_rolling_score and 16_ticker move the words and digits of one text; no frame requests memory.
#
#     moving_words.sh CLOCK SCORE TICKER
set -eu
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
fail() { printf '%s\n' "$*" && exit 1; }
says() { printf '%s\n' "$said" | grep -qx -e "$1" || fail "not said: $1" "$said"; }

said=$("$1" "$font")
says '10:10:15: +2.20 .0.00'
says '10:10:30: .0.00 -2.20'
says '10:10:45: -2.20 .0.00'
says '10:10:00: .0.00 +2.20'
says '0 allocations in 61 frames'

said=$("$2" "$font")
says '30 digits share 10 meshes'
for score in 49 99 149 199 249; do says "score $score: the wheels show $(printf '%03d' $score)"; done
says '0 allocations in 251 frames'

said=$("$3" "$font" "Letters come and go at the ends of a window" Short)
says 'Short: up to [1-7]\.[0-9] wide'
says 'Letters come .*: up to [78]\.[0-9] wide'
says 'round 1: [1-9][0-9]* allocations in [0-9]* frames'
says 'round 2: 0 allocations in [0-9]* frames'
for program in "$@"; do
    if "$program" /no/such/font x >/dev/null; then fail "a font that is not there is opened"; fi
done
