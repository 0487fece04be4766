# SPDX-License-Identifier: MIT
"""The thesis' figures 43 to 48 and its tables."""

import collections

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402

from protocol import MAKERS, QUALITIES, Protocol, category  # noqa: E402
from rows import share, table, times  # noqa: E402

NAMES = {m: f'{m[0]}, {"curves as in the thesis" if m[1] == "thesis" else "certified"}' for m in MAKERS}
SHORT = {m: ('monotone' if m[0] == 'monotone' else 'Delaunay') + '\n' + ("thesis' curves" if m[1] == 'thesis' else 'certified')
         for m in MAKERS}
LINE = {m: SHORT[m].replace('\n', ', ') for m in MAKERS}
COLOURS = dict(zip(MAKERS, ('#7fb3d5', '#a9cce3', '#1a5276', '#5499c7')))
D3DX, THESIS = '#b9770e', '#c0c0c0'

plt.rcParams.update({'svg.fonttype': 'none', 'svg.hashsalt': 'typemesh', 'font.family': 'sans-serif', 'font.size': 9,
                     'axes.spines.top': False, 'axes.spines.right': False, 'axes.axisbelow': True})


CATEGORIES = ['character', 'phrase', 'long', 'arabic', 'chinese', 'japanese']
CATEGORY_NAMES = {'character': 'Latin characters', 'phrase': 'Latin phrases', 'long': 'Latin, long', 'arabic': 'Arabic',
                  'chinese': 'Chinese', 'japanese': 'Japanese'}


def save(figure, folder, name):
    figure.savefig(folder / f'{name}.svg', bbox_inches='tight', metadata={'Date': None})
    plt.close(figure)


def bars(folder, name, title, groups, values, thesis, beside):
    """Grouped bars; values[maker] is a list over the groups; a dashed line is what they are set beside, grey bars what the thesis
    says of both of its algorithms (a list over groups, or None)."""
    figure, axes = plt.subplots(figsize=(7.2, 2.9))
    series = [(NAMES[m], COLOURS[m], values[m]) for m in MAKERS]
    if thesis:
        series.append(("the thesis' two algorithms, in its words", THESIS, thesis))
    width = 0.8 / len(series)
    for i, (words, colour, heights) in enumerate(series):
        at = [g + (i - (len(series) - 1) / 2) * width for g in range(len(groups))]
        drawn = axes.bar(at, [h or 0 for h in heights], width, color=colour, label=words)
        if len(groups) <= 6:
            axes.bar_label(drawn, [f'{h:.2g}' if h else '' for h in heights], fontsize=6)
    axes.axhline(1, color=D3DX, linestyle='--', linewidth=1, label=f'{beside} = 1')
    axes.set_xticks(range(len(groups)), groups)
    axes.set_ylabel(f'time by that of\n{beside}')
    axes.set_title(title, loc='left', fontsize=10)
    axes.legend(fontsize=7, frameon=False, loc='upper left', bbox_to_anchor=(1.0, 1.0))
    save(figure, folder, name)


def figure_44(folder, p):
    figure, axes = plt.subplots(figsize=(7.2, 2.5))
    rows = [("the thesis", [0.05, 0.001, 0.949, 0.0])] + [(NAMES[m], p.stages('flat', m)) for m in MAKERS]
    rows = [(name, parts) for name, parts in rows if parts][::-1]
    words = ['extraction (shaping, outlines)', 'discretisation', 'triangulation (with its proof)', 'writing']
    colours = ['#d4ac0d', '#1e8449', '#1a5276', '#aab7b8']
    left = [0.0] * len(rows)
    for i, word in enumerate(words):
        parts = [100 * r[1][i] for r in rows]
        drawn = axes.barh([r[0] for r in rows], parts, left=left, color=colours[i], label=word)
        axes.bar_label(drawn, [f'{v:.0f} %' if v > 4 else '' for v in parts], label_type='center', fontsize=7, color='white')
        left = [a + b for a, b in zip(left, parts)]
    axes.set_xlim(0, 100)
    axes.set_xlabel('% of the time, not extruded')
    axes.set_title('Figure 44: where the time goes', loc='left', fontsize=10)
    axes.legend(fontsize=7, frameon=False, ncol=4, loc='upper center', bbox_to_anchor=(0.4, -0.22))
    save(figure, folder, 'figure-44')


