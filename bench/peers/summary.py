# SPDX-License-Identifier: MIT
#
# From what run.sh has timed and judged: the rows "time", "against", "fewest" and "headline" (see ../README.md).
#
#     summary.py FOLDER JUDGED       FOLDER has ROUND.PEER.peer.tsv and ROUND.PEER.typemesh.tsv, run one after the other
#
# against    a peer's time in typemesh's, of the same text, solid and state, the median of the rounds with the least and the largest;
#            a peer that builds every letter anew stands against typemesh's reuse, which builds the same mesh.
#            At the same error: typemesh with the tolerance at which its 90th percentile of the chord error is the peer's
# fewest     triangles of all letters judged, and typemesh's at the same error: between the judged tolerances by interpolation
import collections
import math
import pathlib
import statistics
import sys

US = 'typemesh'
MAIN = '1/800 em'
LATIN = 'LiberationSans-Regular.ttf'
JUDGED_IN = {'hello, overlaps': 'Inter-roman.var.ttf'}  # other texts: in LATIN
OTHER_CLOCKS = {'three.js TextGeometry': 'node', 'three-text': 'node', 'OpenSCAD': 'process'}
STATES = {'cold': 'reuse', 'reuse': 'reuse', 'warm': 'warm', 'placed': 'placed'}


def rows(file, kind):
    for line in open(file, encoding='utf-8'):
        fields = line.rstrip('\n').split('\t')
        if fields[0] == kind:
            yield fields[1:]


def show(*fields):
    print(*fields, sep='\t')


def brief(x):
    return '-' if x is None else f'{x:.4g}'


class Judged:
    """The verdicts, and typemesh's at any error between its tolerances."""

    def __init__(self, file):
        self.all = {}
        for peer, setting, font, *numbers in rows(file, 'judged'):
            names = 'characters lost area open flipped wrong p90 largest triangles vertices'.split()
            self.all[peer, setting, font] = {n: None if x == '-' else float(x) for n, x in zip(names, numbers)}
        self.ladder = collections.defaultdict(list)
        for (peer, setting, font), v in self.all.items():
            if peer == US and v['p90']:
                self.ladder[font].append((v, setting))
        for steps in self.ladder.values():
            steps.sort(key=lambda step: step[0]['p90'])

    def of(self, peer, setting, font=LATIN):
        return self.all.get((peer, setting, font))

    def between(self, font, measure, error, value):
        """value(verdict, setting) of typemesh where its measure is this error, linear in logarithms; None outside."""
        steps = self.ladder[font]
        for (a, a_setting), (b, b_setting) in zip(steps, steps[1:]):
            if error and a[measure] <= error <= b[measure]:
                x, y = value(a, a_setting), value(b, b_setting)
                if not x or not y:
                    return None
                part = math.log(error / a[measure]) / math.log(b[measure] / a[measure]) if b[measure] > a[measure] else 0
                return x * (y / x) ** part
        return None


def read_times(folder):
    """Times by peer, setting, solid, state, text; of each a list over rounds, and typemesh's beside it."""
    own, others, pairs, sizes = (collections.defaultdict(list) for _ in range(4))
    for file in sorted(pathlib.Path(folder).glob('*.typemesh.tsv')):
        beside = {}
        for row in rows(file, 'time'):
            key = tuple(row[:5])
            beside[key] = float(row[5])
            own[key].append(float(row[5]))
            sizes[key] = row[6:]
        peer_file = file.with_name(file.name.replace('.typemesh.tsv', '.peer.tsv'))
        for row in rows(peer_file, 'time') if peer_file.exists() else ():
            key = peer, setting, solid, state, text = tuple(row[:5])
            others[key].append(float(row[5]))
            sizes[key] = row[6:]
            mine = beside.get((US, MAIN, solid, STATES[state], text))
            if mine:
                pairs[key].append(float(row[5]) / mine)
    return own, others, pairs, sizes


