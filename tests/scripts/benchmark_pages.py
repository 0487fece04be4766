# SPDX-License-Identifier: MIT
"""What bench/pages makes of rows that are written here by hand. Needs python3 alone."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

pages = pathlib.Path(__file__).resolve().parents[2] / 'bench' / 'pages'
sys.dont_write_bytecode = True
sys.path.insert(0, str(pages))

import other_pages  # noqa: E402
from protocol import MAKERS, Protocol  # noqa: E402
from rows import Rows, brief, share, table, times  # noqa: E402

MONOTONE = MAKERS[2]
THESIS = 'columns thesis solid triangulator discretiser quality font script category text median_us'
GROUP = 'columns thesis_group solid triangulator discretiser quality font script category texts mean_us'
AGAINST = 'columns against text solid state peer setting clock times least largest times_same_error chord_p90_em'
CUT = 'columns cut peer font tolerance points_a_glyph time_us_a_glyph wrong clock'


def rows_of(**parts):
    """Rows from lines with / between their fields; a line of `columns` has blanks."""
    with tempfile.TemporaryDirectory() as folder:
        for part, lines in parts.items():
            text = '\n'.join(line.replace(' ', '\t') if line.startswith('columns') else line.replace('/', '\t') for line in lines)
            pathlib.Path(folder, f'{part}.tsv').write_text(text + '\n', encoding='utf-8')
        return Rows(folder)


def cell(text, median, solid='extruded', font='F', quality='best'):
    return '/'.join(('thesis', solid, *MONOTONE, quality, font, 'latin', 'phrase', text, str(median)))


class reading_rows(unittest.TestCase):
    def test_fields_are_numbers_words_or_nothing(self):
        rows = rows_of(a=['columns k name value', 'k/x/2.5', 'k/y/-', 'k/z/nan', 'k/inf/word'])
        self.assertEqual([r['value'] for r in rows.of['k']], [2.5, None, None, 'word'])
        self.assertEqual(rows.of['k'][3]['name'], None)

    def test_what_a_crash_cut_off_and_unknown_kinds_are_left_out(self):
        rows = rows_of(a=['k/early/1', 'columns k name value', 'k/whole/1', 'k/cut', 'other/1/2', '# k', ''])
        self.assertEqual([r['name'] for r in rows.of['k']], ['whole'])

    def test_columns_may_stand_again_and_belong_to_one_part(self):
        rows = rows_of(a=['columns k name value', 'k/x/1', 'columns k value', 'k/2'], b=['columns k value name', 'k/3/y'])
        self.assertEqual([(r.get('name'), r['value']) for r in rows.of['k']], [('x', 1), (None, 2), ('y', 3)])

    def test_skipped_notes_and_runs_keep_their_part(self):
        rows = rows_of(peers=['skipped/OCCT/no compiler', 'skipped/VTK', 'note/one/two', 'ran/peers/2026-01-02/abc/whole/75'])
        self.assertEqual(rows.skipped, [('peers', 'OCCT', 'no compiler'), ('peers', 'VTK', '')])
        self.assertEqual(rows.notes, [('peers', 'one two')])
        self.assertEqual(rows.ran, [['peers', '2026-01-02', 'abc', 'whole', '75']])


class writing_figures(unittest.TestCase):
    def test_figures_are_rounded_not_cut(self):
        for value, words in ((0, '0'), (0.0379, '0.038'), (1.26, '1.3'), (12.6, '13'), (156.7, '157'), (3.0, '3'), (None, '-')):
            self.assertEqual(brief(value), words)
        self.assertEqual((times(1.98), share(0.349), times(None), share(None)), ('2.0 ×', '35 %', '-', '-'))

    def test_a_table_has_a_cell_for_each_column(self):
        lines = table(['a', 'b'], [[1.0, None], ['x|y', 2.26]]).splitlines()
        self.assertEqual(lines, ['| a | b |', '|---|---|', '| 1 | - |', r'| x\|y | 2.3 |'])
        self.assertIn('Not measured', table(['a'], []))


class the_thesis_protocol(unittest.TestCase):
    D3DX = ['columns d3dx font script category text deviation shortest_us triangles']

    def test_a_ratio_to_d3dx_is_the_median_over_the_cells_that_it_made(self):
        protocol = Protocol(rows_of(
            thesis=[THESIS, cell('a', 10), cell('b', 40), cell('c', 90), cell('d', 1)],
            d3dx=self.D3DX + ['d3dx/F/latin/phrase/a/0.001/20/5', 'd3dx/F/latin/phrase/a/0.001/5/5', 'd3dx/F/latin/phrase/b/0.001/10/5',
                              'd3dx/F/latin/phrase/c/0.001/10/5', 'd3dx/F/latin/phrase/d/0.001/10/0', 'd3dx/F/latin/phrase/d/0.01/10/9']))
        self.assertEqual(protocol.against_d3dx('extruded', MONOTONE), 4)  # of 10/5, 40/10, 90/10: d was not made at this quality
        self.assertIsNone(protocol.against_d3dx('flat', MONOTONE))

    def test_means_of_groups_count_each_text_once(self):
        group = '/'.join(('thesis_group', 'flat', *MONOTONE, 'best', 'F', 'latin'))
        protocol = Protocol(rows_of(thesis=[
            GROUP, f'{group}/phrase/1/10', f'{group}/long/3/30', 'columns thesis_floor quality font script category outline_us',
            'thesis_floor/best/F/latin/phrase/1', 'thesis_floor/best/F/latin/long/5']))
        self.assertEqual(protocol.group_mean('flat', MONOTONE), 25)
        self.assertEqual(protocol.group_mean('flat', MONOTONE, lambda r: r['category'] == 'long'), 30)
        self.assertEqual(protocol.floor('outline_us'), 4)

    def test_shares_of_stages_add_up_to_the_whole(self):
        names = ('shape_us', 'outline_us', 'discretise_us', 'fill_us', 'triangulate_us', 'extrude_us')
        stages = Protocol(rows_of(thesis=[
            GROUP, '/'.join(('thesis_group', 'flat', *MONOTONE, 'best', 'F', 'latin', 'long', '2', '1')),
            'columns thesis_stages solid triangulator discretiser quality font script category ' + ' '.join(names),
            '/'.join(('thesis_stages', 'flat', *MONOTONE, 'best', 'F', 'latin', 'long', '1', '1', '2', '3', '1', '2'))])).stages('flat', MONOTONE)
        self.assertEqual(stages, [0.2, 0.2, 0.4, 0.2])


class the_other_pages(unittest.TestCase):
    def test_a_peer_wins_where_it_is_faster_in_either_way(self):
        rows = rows_of(peers=[AGAINST, 'against/hello/flat/cold/A/5 steps/native/3/2/4/0.8/0.01', 'against/lorem/flat/cold/A/5 steps/native/0.5/1/1/2/0.01',
                              'against/hello/flat/cold/B/x/native/3/2/4/-/0.01'])
        words = other_pages.peers_that_win(rows)
        self.assertIn('A (5 steps), flat, cold: 0.5 × to 0.8 × our time on 2 texts', words)
        self.assertNotIn('B (', words)

    def test_nothing_measured_is_said(self):
        self.assertIn('not measured', other_pages.peers_that_win(rows_of(a=[])))
        self.assertIn('not measured', other_pages.peers_reading(rows_of(a=[])))
        self.assertIn('In no row', other_pages.peers_that_win(rows_of(a=[AGAINST, 'against/t/flat/cold/A/s/native/2/1/3/-/0.1'])))

    def test_a_goal_that_is_missed_by_little_is_not_shown_as_reached(self):
        page = other_pages.peers_reading(rows_of(a=['columns headline claim asked aim found peer setting', 'headline/a/15/15/14.99/P/s',
                                                    'headline/b/15/15/15/P/s', 'headline/c/10/20/12.28/P/s', 'headline/d/at most 1.05/-/0.987/P/s']))
        for row in ('| a | 15 | 15 | 14.99 |', '| b | 15 | 15 | 15 |', '| c | 10 | 20 | 12 |', '| d | at most 1.05 | - | 0.99 |'):
            self.assertIn(row, page)

    def test_triangulators_are_set_beside_the_faster_of_typemesh(self):
        found = rows_of(a=[CUT, 'cut/typemesh monotone/F.ttf/0.01/9/2/0/native', 'cut/typemesh cdt/F.ttf/0.01/9/4/0/native',
                           'cut/GLU/F.ttf/0.01/9/7/3/native', 'cut/broken/F.ttf/0.01/9/-/-/native']).of['cut']
        lines = other_pages.cut_table(found).splitlines()
        self.assertTrue(lines[4].endswith('| GLU | 3.5 × | 3 |'), lines[4])
        self.assertTrue(lines[5].endswith('| broken | - | - |'), lines[5])
        self.assertIn("× the faster of typemesh's", lines[0])

    def test_the_reading_has_a_figure_or_a_dash_for_each_name(self):
        with tempfile.TemporaryDirectory() as folder:
            kernels = 'columns kernel program name counter value\nkernel bench_text text/hello cold_reuse_of_floor 6.81\n'
            pathlib.Path(folder, 'kernels.tsv').write_text(kernels.replace(' ', '\t'), encoding='utf-8')
            rows = Rows(folder)
            other_pages.write_reading(rows, Protocol(rows), pathlib.Path(folder), 'the foot')
            other_pages.write_kernels(rows, pathlib.Path(folder), 'the foot')
            page = pathlib.Path(folder, 'README.md').read_text(encoding='utf-8')
            self.assertIn('"Hello world!"\n6.8 ×, lorem ipsum -.', page)
            self.assertTrue(page.endswith('the foot'))
            self.assertNotIn('{', page)
            self.assertIn('| `text/hello` | 6.81 |', pathlib.Path(folder, 'kernels.md').read_text(encoding='utf-8'))


class reports_of_google_benchmark(unittest.TestCase):
    def rows(self, text):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder, 'report.json')
            if text:
                report.write_text(text, encoding='utf-8')
            return subprocess.run([sys.executable, str(pages / 'kernel_rows.py'), 'bench_x', str(report)], capture_output=True, text=True,
                                  check=True).stdout.splitlines()

    def test_counters_become_rows_with_their_unit(self):
        rows = self.rows('{"benchmarks": [{"name": "a/b", "iterations": 3, "time_unit": "us", "real_time": 2.5, "of_floor": 1.25}]}')
        self.assertEqual(rows, ['kernel\tbench_x\ta/b\treal_time_us\t2.5', 'kernel\tbench_x\ta/b\tof_floor\t1.25'])

    def test_a_report_that_is_missing_or_cut_off_is_named(self):
        for text in ('', '{"benchmarks": [{"na'):
            self.assertEqual(self.rows(text), ['skipped\tbench_x\tits report is missing or not whole'])


if __name__ == '__main__':
    unittest.main()
