# SPDX-License-Identifier: MIT
#
# OpenSCAD, as whole processes: it has no other way. The same commands, rows and files as peer_program.hpp.
#
#     openscad.py time TEXTS SECONDS | meshes FOLDER FONT
import array
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

DEPTH, SEGMENTS = 0.2, 4
EM = 100 / 0.72 / 100  # of a text of size 1
QUALITY = f'{SEGMENTS} segments a curve'


def family_of(file):
    return subprocess.run(['fc-scan', '--format', '%{family[0]}:style=%{style[0]}\n', file], capture_output=True,
                          text=True, check=True).stdout.splitlines()[0]


def script(text, family):
    quoted = text.replace('\\', '\\\\').replace('"', '\\"')
    return f'linear_extrude({100 * DEPTH}) text("{quoted}", size = {100 / EM}, font = "{family}", $fn = {SEGMENTS});\n'


def run(folder, name, text, family):
    source, made = f'{folder}/{name}.scad', f'{folder}/{name}.off'
    with open(source, 'w', encoding='utf-8') as out:
        out.write(script(text, family))
    subprocess.run(['openscad', '-o', made, source], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    return made


def read_off(file):
    words = iter(open(file).read().split())
    next(words)
    points, faces, _ = (int(next(words)) for _ in range(3))
    at = [float(next(words)) / 100 for _ in range(3 * points)]
    corners = []
    for _ in range(faces):
        ring = [int(next(words)) for _ in range(int(next(words)))]
        for b, c in zip(ring[1:], ring[2:]):
            corners += [ring[0], b, c]
    return at, corners


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def time_texts(texts, seconds):
    with tempfile.TemporaryDirectory() as folder:
        for line in open(texts, encoding='utf-8'):
            name, file, text = line.rstrip('\n').split('\t')
            family = family_of(file)
            runs, end = [], time.monotonic() + seconds
            while len(runs) < 3 or (time.monotonic() < end and len(runs) < 100):
                start = processor_seconds()
                made = run(folder, 'text', text, family)
                runs.append((processor_seconds() - start) * 1e6)
            points, corners = read_off(made)
            print('time', 'OpenSCAD', QUALITY, 'extruded', 'cold', name, f'{statistics.median(runs):.1f}', len(corners) // 3,
                  len(points) // 3, 'process', sep='\t', flush=True)


def write_meshes(folder, font):
    family = family_of(font)
    characters = [*range(0x21, 0x7f), *range(0xa1, 0xad), *range(0xae, 0x250)]
    with tempfile.TemporaryDirectory() as work, ThreadPoolExecutor(os.cpu_count()) as pool:

        def mesh(c):
            try:
                return read_off(run(work, str(c), chr(c), family))
            except (OSError, ValueError, StopIteration, subprocess.CalledProcessError):
                return [], []

        with open(f'{folder}/openscad.1.{font.replace("/", "_")}.meshes', 'wb') as out:
            out.write(f'OpenSCAD\t{QUALITY}\t{font}\n'.encode())
            for c, (points, corners) in zip(characters, pool.map(mesh, characters)):
                array.array('I', [c, len(points) // 3, len(corners) // 3]).tofile(out)
                array.array('f', points).tofile(out)
                array.array('I', corners).tofile(out)


if sys.argv[1] == 'time':
    time_texts(sys.argv[2], float(sys.argv[3]))
else:
    write_meshes(sys.argv[2], sys.argv[3])
