# SPDX-License-Identifier: MIT
"""The pages of peers and kernels, and the short reading of all."""

import collections
import pathlib
import statistics

from protocol import MAKERS
from rows import brief, mean, share, table, times

SHOWN = {  # of each program of Google Benchmark: what is not shown
    'real_time_ns', 'cpu_time_ns', 'real_time_us', 'cpu_time_us', 'real_time_ms', 'cpu_time_ms', 'items_per_second',
    'bytes_per_second', 'repetition_index'}


def as_table(rows, columns, names=None):
    return table([(names or {}).get(c, c.replace('_', ' ')) for c in columns], [[r.get(c) for c in columns] for r in rows])


def headlines(rows):
    """Their table. A number has as many figures as tell it from the goal that it misses."""
    def told_apart(found, goal):
        if isinstance(found, float) and isinstance(goal, float) and found != goal and float(brief(found)) == goal:
            return next(text for text in (f'{found:.{digits}g}' for digits in range(3, 18)) if float(text) != goal)
        return found
    return as_table([{**r, 'found': told_apart(r.get('found'), r.get('asked'))} for r in rows.of['headline']],
                    ['claim', 'asked', 'aim', 'found', 'peer', 'setting'], {'asked': 'goal', 'aim': 'hoped for'})


def write_peers(rows, folder, foot):
    if not (rows.of['against'] or rows.of['judged'] or rows.of['cut']):
        return
    parts = ['''# Other libraries beside typemesh

The same texts and fonts, in the same run, each library at the setting nearest to ours in chord error: how far a mesh's edges are from the
font's curves is measured by one program for all, and stands beside the time, for a coarse mesh is not a fast one. `state`: `cold`, nothing is
kept; `reuse`, letters are within a text; `warm`, from text to text; `placed`, finished letters are only placed. Times are by the processor's
clock, as multiples of typemesh's in the same state, or in `reuse` for a peer that is only `cold` (median, least and largest over rounds in
which they took turns). "At the same error": of typemesh's time at the tolerance that gives the peer's chord error (9 of 10 chords).
''']
    if rows.of['headline']:
        parts += ['## Headlines', headlines(rows)]
    columns = ['text', 'state', 'peer', 'setting', 'times', 'least', 'largest', 'times_same_error', 'chord_p90_em', 'chord_largest_em']
    names = {'times': '× typemesh\'s time', 'times_same_error': '× at the same error', 'chord_p90_em': 'chord error, 9 of 10 (em)',
             'chord_largest_em': 'the largest'}
    titles = {'native': 'Times', 'node': 'Times of JavaScript libraries (node: another clock and compiler)',
              'process': 'Times of whole processes (start, fonts and files included)'}
    for clock, title in titles.items():
        for solid in ('extruded', 'bevelled', 'wrapped', 'flat'):
            found = [r for r in rows.of['against'] if r['clock'] == clock and r['solid'] == solid]
            if found:
                parts += [f'## {title}: {solid}', as_table(found, columns, names)]
    if rows.of['judged']:
        for r in rows.of['judged']:
            r['font'] = pathlib.Path(str(r['font'])).name
        parts += ['## Faults of meshes', '''Of the characters of ASCII and Latin up to U+024F that the font has, a mesh each: `lost`, none was made; `area`, its cap covers another
area than the non-zero rule fills; `open`, an edge without its counterpart; `flipped`, a triangle of a cap looks to the other side;
`wrong`, any of these. Of bevelled meshes only open edges are counted.
''', as_table(rows.of['judged'], ['font', 'peer', 'setting', 'characters', 'lost', 'area', 'open', 'flipped', 'wrong',
                                  'chord_p90_em', 'chord_largest_em', 'triangles', 'vertices'], names)]
    if rows.of['fewest']:
        for r in rows.of['fewest']:
            r['font'] = pathlib.Path(str(r['font'])).name
        parts += ['## Triangles', "typemesh's triangles at each peer's own chord error, by those of the peer.\n",
                  as_table(rows.of['fewest'], ['font', 'peer', 'setting', 'chord_p90_em', 'chord_largest_em', 'triangles',
                                               'of_peer_same_p90', 'of_peer_same_largest'],
                           {**names, 'of_peer_same_p90': "typemesh's by the peer's, same error in 9 of 10",
                            'of_peer_same_largest': 'same largest error'})]
    for clock in ('native', 'node'):
        found = [r for r in rows.of['cut'] if r['clock'] == clock]
        if found:
            parts += [f'## Triangulation alone{"" if clock == "native" else ", in node"}', cut_table(found)]
    notes = [f'* {words}' for part, words in rows.notes if part == 'peers']
    if notes:
        parts += ['## What the figures mean', '', *dict.fromkeys(notes)]
    (folder / 'peers.md').write_text('\n'.join(parts) + '\n' + foot, encoding='utf-8')