def against(own, others, pairs, judged):
    show('columns', 'against', *'text solid state peer setting clock times least largest times_same_error chord_p90_em '
         'chord_largest_em'.split())
    found = []
    for key, ratios in pairs.items():
        peer, setting, solid, state, text = key
        font = JUDGED_IN.get(text, LATIN)
        verdict = judged.of(peer, setting, font) or {'p90': None, 'largest': None}
        same = None
        if solid == 'extruded' and STATES[state] == 'reuse':
            mine = judged.between(font, 'p90', verdict['p90'], lambda v, s: statistics.median(
                own.get((US, s, 'extruded', 'reuse', text), [0])))
            same = statistics.median(others[key]) / mine if mine else None
        found.append((text, solid, state, peer, setting, statistics.median(ratios), min(ratios), max(ratios), same, verdict))
    order = {text: i for i, text in enumerate(dict.fromkeys(f[0] for f in found))}
    found.sort(key=lambda f: (f[1] != 'extruded', f[1], order[f[0]], f[2] in ('warm', 'placed'), f[2] == 'placed', f[5]))
    for text, solid, state, peer, setting, middle, low, high, same, verdict in found:
        clock = OTHER_CLOCKS.get(peer, 'native')
        numbers = middle, low, high, same, verdict['p90'], verdict['largest']
        show('against', text, solid, state, peer, setting, clock, *map(brief, numbers))
    return found


def fewest(judged):
    show('columns', 'fewest', *'font peer setting chord_p90_em chord_largest_em triangles typemesh_same_p90 typemesh_same_largest '
         'of_peer_same_p90 of_peer_same_largest'.split())
    found = []
    for (peer, setting, font), v in judged.all.items():
        if peer == US or not v['p90'] or v['lost'] > v['characters'] / 2:
            continue
        whole = [judged.between(font, m, v[m], lambda step, _: step['triangles']) for m in ('p90', 'largest')]
        parts = [w * (1 - v['lost'] / v['characters']) / v['triangles'] if w else None for w in whole]
        found.append((font, peer, setting, *parts))
        show('fewest', font, peer, setting, brief(v['p90']), brief(v['largest']), int(v['triangles']),
             *('-' if w is None else round(w) for w in whole), *map(brief, parts))
    return found


def fastest(found, judged, text, states, exact, native):
    """Of the peers as exact as typemesh: by the 90th percentile, or by the largest error as well; all, or the native ones."""
    own = judged.of(US, MAIN)
    fit = [f for f in found if f[0] == text and f[1] == 'extruded' and f[2] in states and f[9]['p90']
           and not (native and f[3] in OTHER_CLOCKS)
           and f[9]['p90'] <= own['p90'] * 1.02 and (not exact or f[9]['largest'] <= own['largest'] * 1.02)]
    return min(fit, key=lambda f: f[5], default=None)


def missed(claim, asked, best, judged, own_times):
    mine = {state: statistics.median(own_times[US, MAIN, 'extruded', state, best[0]]) for state in ('reuse', 'warm')}
    whole = mine[STATES[best[2]]]
    floor = statistics.median(own_times['floor', 'shaping and outlines', '-', 'cold', best[0]])
    work = 'typemesh\'s time is HarfBuzz\'s shaping and the writing of every vertex and index'
    if best[2] != 'warm':
        work = f'of typemesh\'s time {floor / whole:.2f} is HarfBuzz alone, shaping and writing letters that are there {mine["warm"] / whole:.2f}: the rest builds letters'
    own, peer = judged.of(US, MAIN), best[9]
    largest, triangles = (brief(peer[n] / own[n]) for n in ('largest', 'triangles'))
    show('note', f'Missed: {claim}: {brief(best[5])} of {asked}, beside {best[3]} ({best[4]}, {best[2]}), whose largest chord error is '
         f'{largest} times typemesh\'s, with {triangles} times the triangles; {work}.' +
         (f' typemesh with the same 90th percentile of the error is {brief(best[8])} times as fast.' if best[8] else ''))


