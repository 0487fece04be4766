// SPDX-License-Identifier: MIT
// A text as a component of React-three-fiber, and a page that uses it.

import { Canvas, type ThreeElements } from "@react-three/fiber";
import { useEffect, useMemo, useState } from "react";
import { createRoot } from "react-dom/client";
import * as THREE from "three";
import load, { type Mesh, type Mesher, type MeshOptions } from "typemesh";

/** A copy: three.js keeps the arrays. Material 0 is for fronts, 1 for all other parts. */
function geometryOf(mesh: Mesh): THREE.BufferGeometry {
    const geometry = new THREE.BufferGeometry(), { position, normal, uv, index, parts } = mesh.copy();
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normal, 3));
    geometry.setAttribute("uv", new THREE.BufferAttribute(uv, 2));
    geometry.setIndex(new THREE.BufferAttribute(index, 1));
    for (const part of parts) geometry.addGroup(part.start, part.count, part.name === "front" ? 0 : 1);
    return geometry;
}

type TextProps = ThreeElements["mesh"] & { mesher: Mesher; text: string; options: MeshOptions };

/** `options` is to be the same object from one rendering to the next, unless it changes: the text is then made anew. */
export function Text({ mesher, text, options, ...rest }: TextProps) {
    const geometry = useMemo(() => geometryOf(mesher.mesh(text, options)), [mesher, text, options]);
    useEffect(() => {
        document.documentElement.dataset.triangles = String(geometry.index!.count / 3);
        return () => geometry.dispose();
    }, [geometry]);
    return <mesh geometry={geometry} {...rest} />;
}

const bevelled: MeshOptions = { depth: 0.2, align: "centre", anchor: "middle", bevel: { width: 0.03, profile: "round" } };

function App({ mesher }: { mesher: Mesher }) {
    const [text, setText] = useState("React");
    return <>
        <input aria-label="Text" value={text} onChange={event => setText(event.target.value)} />
        <Canvas camera={{ position: [-0.8, 0.6, 3.4], fov: 40 }}>
            <hemisphereLight args={["#ffffff", "#404858", 1.6]} />
            <directionalLight position={[-2, 3, 4]} intensity={2.4} />
            <Text mesher={mesher} text={text} options={bevelled}>
                <meshStandardMaterial attach="material-0" color="#ff5d3a" roughness={0.35} />
                <meshStandardMaterial attach="material-1" color="#ffb199" roughness={0.35} />
            </Text>
        </Canvas>
    </>;
}

const [typemesh, bytes] = await Promise.all([load("typemesh.wasm"), fetch("font.ttf").then(answer => answer.arrayBuffer())]);
createRoot(document.getElementById("root")!).render(<App mesher={typemesh.mesher(typemesh.font(bytes, { variations: { wght: 750 } }))} />);