def cut_table(found):
    """Each peer's time a glyph by the least of typemesh's on the same glyphs (in node, by the fastest there)."""
    least = {}
    for r in found:
        key = r['font'], r['tolerance']
        if r['time_us_a_glyph'] and (r['peer'].startswith('typemesh') or not any(q['peer'].startswith('typemesh') for q in found)):
            least[key] = min(least.get(key, 1e30), r['time_us_a_glyph'])
    own = any(r['peer'].startswith('typemesh') for r in found)
    body = [[pathlib.Path(str(r['font'])).name, r['tolerance'], r['points_a_glyph'], r['peer'],
             times(r['time_us_a_glyph'] / least[r['font'], r['tolerance']] if r['time_us_a_glyph'] else None), r['wrong']] for r in found
            if (r['font'], r['tolerance']) in least]
    return table(['font', 'tolerance (em)', 'points a glyph', 'library',
                  "× the faster of typemesh's" if own else '× the fastest of these', 'wrong'], body)


def write_kernels(rows, folder, foot):
    programs = collections.OrderedDict()
    for r in rows.of['kernel']:
        if r['counter'] not in SHOWN and r['value'] is not None:
            programs.setdefault(r['program'], collections.OrderedDict()).setdefault(r['name'], {})[r['counter']] = r['value']
    if not programs and not rows.of['compiled']:
        return
    parts = ['# The parts of typemesh, beside their floors\n\nThese are the programs `bench/*.bench.cpp`. The first lines of each '
             'explain its columns. Compare ratios, not times.\n']
    for program, named in programs.items():
        groups = collections.OrderedDict()  # rows with the same counters in one table
        for name, counters in named.items():
            groups.setdefault(tuple(counters), []).append(name)
        parts.append(f'## {program.removeprefix("bench_")}\n')
        for counters, names in groups.items():
            parts.append(table(['', *(c.replace('_', ' ') for c in counters)],
                               [[f'`{n}`', *(brief(named[n][c], 3) for c in counters)] for n in names]))
    if rows.of['compiled']:
        parts += ['## Compile times', """Seconds of the compiler's own time, the less of two runs; also by the time of a program that uses `<regex>` once, compiled in the same
minute. Its memory and the code in the object do not depend on the machine's load.
""", as_table(rows.of['compiled'], ['program', 'seconds', 'yardsticks', 'memory_mb', 'code_kb'],
              {'yardsticks': 'by `<regex>`', 'memory_mb': 'memory (MB)', 'code_kb': 'code (kB)'})]
    (folder / 'kernels.md').write_text('\n'.join(parts) + '\n' + foot, encoding='utf-8')


def kernel(rows, program, name, counter):
    for r in rows.of['kernel']:
        if (r['program'], r['name'], r['counter']) == (program, name, counter):
            return r['value']
    return None