def headlines(found, least, judged, own):
    show('columns', 'headline', *'claim asked aim found peer setting'.split())
    for claim, text, states, asked, aim in (('cold "Hello world!", times faster', 'hello', ('cold', 'reuse'), 10, 20),
                                            ('cold lorem ipsum, times faster', 'lorem', ('cold', 'reuse'), 20, 50),
                                            ('warm "Hello world!", times faster', 'hello', ('warm',), 15, 15),
                                            ('warm lorem ipsum, times faster', 'lorem', ('warm',), 15, 15)):
        for exact, native, kind in ((False, False, 'peers as exact in 9 of 10 chords'), (True, False, 'and in the largest error'),
                                    (True, True, 'and native')):
            best = fastest(found, judged, text, states, exact, native)
            if best:
                show('headline', f'{claim}; {kind}', asked, aim, brief(best[5]), best[3], best[4])
            if best and best[5] < asked:
                missed(f'{claim}; {kind}', asked, best, judged, own)
    for i, measure in ((3, '9 of 10 chords'), (4, 'the largest error')):
        worst = max((f for f in least if f[i] is not None), key=lambda f: f[i], default=None)
        if worst:
            claim = f'triangles of those of the peer with the fewest at the same error, by {measure}; {worst[0]}'
            show('headline', claim, 'at most 1.05', '-', f'{worst[i]:.3f}', worst[1], worst[2])
    wrong = collections.Counter()
    for (peer, setting, _), v in judged.all.items():
        wrong[peer] += 0 if 'bevelled' in setting else int(v['wrong'])
    show('headline', 'wrong meshes of letters, all settings', 0, 0, wrong[US], US, 'all')
    right = ', '.join(p for p, n in wrong.items() if n == 0 and p != US) or 'none'
    show('headline', 'peers without a wrong mesh', 'at most three-text and Qt 3D', '-', right, '-', '-')


NOTES = """
Times are processor times. For node it is the shorter of processor and wall time. For OpenSCAD it is the whole process; an empty model takes most of it.
The chord error is the distance of the boundary of a letter's front from the font's own curves, over ASCII and Latin to U+024F: what 9 of \
10 chords of curves stay below, and the largest of all letters that are right. It is of Liberation Sans, of Inter for the text with \
overlaps; texts in further fonts are shown with Liberation Sans' at that setting.
A peer with a fixed number of steps a curve is exact on small curves and coarse on large ones: it is as exact as typemesh in 9 of 10 \
chords long before it is in the largest error. Both are listed; typemesh's tolerance bounds the largest.
FTGL and osgText place letters that they keep: no mesh of the text is written. They do not shape, nor do VTK, Coin, Blender and three.js: \
these map characters to glyphs, in Arabic, too. typemesh's time beside them has HarfBuzz's shaping in it.
Coin crashes on texts beyond ASCII: those letters count as lost. Its outlines are hinted, which moves them by up to 0.03 em. VTK has a face \
of its own, and no curves to judge by.
OCCT and OpenSCAD hand over no normals. FTGL, Qt 3D, Coin, three.js, three-text and typemesh do; typemesh writes texture coordinates, too.
troika, TextMeshPro and the like draw text on rectangles: there is no mesh to compare.
""".replace('\\\n', '').strip().splitlines()


def main():
    own, others, pairs, sizes = read_times(sys.argv[1])
    judged = Judged(sys.argv[2])
    show('columns', 'time', *'peer setting solid state text time_us triangles vertices clock'.split())
    for key, times in [*own.items(), *others.items()]:
        show('time', *key, f'{statistics.median(times):.3f}', *sizes[key])
    found = against(own, others, pairs, judged)
    headlines(found, fewest(judged), judged, own)
    for words in NOTES:
        show('note', words)


main()
