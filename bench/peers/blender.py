# SPDX-License-Identifier: MIT
#
# Blender's text objects; the same commands, rows and files as peer_program.hpp. Blender keeps the outlines of letters once it has
# read them. Run by Blender itself:
#
#     blender --background --factory-startup --python blender.py -- time TEXTS SECONDS | meshes FOLDER FONT
import array
import statistics
import sys
import time

import bpy

DEPTH, BEVEL = 0.2, 0.02  # in em
EM = 0.824  # of Liberation Sans at size 1: Blender has a measure of its own, and the judge brings its meshes to ours


def ways(file):
    try:
        font = bpy.data.fonts.load(file)
    except RuntimeError:
        return []
    return [(f'resolution {r}', solid, text_object(font, r, solid))
            for r, solid in ((3, 'extruded'), (4, 'extruded'), (12, 'extruded'), (4, 'bevelled'), (4, 'wrapped'))]


def text_object(font, resolution, solid):
    curve = bpy.data.curves.new('text', 'FONT')
    curve.font, curve.resolution_u = font, resolution
    curve.extrude = DEPTH / 2
    if solid == 'bevelled':
        curve.extrude, curve.bevel_depth, curve.bevel_resolution, curve.offset = DEPTH / 2 - BEVEL, BEVEL, 1, -BEVEL
    if solid == 'wrapped':
        curve.text_boxes[0].width = 12 * EM
        curve.align_x = 'JUSTIFY'
    return bpy.data.objects.new('text', curve)


def build(thing, text):
    thing.data.body = text
    return thing.to_mesh()


def microseconds_each(seconds, thing, text):
    runs, end = [], time.process_time() + seconds
    while len(runs) < 3 or (time.process_time() < end and len(runs) < 1000):
        start = time.process_time()
        build(thing, text)
        runs.append((time.process_time() - start) * 1e6)
    return statistics.median(runs)


def time_texts(texts, seconds):
    open_file, found = None, []
    for line in open(texts, encoding='utf-8'):
        name, file, text = line.rstrip('\n').split('\t')
        if file != open_file:
            open_file, found = file, ways(file)
        for setting, solid, thing in found:
            mesh = build(thing, text)
            mesh.calc_loop_triangles()
            sizes = len(mesh.loop_triangles), len(mesh.vertices)
            each = microseconds_each(seconds, thing, text)
            print('time', 'Blender', setting, solid, 'cold', name, f'{each:.3f}', *sizes, 'native', sep='\t', flush=True)


def write_meshes(folder, font):
    for i, (setting, solid, thing) in enumerate(ways(font), 1):
        if solid == 'wrapped':
            continue
        with open(f'{folder}/blender.{i}.{font.replace("/", "_")}.meshes', 'wb') as out:
            out.write(f'Blender\t{setting}{"" if solid == "extruded" else ", " + solid}\t{font}\n'.encode())
            for c in [*range(0x21, 0x7f), *range(0xa1, 0xad), *range(0xae, 0x250)]:
                mesh = build(thing, chr(c))
                mesh.calc_loop_triangles()
                points = array.array('f', bytes(12 * len(mesh.vertices)))
                corners = array.array('i', bytes(12 * len(mesh.loop_triangles)))
                mesh.vertices.foreach_get('co', points)
                mesh.loop_triangles.foreach_get('vertices', corners)
                array.array('I', [c, len(mesh.vertices), len(mesh.loop_triangles)]).tofile(out)
                points.tofile(out)
                corners.tofile(out)


command, a, b = sys.argv[sys.argv.index('--') + 1:]
if command == 'time':
    time_texts(a, float(b))
else:
    write_meshes(a, b)
