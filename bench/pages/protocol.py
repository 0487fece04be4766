# SPDX-License-Identifier: MIT
"""What the rows of bench_thesis and of D3DXCreateText say together."""

import collections
import statistics

from rows import mean

QUALITIES = ['low', 'normal', 'high', 'best']
DEVIATIONS = dict(zip(QUALITIES, (0.1, 0.01, 0.005, 0.001)))
MAKERS = [('monotone', 'thesis'), ('constrained Delaunay', 'thesis'), ('monotone', 'certified'), ('constrained Delaunay', 'certified')]


def category(row):
    return row['category'] if row['script'] == 'latin' else row['script']


class Protocol:
    """Medians of all cells, by what they are made with; the shortest times of D3DXCreateText, where it made a mesh."""

    def __init__(self, rows):
        self.rows = rows
        self.cells = collections.defaultdict(dict)  # solid, maker -> cell -> microseconds
        self.of_cell = {}
        for r in rows.of['thesis']:
            cell = r['font'], r['category'], r['text'], r['quality']
            self.cells[r['solid'], (r['triangulator'], r['discretiser'])][cell] = r['median_us']
            self.of_cell[cell] = r
        quality_of = {d: q for q, d in DEVIATIONS.items()}
        self.d3dx = {}
        for r in rows.of['d3dx']:
            if r['deviation'] in quality_of and r['triangles']:
                cell = r['font'], r['category'], r['text'], quality_of[r['deviation']]
                self.d3dx[cell] = min(r['shortest_us'], self.d3dx.get(cell, r['shortest_us']))
        self.floors = {(r['font'], r['script'], r['category'], r['quality']): r for r in rows.of['thesis_floor']}

    def mean(self, solid, maker, wants=lambda row: True):
        return mean(t for cell, t in self.cells[solid, maker].items() if wants(self.of_cell[cell]))

    def drawn(self, maker, wants=lambda row: True):
        """What the figures show, extruded: of D3DXCreateText, or, where that was not measured, of shaping and outlines."""
        if self.d3dx:
            return self.against_d3dx('extruded', maker, wants)
        own, floor = self.group_mean('extruded', maker, wants), self.floor('outline_us', wants)
        return own / floor if own and floor else None

    def against_d3dx(self, solid, maker, wants=lambda row: True):
        """The median of the cells' ratios: where Wine was disturbed in all runs of a cell, it does not count for more than one."""
        ratios = [t / self.d3dx[cell] for cell, t in self.cells[solid, maker].items()
                  if cell in self.d3dx and wants(self.of_cell[cell])]
        return statistics.median(ratios) if ratios else None

    def group_mean(self, solid, maker, wants=lambda row: True):
        """By the processor's clock: the mean over all texts, each group's mean counted once for each of its texts."""
        groups = [r for r in self.rows.of['thesis_group']
                  if r['solid'] == solid and (r['triangulator'], r['discretiser']) == maker and wants(r)]
        texts = sum(r['texts'] for r in groups)
        return sum(r['mean_us'] * r['texts'] for r in groups) / texts if texts else None

    def floor(self, column, wants=lambda row: True):
        sizes = {(r['font'], r['script'], r['category']): r['texts'] for r in self.rows.of['thesis_group']}
        wanted = [(r[column], sizes[r['font'], r['script'], r['category']]) for r in self.floors.values() if wants(r)]
        texts = sum(n for _, n in wanted)
        return sum(v * n for v, n in wanted) / texts if texts else None

    def stages(self, solid, maker):
        """Means over the texts: extraction, discretisation, fill and triangulation, extruding and writing."""
        found = [r for r in self.rows.of['thesis_stages']
                 if r['solid'] == solid and (r['triangulator'], r['discretiser']) == maker]
        sizes = {(r['font'], r['script'], r['category']): r['texts'] for r in self.rows.of['thesis_group']}
        sums = [0.0, 0.0, 0.0, 0.0]
        for r in found:
            n = sizes[r['font'], r['script'], r['category']]
            for i, names in enumerate((('shape_us', 'outline_us'), ('discretise_us',), ('fill_us', 'triangulate_us'), ('extrude_us',))):
                sums[i] += n * sum(r[name] for name in names)
        return [s / sum(sums) for s in sums] if sum(sums) else None