def figures_of(rows, p):
    """All that the reading (reading.md) can ask for by name."""
    found = {}
    if p is not None and p.cells:
        for key, m in zip(('mono_thesis', 'cdt_thesis', 'mono', 'cdt'), MAKERS):
            for solid in ('flat', 'extruded', 'bevelled'):
                ratio = p.against_d3dx(solid, m)
                found[f'{solid}_{key}_of_d3dx'] = times(ratio)
                found[f'{solid}_{key}_faster_than_d3dx'] = times(1 / ratio if ratio else None)
            found[f'best_{key}_of_d3dx'] = times(p.against_d3dx('extruded', m, lambda r: r['quality'] == 'best'))
            t = {s: p.group_mean(s, m) for s in ('flat', 'extruded', 'bevelled')}
            if all(t.values()):
                floor = p.floor('outline_us')
                found[f'extrusion_share_{key}'] = share(1 - t['flat'] / t['extruded'])
                found[f'floor_{key}'] = times(t['extruded'] / floor)
                found[f'bevelled_{key}'] = times(t['bevelled'] / t['extruded'])
                found[f'triangulation_share_{key}'] = share(p.stages('flat', m)[2])
        both = [p.group_mean('extruded', m) for m in MAKERS]
        if all(both):
            found['cdt_of_mono'], found['cdt_of_mono_thesis'] = times(both[3] / both[2]), times(both[1] / both[0])
            found['thesis_curves_of_certified'] = times(both[0] / both[2])
    for name in ('hello', 'lorem', 'arabic', 'japanese', 'chinese'):
        for counter in ('cold_of_floor', 'cold_reuse_of_floor', 'warm_of_hand'):
            found[f'{name}_{counter}'] = times(kernel(rows, 'bench_text', f'text/{name}', counter))
    return found


class Dashes(dict):
    def __missing__(self, key):
        return '-'


def peers_reading(rows):
    if not rows.of['headline']:
        return 'The peers were not measured.\n'
    missed = [f'* {words}\n' for _, words in rows.notes if words.startswith('Missed')]
    return headlines(rows) + '\n' + ''.join(missed)


STATES = {'placed': 'where finished letters of a cache are only placed and not written as one mesh', 'warm': 'with a warm cache',
          'reuse': 'cold', 'cold': 'cold'}


def peers_that_win(rows):
    """Where a peer needs less time than typemesh in the same state, at typemesh's usual tolerance or at the peer's error."""
    faster = [r for r in rows.of['against'] if (r['times'] is not None and r['times'] < 1) or
              (r['times_same_error'] is not None and r['times_same_error'] < 1)]
    fewer = [r for r in rows.of['fewest'] if r['of_peer_same_p90'] is not None and r['of_peer_same_p90'] > 1.0]
    words = []
    groups = collections.OrderedDict()
    for r in faster:
        groups.setdefault((r['peer'], r['setting'], r['solid'], r['state']), []).append(r)
    for (peer, setting, solid, state), found in groups.items():
        ratios = [min(v for v in (r['times'], r['times_same_error']) if v is not None) for r in found]
        words.append(f'* {peer} ({setting}), {solid}, {STATES.get(state, state)}: {times(min(ratios))} to {times(max(ratios))} our time on '
                     f'{len(found)} text{"s" if len(found) > 1 else ""}; its chord error is {brief(found[0]["chord_p90_em"])} em.')
    by_peer = collections.defaultdict(list)
    for r in fewer:
        by_peer[r['peer']].append(r['of_peer_same_p90'])
    for peer, ratios in by_peer.items():
        words.append(f'* {peer} needs fewer triangles at the error of its 9 of 10 chords: ours are up to {times(max(ratios))} its own '
                     f'({len(ratios)} settings, median {times(statistics.median(ratios))}).')
    if not rows.of['against']:
        return 'The peers were not measured.\n'
    return '\n'.join(words) + '\n' if words else 'In no row that was measured.\n'


def write_reading(rows, protocol, folder, foot):
    template = (pathlib.Path(__file__).parent / 'reading.md').read_text(encoding='utf-8')
    found = Dashes(figures_of(rows, protocol))
    found['headlines'], found['peers_that_win'] = peers_reading(rows), peers_that_win(rows)
    d3dx = [r for r in rows.of['d3dx'] if r['triangles']]
    found['d3dx_cells'] = len(d3dx)
    found['mean_floor'] = brief(mean([r['outline_us'] for r in rows.of['thesis_floor']]))
    (folder / 'README.md').write_text(template.format_map(found) + '\n' + foot, encoding='utf-8')