def figure_45(folder, p):
    base = p.mean('extruded', MAKERS[2])
    figure, axes = plt.subplots(figsize=(7.2, 2.9))
    for i, m in enumerate(MAKERS):
        for j, (solid, alpha) in enumerate((('flat', 0.45), ('extruded', 0.75), ('bevelled', 1.0))):
            height = (p.against_d3dx(solid, m) if p.d3dx else p.mean(solid, m) / base) or 0
            drawn = axes.bar(i + 0.27 * (j - 1), height, 0.27, color='#1a5276', alpha=alpha, label=solid if i == 0 else None)
            axes.bar_label(drawn, [f'{height:.2g}'], fontsize=7)
    words = 'D3DXCreateText (Wine), extruded' if p.d3dx else 'monotone, certified, extruded'
    axes.axhline(1, color=D3DX, linestyle='--', linewidth=1, label=f'{words} = 1')
    axes.set_xticks(range(len(MAKERS)), [SHORT[m] for m in MAKERS])
    axes.set_ylabel('time')
    axes.set_title('Figure 45: flat, extruded, bevelled', loc='left', fontsize=10)
    axes.legend(fontsize=7, frameon=False, loc='upper left', bbox_to_anchor=(1.0, 1.0))
    save(figure, folder, 'figure-45')


def beside(p):
    return 'D3DXCreateText (Wine)' if p.d3dx else "HarfBuzz's shaping and outlines"


def by(p, folder, number, what, groups, wants, thesis=None):
    values = {m: [p.drawn(m, wants(g)) for g, _ in groups] for m in MAKERS}
    bars(folder, f'figure-{number}', f'Figure {number}: {what}, extruded', [name for _, name in groups], values, thesis, beside(p))
    body = []
    for g, name in groups:
        w = wants(g)
        floor = p.floor('outline_us', w)
        means = [p.group_mean('extruded', m, w) for m in MAKERS]
        ratio = means[3] / means[2] if means[2] and means[3] else None
        body.append([name.replace('\n', ' ')] + [times(p.against_d3dx('extruded', m, w)) for m in MAKERS] + [times(ratio)] +
                    [times(t / floor if t and floor else None) for t in means[2:]])
    return table([what] + [f'{LINE[m]}: of D3DX' for m in MAKERS] + ['Delaunay by monotone, certified'] +
                 ['monotone, certified: of shaping and outlines', 'Delaunay, certified: the same'], body)


def solids(p):
    body = []
    for m in MAKERS:
        t = {s: p.group_mean(s, m) for s in ('flat', 'extruded', 'bevelled')}
        if not all(t.values()):
            continue
        median = {s: p.mean(s, m) for s in t}
        floors = [p.floor(c) for c in ('outline_us', 'sort_us', 'memcpy_us')]
        body.append([NAMES[m], share(1 - t['flat'] / t['extruded']), share(1 - median['flat'] / median['extruded']),
                     times(t['bevelled'] / t['extruded']), times(p.against_d3dx('flat', m)), times(p.against_d3dx('extruded', m)),
                     times(p.against_d3dx('bevelled', m)), *(times(t['extruded'] / f) for f in floors)])
    return table(['', 'share of extrusion, means', 'the same, medians', 'bevelled by extruded', 'flat: of D3DX extruded', 'extruded: of D3DX',
                  'bevelled: of D3DX extruded', 'extruded: of shaping and outlines', 'of a sort of its points', 'of a memcpy of its mesh'], body)


def every_cell(p):
    """The means of all groups, by font, category and quality: of shaping and outlines."""
    body = []
    groups = collections.OrderedDict()
    for r in p.rows.of['thesis_group']:
        groups.setdefault((r['font'], r['script'], r['category'], r['quality']), {})[
            r['solid'], (r['triangulator'], r['discretiser'])] = r['mean_us']
    for (font, script, kind, quality), t in groups.items():
        floor = p.floors.get((font, script, kind, quality))
        if floor:
            body.append([font, f'{script}, {kind}', quality] +
                        [times(t[s, m] / floor['outline_us']) if (s, m) in t else '-' for m in MAKERS
                         for s in ('flat', 'extruded', 'bevelled')])
    head = ['font', 'texts', 'quality'] + [f'{SHORT[m]}'.replace('\n', ', ') + f', {s}' for m in MAKERS
                                           for s in ('flat', 'extruded', 'bevelled')]
    return table(head, body)


