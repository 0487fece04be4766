// SPDX-License-Identifier: MIT
// A mesh as a file.

import * as THREE from "three";

function save(data, type, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(data instanceof Blob ? data : new Blob([data], { type }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 40000);  // telephones ask first, and fetch it then
}

/** For exporters, which read arrays later than the module may have them. tints: of vertices, four bytes each; the last is the share of the material. */
function lasting(mesh, materials, tints) {
    const { position, normal, uv, index, parts } = mesh.copy();
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normal, 3));
    geometry.setAttribute("uv", new THREE.BufferAttribute(uv, 2));
    geometry.setIndex(new THREE.BufferAttribute(index, 1));
    for (const part of parts) geometry.addGroup(part.start, part.count, geometry.groups.length);
    const solid = parts.map(p => materials.solid[p.name]);
    return new THREE.Mesh(geometry, tints?.length === 4 * position.length / 3 ? tinted(geometry, solid, tints) : solid);
}

/** Gives the vertices their colours, and the same materials in white. */
function tinted(geometry, solid, tints) {
    const colours = new Float32Array(3 * tints.length / 4), { groups, index } = geometry;
    groups.forEach(({ start, count }, k) => {
        const usual = solid[k].color.toArray();
        for (const v of index.array.subarray(start, start + count)) {
            const share = tints[4 * v + 3] / 255;
            usual.forEach((colour, c) => { colours[3 * v + c] = share * colour + (1 - share) * (tints[4 * v + c] / 255) ** 2.2; });
        }
    });
    geometry.setAttribute("color", new THREE.BufferAttribute(colours, 3));
    return solid.map(material => {
        const white = material.clone();
        white.color.set("#ffffff");
        white.vertexColors = true;
        return white;
    });
}

/** The text is the name of the mesh, and in its extras. */
export async function saveGlb(mesh, text, materials, tints) {
    const named = lasting(mesh, materials, tints);  // before anything is awaited: by then there may be another mesh
    named.name = text;
    named.userData = { text };
    const { GLTFExporter } = await import("three/addons/exporters/GLTFExporter.js");
    save(await new GLTFExporter().parseAsync(named, { binary: true }), "model/gltf-binary", "text.glb");
}

/** In millimetres, ten a unit, with its back on z = 0: as printers take it. */
export async function saveStl(mesh, materials) {
    if (mesh.bounds.low[2] === mesh.bounds.high[2]) throw new Error("An STL file contains solids: the depth must be more than 0.");
    const printed = lasting(mesh, materials), geometry = printed.geometry;
    const { STLExporter } = await import("three/addons/exporters/STLExporter.js");
    geometry.scale(10, 10, 10);
    geometry.computeBoundingBox();
    geometry.translate(0, 0, -geometry.boundingBox.min.z);
    save(new STLExporter().parse(printed, { binary: true }), "model/stl", "text.stl");
}

export function savePng(stage) {
    stage.drawPlain();  // a drawn canvas may be read only in the same turn
    stage.canvas.toBlob(blob => save(blob, "image/png", "text.png"));
}
