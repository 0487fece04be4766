// SPDX-License-Identifier: MIT
// A text in Babylon.js, and one whose weight breathes.

import { ArcRotateCamera } from "@babylonjs/core/Cameras/arcRotateCamera";
import { Engine } from "@babylonjs/core/Engines/engine";
import { DirectionalLight } from "@babylonjs/core/Lights/directionalLight";
import { HemisphericLight } from "@babylonjs/core/Lights/hemisphericLight";
import { StandardMaterial } from "@babylonjs/core/Materials/standardMaterial";
import { Color3, Color4 } from "@babylonjs/core/Maths/math.color";
import { Vector3 } from "@babylonjs/core/Maths/math.vector";
import { VertexBuffer } from "@babylonjs/core/Buffers/buffer";
import { Mesh } from "@babylonjs/core/Meshes/mesh";
import { VertexData } from "@babylonjs/core/Meshes/mesh.vertexData";
import { Scene } from "@babylonjs/core/scene";
import load, { type Mesh as TextMesh } from "typemesh";

/** Babylon's scenes are left-handed: mirrored, triangles turn as Babylon expects. */
const mirrored = (vectors: Float32Array) => {
    for (let i = 2; i < vectors.length; i += 3) vectors[i]! *= -1;
    return vectors;
};
function meshOf(name: string, text: TextMesh, scene: Scene, colour: string, updatable = false): Mesh {
    const data = new VertexData(), { position, normal, uv, index } = text.copy();
    Object.assign(data, { positions: mirrored(position), normals: mirrored(normal), uvs: uv, indices: index });
    const mesh = new Mesh(name, scene), material = new StandardMaterial(name, scene);
    data.applyToMesh(mesh, updatable);
    material.diffuseColor = Color3.FromHexString(colour);
    mesh.material = material;
    return mesh;
}

const [typemesh, bytes] = await Promise.all([load("typemesh.wasm"), fetch("font.ttf").then(answer => answer.arrayBuffer())]);
const font = typemesh.font(bytes), bold = typemesh.font(bytes, { variations: { wght: 750 } });
const engine = new Engine(document.getElementById("canvas") as HTMLCanvasElement, true), scene = new Scene(engine);
scene.clearColor = new Color4(0.07, 0.08, 0.11, 1);
new ArcRotateCamera("camera", -1.75, 1.35, 5, Vector3.Zero(), scene);
new HemisphericLight("sky", new Vector3(0, 1, -0.5), scene).intensity = 0.5;
new DirectionalLight("sun", new Vector3(0.6, -0.8, 1), scene).intensity = 0.8;

const name = meshOf("name", typemesh.mesh("Babylon", bold, { align: "centre", bevel: { width: 0.03, profile: "round" } }), scene, "#ff5d3a");
name.position.y = 0.15;

const morph = typemesh.mesher(font).morph("breathes", "wght", { align: "centre", depth: 0.15 });
const breathing = meshOf("breathing", morph.at(morph.minimum), scene, "#2ec4b6", true);
breathing.position.y = -0.95;

/** A morph may have several stretches along its axis, with vertices of their own in each. */
function breathe(weight: number): void {
    const next = morph.at(weight);
    if (next.index.length !== breathing.getTotalIndices() || next.position.length !== 3 * breathing.getTotalVertices()) {
        const data = new VertexData(), { position, normal, uv, index } = next.copy();
        Object.assign(data, { positions: mirrored(position), normals: mirrored(normal), uvs: uv, indices: index });
        return data.applyToMesh(breathing, true), undefined;
    }
    breathing.updateVerticesData(VertexBuffer.PositionKind, mirrored(next.position.slice()));
    breathing.updateVerticesData(VertexBuffer.NormalKind, mirrored(next.normal.slice()));
}
engine.runRenderLoop(() => {
    breathe(morph.minimum + (morph.maximum - morph.minimum) * (0.5 - 0.5 * Math.cos(performance.now() / 700)));
    scene.render();
    document.documentElement.dataset.triangles = String(name.getTotalIndices() / 3);
    document.documentElement.dataset.breathing = String(breathing.getTotalIndices() / 3);
});
