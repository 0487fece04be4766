# SPDX-License-Identifier: MIT
"""Rows as the parts print them (../README.md), and Markdown of them."""

import collections
import math
import pathlib
import statistics


class Rows:
    """All rows of a folder: of[kind] is a list of dictionaries; fields that are numbers are floats, `-` is None."""

    def __init__(self, folder):
        self.of = collections.defaultdict(list)
        self.skipped, self.notes, self.ran = [], [], []
        for file in sorted(pathlib.Path(folder).glob('*.tsv')):
            columns = {}
            for line in file.read_text(encoding='utf-8', errors='replace').splitlines():
                self._take(file.stem, columns, line.split('\t'))

    def _take(self, part, columns, fields):
        kind, values = fields[0], fields[1:]
        if kind == 'columns' and values:
            columns[values[0]] = values[1:]
        elif kind == 'skipped':
            self.skipped.append((part, *(values + ['', ''])[:2]))
        elif kind == 'note':
            self.notes.append((part, ' '.join(values)))
        elif kind == 'ran' and len(values) == 5:
            self.ran.append(values)
        elif kind in columns and len(values) == len(columns[kind]):  # a row cut off by a crash is no row
            self.of[kind].append({name: number(v) for name, v in zip(columns[kind], values)})


def number(text):
    if text == '-':
        return None
    try:
        value = float(text)
    except ValueError:
        return text
    return value if math.isfinite(value) else None


def mean(values):
    values = [v for v in values if v is not None]
    return statistics.fmean(values) if values else None


def brief(value, digits=2):
    """Some figures of a number, a dash for none, words as they are."""
    if value is None:
        return '-'
    if isinstance(value, str):
        return value.replace('|', r'\|')
    if value == 0:
        return '0'
    if abs(value) >= 100 or value == int(value) and abs(value) >= 1:
        return f'{value:.0f}'
    if abs(value) >= 10:
        return f'{value:.1f}' if digits > 2 else f'{value:.0f}'
    return f'{value:.{digits}g}' if abs(value) < 1 else f'{value:.{digits - 1}f}'


def times(value):
    return '-' if value is None else f'{brief(value)} ×'


def share(value):
    return '-' if value is None else f'{100 * value:.0f} %'


def table(head, body):
    if not body:
        return 'Not measured.\n'
    lines = ['| ' + ' | '.join(head) + ' |', '|' + '---|' * len(head)]
    lines += ['| ' + ' | '.join(brief(v) for v in row) + ' |' for row in body]
    return '\n'.join(lines) + '\n'
