// SPDX-License-Identifier: MIT
// A mesh as a file.

import * as THREE from "three";

function save(data, type, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(data instanceof Blob ? data : new Blob([data], { type }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** For exporters, which read arrays later than the module may have them. */
function lasting(mesh, materials) {
    const { position, normal, uv, index, parts } = mesh.copy();
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normal, 3));
    geometry.setAttribute("uv", new THREE.BufferAttribute(uv, 2));
    geometry.setIndex(new THREE.BufferAttribute(index, 1));
    for (const part of parts) geometry.addGroup(part.start, part.count, geometry.groups.length);
    return new THREE.Mesh(geometry, parts.map(p => materials.solid[p.name]));
}

/** The text is the name of the mesh, and in its extras. */
export async function saveGlb(mesh, text, materials) {
    const { GLTFExporter } = await import("three/addons/exporters/GLTFExporter.js");
    const named = lasting(mesh, materials);
    named.name = text;
    named.userData = { text };
    save(await new GLTFExporter().parseAsync(named, { binary: true }), "model/gltf-binary", "text.glb");
}

/** In millimetres, ten a unit, with its back on z = 0: as printers take it. */
export async function saveStl(mesh, materials) {
    if (mesh.bounds.low[2] === mesh.bounds.high[2]) throw new Error("An STL file contains solids: the depth must be more than 0.");
    const { STLExporter } = await import("three/addons/exporters/STLExporter.js");
    const printed = lasting(mesh, materials), geometry = printed.geometry;
    geometry.scale(10, 10, 10);
    geometry.computeBoundingBox();
    geometry.translate(0, 0, -geometry.boundingBox.min.z);
    save(new STLExporter().parse(printed, { binary: true }), "model/stl", "text.stl");
}

export function savePng(stage) {
    stage.drawNow();  // a drawn canvas may be read only in the same turn
    stage.canvas.toBlob(blob => save(blob, "image/png", "text.png"));
}
