# SPDX-License-Identifier: MIT
"""Rows of a report of Google Benchmark: kernel_rows.py PROGRAM REPORT.json"""

import json
import sys

program, path = sys.argv[1:]
try:
    with open(path, encoding='utf-8') as file:
        report = json.load(file)
except (OSError, ValueError):
    print('skipped', program, 'its report is missing or not whole', sep='\t')
    sys.exit()
own = {'name', 'run_name', 'run_type', 'family_index', 'per_family_instance_index', 'repetitions', 'repetition_index', 'threads',
       'iterations', 'time_unit', 'label'}
for row in report['benchmarks']:
    for counter, value in row.items():
        if counter not in own and isinstance(value, (int, float)):
            unit = '_' + row['time_unit'] if counter in ('real_time', 'cpu_time') else ''
            print('kernel', program, row['name'], counter + unit, f'{value:.6g}', sep='\t')
