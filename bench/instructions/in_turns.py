# SPDX-License-Identifier: MIT
"""Times of two programs' kernels in turns: in_turns.py OURS THEIRS ROUNDS [KERNEL...]"""

import os
import statistics
import subprocess
import sys


def seconds(program, kernel, times):
    """The processor's time of one run of the program."""
    before = os.times()
    subprocess.run([program, kernel, str(times)], stdout=subprocess.DEVNULL, check=True)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def each(program, kernel, times):
    """Without what a run costs that does the work once: fonts are opened, memory is warmed."""
    return max(seconds(program, kernel, times + 1) - seconds(program, kernel, 1), 1e-9) / times


def repetitions(program, kernel):
    times = 4
    while times < 1 << 20 and each(program, kernel, times) * times < 0.3:
        times *= 4
    return times


def main():
    ours, theirs, rounds, *wanted = sys.argv[1:]
    listed = subprocess.run([ours], capture_output=True, text=True, check=True).stdout.splitlines()
    print('kernel: time as a share of the other revision\'s: median (least to largest of the rounds)')
    for line in listed:
        kernel, _, what = line.split('\t')
        if wanted and kernel not in wanted:
            continue
        times = repetitions(theirs, kernel)
        ratios = []
        for number in range(int(rounds)):
            pair = [ours, theirs] if number % 2 else [theirs, ours]
            found = {program: each(program, kernel, times) for program in pair}
            ratios.append(found[ours] / found[theirs])
        print(f'{kernel:16} {100 * statistics.median(ratios):6.1f} % ({100 * min(ratios):.1f} to {100 * max(ratios):.1f})   {what}',
              flush=True)


main()