def write(rows, folder, foot):
    p = Protocol(rows)
    if not p.cells:
        return p, None
    fonts = list(dict.fromkeys(r['font'] for r in p.of_cell.values()))
    figure_44(folder, p)
    figure_45(folder, p)
    tables = {
        46: by(p, folder, 46, 'by category', [(c, CATEGORY_NAMES[c].replace(' ', '\n', 1)) for c in CATEGORIES],
               lambda c: lambda r: category(r) == c),
        47: by(p, folder, 47, 'by quality', [(q, q) for q in QUALITIES], lambda q: lambda r: r['quality'] == q),
        48: by(p, folder, 48, 'by font', [(f, f.replace(' ', '\n', 1)) for f in fonts], lambda f: lambda r: r['font'] == f),
    }
    all_means = by(p, folder, 43, 'all cells', [(0, 'all texts, fonts and qualities')], lambda _: lambda r: True,
                   [2.0] if p.d3dx else None)
    stages = table(['not extruded', 'extraction', 'discretisation', 'triangulation', 'writing'],
                   [['the thesis', '~5 %', '<= 0.1 %', '~95 %', '-']] +
                   [[NAMES[m]] + [share(v) for v in p.stages('flat', m) or []] for m in MAKERS if p.stages('flat', m)])
    one = next(iter(p.of_cell.values()))
    bevelled = next((r for r in rows.of['thesis'] if r['solid'] == 'bevelled'), {'runs': 0})
    texts = len({(r['script'], r['category'], r['text']) for r in p.of_cell.values()})
    crashes = sum({r['font']: r['crashes'] for r in rows.of['d3dx_crashes']}.values())
    count = sum(len(v) for v in p.cells.values())
    lines = f"""# The benchmark of the thesis

"Study of mesh generation and optimization techniques applied to parametric forms" (J. Vandenbergh, 2020), chapter 7, repeated: its
{texts} texts, in free fonts that stand in for its own ({len(fonts)} in all; five for Latin, one for each other script, {len(p.of_cell) // 4} pairs of
text and font), at its four qualities, with monotone and constrained Delaunay triangulation, its own way to flatten curves and `certified`;
flat, extruded and bevelled: {count:.0f} cells, each of {one['runs']:.0f} runs ({bevelled['runs']:.0f} bevelled).

Timed is the whole way from a text to its finished mesh; opening the font and choosing the quality are not. Nothing is kept from one text to
the next, and each letter is built anew. The texts of a group follow each other in every run. Means of groups, and ratios to floors, are by
the processor's clock; a ratio to Direct3D is the median over the cells of our median time by its shortest, for it
waits for another process, which a busy machine delays. **It is Wine's D3DXCreateTextW**, extruded, at the
deviation that the thesis sets beside each quality, over the {len([c for c in p.d3dx if c in p.of_cell])} cells that it made ({crashes:.0f} meshes crashed
it); it sets no text right to left, joins no letters and repeats one text at once, which flatters it. The thesis printed its figures as bars
without values: grey is what it says of them in words.

## Figure 43: Direct3D and both algorithms

The thesis: 1 : ~2 : ~2, both of its algorithms slower than Direct3D.

![](figure-43.svg)

{all_means}
## Figure 44: where the time goes

![](figure-44.svg)

{stages}
## Figure 45: the share of extrusion

The thesis: more than half; without extrusion both algorithms are faster than Direct3D with it.

![](figure-45.svg)

{solids(p)}
## Figures 46 to 48: by category, quality and font

The thesis: the same trend in all of them.

![](figure-46.svg)

{tables[46]}
![](figure-47.svg)

{tables[47]}
![](figure-48.svg)

{tables[48]}
## Figure 56: every text, filled and as a wireframe

Monotone triangulation, `certified` at 1/160 em.

| Latin | Arabic | Chinese | Japanese |
|---|---|---|---|
| [![](texts-latin.png)](texts-latin.png) | [![](texts-arabic.png)](texts-arabic.png) | [![](texts-chinese.png)](texts-chinese.png) | [![](texts-japanese.png)](texts-japanese.png) |

## All groups

Means, of HarfBuzz's shaping and outlines of the same texts (processor's clock).

{every_cell(p)}
{foot}"""
    (folder / 'thesis.md').write_text(lines, encoding='utf-8')
    return p, count
