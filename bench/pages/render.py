# SPDX-License-Identifier: MIT
"""Writes the pages of docs/benchmarks/: render.py ROWS_FOLDER PAGES_FOLDER. See ../README.md for the rows."""

import pathlib
import re
import subprocess
import sys

import other_pages
import thesis_page
from rows import Rows


def said_by(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ''


def version_of(*packages):
    found = said_by('dpkg-query', '-W', '-f', '${Package} ${Version}\n', *packages)
    return re.sub(r'(:\S+|\S+:)(?=\d)', '', found).replace('\n', ', ')


def machine():
    cpu = re.search(r'Model name:\s*(.*)', said_by('lscpu'))
    cores = said_by('nproc')
    compiler = said_by('g++', '--version').splitlines()
    return [('machine', f'{cpu.group(1) if cpu else "unknown"}, {cores} cores (shared), {said_by("uname", "-sm")}'),
            ('compiler', f'{compiler[0] if compiler else "unknown"}, -O3 (CMake\'s Release)'),
            ('versions', version_of('libharfbuzz0b', 'wine', 'libfreetype6', 'nodejs') or 'unknown')]


def foot_of(rows):
    facts = machine() + [(part, f'{date}, revision {revision}, {mode.strip("-")}, {int(seconds) // 60} min {int(seconds) % 60} s')
                         for part, date, revision, mode, seconds in rows.ran]
    lines = ['## How it was measured', '', *(f'* {name}: {words}' for name, words in facts),
             '* repeat: `bench/run.sh` (`--quick` within five minutes, `--only PART`)']
    skipped = list(dict.fromkeys(f'* {what} ({part}): {why}' for part, what, why in rows.skipped))
    if skipped:
        lines += ['', 'Skipped:', '', *skipped]
    return '\n'.join(lines) + '\n'


def main():
    rows, folder = Rows(sys.argv[1]), pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    foot = foot_of(rows)
    protocol, _ = thesis_page.write(rows, folder, foot)
    other_pages.write_peers(rows, folder, foot)
    other_pages.write_kernels(rows, folder, foot)
    other_pages.write_reading(rows, protocol, folder, foot)


main()
