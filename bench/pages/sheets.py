# SPDX-License-Identifier: MIT
"""Contact sheets: every text filled and as a wireframe, one picture a script. bench_thesis triangles | sheets.py FOLDER"""

import collections
import pathlib
import sys

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402
from PIL import Image  # noqa: E402

WIDTH = 66.0   # of a sheet, in its units
PIXELS = 24    # a unit
INK = '#16324f'


def read(lines):
    scripts = collections.defaultdict(list)
    for line in lines:
        script, font, text, points, corners = line.rstrip('\n').split('\t')
        xy = [float(v) for v in points.split()]
        at = list(zip(xy[0::2], xy[1::2]))
        abc = [int(v) for v in corners.split()]
        scripts[script, font].append((text, at, list(zip(abc[0::3], abc[1::3], abc[2::3]))))
    return scripts


def box(at):
    return min(x for x, _ in at), min(y for _, y in at), max(x for x, _ in at), max(y for _, y in at)


def place(texts):
    """Where each text's two pictures stand: (text, scale, x of filled, x of wireframe, baseline), and the sheet's height."""
    cells, x, y = [], 0.0, 0.0
    for text in (t for t in texts if len(t[0]) == 1 and t[1]):
        if x + 7.3 > WIDTH:
            x, y = 0.0, y - 4.6
        cells.append((text, 3.0, x + 0.3, x + 3.9, y - 3.3))
        x += 7.3
    y -= 5.0
    for text in (t for t in texts if len(t[0]) > 1 and t[1]):
        left, _, right, _ = box(text[1])
        scale = min(2.4, (WIDTH / 2 - 1) / (right - left))
        if scale > 1:
            y -= 3.6
            cells.append((text, scale, 0.3 - left, WIDTH / 2 + 0.3 - left, y))
        else:  # one below the other
            scale = (WIDTH - 1) / (right - left)
            y -= 3.0
            cells.append((text, scale, 0.3, None, y + 0.6))
            y -= 1.8
            cells.append((text, scale, None, 0.3, y + 0.6))
    return cells, 1.0 - y


def draw(texts, path):
    cells, height = place(texts)
    figure = plt.figure(figsize=(WIDTH * PIXELS / 100, height * PIXELS / 100), dpi=100)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.axis('off')
    axes.set_xlim(0, WIDTH)
    axes.set_ylim(-height, 0)
    solid, lines = [], []
    for (_, at, triangles), scale, x_filled, x_wired, y in cells:
        for t in triangles:
            if x_filled is not None:
                solid.append([(x_filled + scale * at[i][0], y + scale * at[i][1]) for i in t])
            if x_wired is not None:
                p = [(x_wired + scale * at[i][0], y + scale * at[i][1]) for i in t]
                lines += [(p[i], p[i - 2]) for i in range(3)]
    axes.add_collection(PolyCollection(solid, facecolors=INK, edgecolors=INK, linewidths=0.2))
    axes.add_collection(LineCollection(lines, colors=INK, linewidths=0.35))
    figure.savefig(path, facecolor='white')
    plt.close(figure)
    Image.open(path).convert('RGB').quantize(16, dither=Image.Dither.NONE).save(path, optimize=True)


def main():
    for (script, _), texts in read(sys.stdin).items():
        draw(texts, pathlib.Path(sys.argv[1]) / f'texts-{script}.png')
        print('note', f'{len(texts)} texts are drawn in texts-{script}.png', sep='\t')


main()
