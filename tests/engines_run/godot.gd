# SPDX-License-Identifier: MIT
#
# Run by godot.sh in a project that has imported text.glb (as it is) and packed.glb (as Godot does by default: normals in
# bytes). What is wrong is printed in lines that begin with "WRONG". The environment names what text_to_mesh has counted.
extends SceneTree

var parts = ["front", "back", "side"]
var wrong = 0

func check(holds, sentence):
	if not holds:
		wrong += 1
		print("WRONG: ", sentence)

func number(name):
	return int(OS.get_environment(name))

func meshes_of(node, found):
	if node is MeshInstance:
		found.append(node.mesh)
	for child in node.get_children():
		meshes_of(child, found)
	return found

func mesh_in(path):
	var scene = load(path)
	check(scene != null, path + " is imported")
	var found = meshes_of(scene.instance(), [])
	check(found.size() == 1, path + " holds one mesh")
	return found[0]

# Directed edges by the places of their ends: how often more along than back.
func count_edge(edges, a, b):
	if a < b:
		edges[[a, b]] = edges.get([a, b], 0) + 1
	else:
		edges[[b, a]] = edges.get([b, a], 0) - 1

func check_mesh(name, mesh, packed, off_normal):
	var off = 0.000001
	check((mesh.surface_get_format(0) & Mesh.ARRAY_COMPRESS_NORMAL != 0) == packed, name + ": packed or not as asked for")
	check(mesh.get_surface_count() == 3, name + ": a surface for each part")
	var triangles = 0
	var volume = 0.0
	var turned = 0
	var edges = {}
	var box = AABB()
	var first = true
	for s in mesh.get_surface_count():
		check(mesh.surface_get_primitive_type(s) == Mesh.PRIMITIVE_TRIANGLES, name + ": triangles")
		var material = mesh.surface_get_material(s)
		check(material != null and material.resource_name == parts[s], name + ": surface %d has the material %s" % [s, parts[s]])
		check(material != null and material.metallic == 0.0, name + ": %s is no metal" % parts[s])
		check(material != null and material.params_cull_mode == SpatialMaterial.CULL_BACK, name + ": backs of %s are culled" % parts[s])
		var arrays = mesh.surface_get_arrays(s)
		var places = arrays[Mesh.ARRAY_VERTEX]
		var normals = arrays[Mesh.ARRAY_NORMAL]
		var indices = arrays[Mesh.ARRAY_INDEX]
		check(places.size() == number("VERTICES"), name + ": %d vertices in a surface" % places.size())
		check(normals.size() == places.size(), name + ": a normal for each vertex")
		check(arrays[Mesh.ARRAY_TEX_UV].size() == places.size(), name + ": texture coordinates for each vertex")
		for n in normals:
			if abs(n.length() - 1.0) > off_normal:
				check(false, name + ": a normal of length %f" % n.length())
		triangles += indices.size() / 3
		if s < 2:
			check(indices.size() / 3 == number("FRONT_TRIANGLES"), name + ": %d triangles in the %s" % [indices.size() / 3, parts[s]])
		for i in range(0, indices.size(), 3):
			var a = places[indices[i]]
			var b = places[indices[i + 1]]
			var c = places[indices[i + 2]]
			var across = (b - a).cross(c - a)
			# Godot's front faces are clockwise: the cross product looks inwards.
			if across.dot(normals[indices[i]] + normals[indices[i + 1]] + normals[indices[i + 2]]) > 0.0:
				turned += 1
			volume -= a.dot(b.cross(c)) / 6.0
			count_edge(edges, a, b)
			count_edge(edges, b, c)
			count_edge(edges, c, a)
			for corner in [a, b, c]:
				box = AABB(corner, Vector3()) if first else box.expand(corner)
				first = false
			if s < 2:
				check(abs(a.z - (0.0 if s == 0 else -0.2)) <= off, name + ": %s at depth %f" % [parts[s], a.z])
	check(triangles == number("TRIANGLES"), name + ": %d triangles" % triangles)
	check(turned == 0, name + ": %d triangles are turned" % turned)
	var open = 0
	for edge in edges:
		if edges[edge] != 0:
			open += 1
	check(open == 0, name + ": %d open edges" % open)
	check(volume > 0.0, name + ": a volume of %f" % volume)
	var said = mesh.get_aabb()
	check(said.position.distance_to(box.position) < 0.0001 and said.end.distance_to(box.end) < 0.0001, name + ": Godot's box is %s, the triangles' is %s" % [said, box])
	# Of DejaVu Sans, 2048 units to the em: L begins at 201, g descends to -426, an em is a unit.
	check(abs(box.position.x - 201.0 / 2048.0) <= off, name + ": begins at %f" % box.position.x)
	check(abs(box.position.y + 426.0 / 2048.0) <= off, name + ": descends to %f" % box.position.y)
	print(name, ": ", triangles, " triangles, volume ", volume, ", box ", box)
	return volume

func _init():
	var exact = check_mesh("exact", mesh_in("res://text.glb"), false, 0.00001)
	var packed = check_mesh("packed", mesh_in("res://packed.glb"), true, 0.02)
	check(exact == packed, "the packed mesh has another volume")
	print("WRONG in all: ", wrong)
	quit()
