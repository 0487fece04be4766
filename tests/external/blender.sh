# SPDX-License-Identifier: MIT
#
# Blender imports every kind of solid as STL and as GLB: its vertices united, each edge has two faces that run along it in
# opposite directions, no face has no area, and the volume is right.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
command -v blender >/dev/null 2>&1 || { echo "blender is not installed"; exit 77; }
export HOME=$scratch  # its settings

kinds=0
write() {  # write NAME FONT TEXT OPTION...
    local volume
    write_kind "$scratch/$1.stl" "$@" || return
    read -r volume _ < <(binary_corners "$scratch/$1.stl" | measure)
    printf '%s.stl %s\n' "$1" "$volume" >>"$scratch/files"
    case $1 in
        colour | svg*) ;;  # their colours are several solids in a GLB
        *) write_kind "$scratch/$1.glb" "$@" --touching part --size 10 && printf '%s.glb %s\n' "$1" "$volume" >>"$scratch/files" ;;
    esac
    kinds=$((kinds + 1))
}
for_every_kind write

cat >"$scratch/look.py" <<'END'
import bmesh, bpy, sys

folder = sys.argv[-1]
try:
    import numpy
    numpy.bool = bool  # Blender 3.4 uses the old name, which newer versions of NumPy lack
except ImportError:
    numpy = None
for line in open(folder + "/files"):
    name, volume = line.split()
    if name.endswith(".glb") and numpy is None:  # its reader needs that
        print("skipped", name)
        continue
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if name.endswith(".glb"):
        bpy.ops.import_scene.gltf(filepath=folder + "/" + name)
    else:
        bpy.ops.import_mesh.stl(filepath=folder + "/" + name)
    # Vertices at one place are one; Blender's own operator leaves some of them apart.
    places, faces = {}, []
    for thing in bpy.data.objects:
        if thing.type == "MESH":
            mesh = thing.data
            at = [places.setdefault(tuple(v.co), len(places)) for v in mesh.vertices]
            faces += [[at[i] for i in p.vertices] for p in mesh.polygons]
    whole = bpy.data.meshes.new("whole")
    whole.from_pydata(list(places), [], faces)
    bm = bmesh.new()
    bm.from_mesh(whole)
    edges = sum(not e.is_manifold or not e.is_contiguous for e in bm.edges)
    points = sum(not v.is_manifold for v in bm.verts)
    flat = sum(f.calc_area() <= 0.0 for f in bm.faces)
    own = bm.calc_volume(signed=True)
    fits = abs(own - float(volume)) <= 1e-3 * float(volume)
    print("seen", name, len(bm.faces), edges, points, flat, own, "good" if fits and edges == points == 0 and len(bm.faces) > 0 else "BAD")
    bm.free()
END
blender --background --factory-startup --python-exit-code 1 --python "$scratch/look.py" -- "$scratch" >"$scratch/words" 2>&1 ||
    fail "blender failed: $(tail -n 3 "$scratch/words")"
! grep '^seen.*BAD$' "$scratch/words" || fail "blender finds faults (file, faces, edges, points, faces without area, volume)"
! grep -q '^skipped' "$scratch/words" || echo "without GLB: blender has no numpy, which its reader needs (Debian package python3-numpy)"
[ "$(grep -cE '^seen.*good$|^skipped' "$scratch/words")" = "$(grep -c . "$scratch/files")" ] || fail "blender has not read all files"
echo "$kinds kinds"
[ "$failures" = 0 ] && [ "$kinds" -ge 25 ]
