// SPDX-License-Identifier: MIT
// Draws a mesh with three.js.

import * as THREE from "three";
import { Motion, movable } from "./motion.js";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

export const views = ["solid", "wireframe", "normals", "texture", "contours"];
const colours = { front: 0xcf5a2e, back: 0xcf5a2e, side: 0x8a4326, front_bevel: 0xe9a27c, back_bevel: 0xe9a27c,
                  letter_front: 0xf5efe6, letter_back: 0xf5efe6, letter_side: 0xc9bfae };
const ink = () => matchMedia("(prefers-color-scheme: dark)").matches ? 0xeceae5 : 0x1d1f23;

function makeMaterials() {
    const board = document.createElement("canvas");
    board.width = board.height = 64;
    const pen = board.getContext("2d");
    for (let i = 0; i < 4; ++i) {
        pen.fillStyle = i % 3 === 0 ? "#f5efe6" : "#3c6e71";
        pen.fillRect(32 * (i & 1), 32 * (i >> 1), 32, 32);
    }
    const checker = new THREE.CanvasTexture(board);
    checker.wrapS = checker.wrapT = THREE.RepeatWrapping;
    checker.repeat.set(4, 4);
    checker.colorSpace = THREE.SRGBColorSpace;
    checker.anisotropy = 8;
    const faint = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    const solid = name => movable(new THREE.MeshStandardMaterial({ name, color: colours[name], roughness: 0.5, ...faint }));
    return {
        solid: Object.fromEntries(Object.keys(colours).map(name => [name, solid(name)])),
        normals: movable(new THREE.MeshNormalMaterial()),
        texture: movable(new THREE.MeshStandardMaterial({ map: checker, roughness: 0.6 })),
        line: movable(new THREE.LineBasicMaterial({ color: ink(), transparent: true, opacity: 0.75 })),
        contour: new THREE.LineBasicMaterial({ color: 0x1a6fd0, depthTest: false }),
    };
}
export const materials = makeMaterials();

export class Stage {
    constructor(canvas) {
        this.canvas = canvas;
        this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
        this.scene = new THREE.Scene();
        this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8d7f70, 1.5));
        for (const [x, y, z, light] of [[-0.7, 1.1, 1.2, 2.2], [1.4, 0.1, 0.5, 0.7]]) {
            const lamp = new THREE.DirectionalLight(0xffffff, light);
            lamp.position.set(x, y, z);
            this.scene.add(lamp);
        }
        this.camera = new THREE.PerspectiveCamera(30, 1, 0.01, 1000);
        this.orbit = new OrbitControls(this.camera, canvas);
        this.orbit.addEventListener("change", () => this.draw());
        this.orbit.addEventListener("start", () => { this.moved = true; });
        this.moved = false;
        this.view = "solid";
        this.group = new THREE.Group();
        this.scene.add(this.group);
        this.motion = new Motion(() => this.drawNow());
        canvas.addEventListener("keydown", event => this.#key(event));
        new ResizeObserver(() => this.#resize()).observe(canvas);
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
            materials.line.color.set(ink());
            this.draw();
        });
        this.#resize();
    }

    /** Shows a mesh of typemesh. Its arrays go to the graphics card from where they are, and are not kept. */
    show(mesh, motion = "still") {
        for (const child of this.group.children) child.geometry.dispose();
        this.group.clear();
        const { low, high } = mesh.bounds;
        this.box = new THREE.Box3(new THREE.Vector3(...low), new THREE.Vector3(...high));
        if (mesh.index.length > 0) {
            const geometry = this.#geometry();
            geometry.setAttribute("position", this.#array(mesh.position, 3));
            geometry.setAttribute("normal", this.#array(mesh.normal, 3));
            geometry.setAttribute("uv", this.#array(mesh.uv, 2));
            geometry.setIndex(this.#array(mesh.index, 1));
            const letters = this.#letters(mesh);
            for (const name in letters) geometry.setAttribute(name, letters[name]);
            for (const part of mesh.parts) geometry.addGroup(part.start, part.count, geometry.groups.length);
            const lone = this.view === "normals" ? materials.normals : this.view === "texture" ? materials.texture : null;
            this.group.add(this.#placed(new THREE.Mesh(geometry, mesh.parts.map(p => lone ?? materials.solid[p.name]))));
            if (this.view === "wireframe") this.#lines(mesh.position, edges(mesh.index), materials.line, letters);
            if (this.view === "contours") this.#lines(mesh.contours(), null, materials.contour);
        }
        this.motion.set(this.view === "contours" ? "still" : motion, mesh.letters.length);
        if (!this.moved) this.fit();
        else this.draw();
    }

    /** The letter and pivot of each vertex, if the mesh knows them. */
    #letters(mesh) {
        const { letter, letters } = mesh;
        if (letter.length === 0) return {};
        const pivots = new Float32Array(3 * letter.length);
        letter.forEach((k, i) => pivots.set(letters[k].pivot, 3 * i));
        return { letter: new THREE.BufferAttribute(Float32Array.from(letter), 1), pivot: new THREE.BufferAttribute(pivots, 3) };
    }

    #lines(points, index, material, letters = {}) {
        const geometry = this.#geometry();
        for (const name in letters) geometry.setAttribute(name, letters[name]);
        geometry.setAttribute("position", this.#array(points, 3));
        if (index) geometry.setIndex(new THREE.BufferAttribute(index, 1));
        this.group.add(this.#placed(new THREE.LineSegments(geometry, material)));
    }
    #geometry() {
        const geometry = new THREE.BufferGeometry();
        geometry.boundingSphere = this.box.getBoundingSphere(new THREE.Sphere());
        return geometry;
    }
    #array(view, size) {
        const attribute = new THREE.BufferAttribute(view, size);
        attribute.onUpload(function () { this.array = null; });  // the module's memory may have moved by the next frame
        return attribute;
    }
    #placed(object) {
        object.frustumCulled = false;
        return object;
    }

    /** Turns to the front and shows all of the mesh. */
    fit() {
        this.moved = false;
        if (!this.box) return;
        const size = this.box.getSize(new THREE.Vector3()), middle = this.box.getCenter(new THREE.Vector3());
        const half = Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
        const distance = Math.max(size.y / half, size.x / (half * this.camera.aspect), 0.1) * 0.62 + size.z;
        this.orbit.target.copy(middle);
        this.camera.position.copy(middle).add(new THREE.Vector3(-0.22, 0.16, 1).normalize().multiplyScalar(distance));
        this.camera.near = distance / 100;
        this.camera.far = distance * 100;
        this.camera.updateProjectionMatrix();
        this.orbit.update();
        this.draw();
    }

    /** Draws before the next frame, once. */
    draw() {
        this.waiting ??= requestAnimationFrame(() => this.drawNow());
    }
    drawNow() {
        if (this.waiting !== undefined) cancelAnimationFrame(this.waiting);
        this.waiting = undefined;
        this.renderer.render(this.scene, this.camera);
    }

    #resize() {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        if (width === 0 || height === 0) return;
        this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        if (this.moved) this.draw();
        else this.fit();
    }

    #key(event) {
        const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
        const zoom = { "+": 0.9, "=": 0.9, "-": 1 / 0.9 }[event.key];
        if (event.key === "Home") this.fit();
        else if (turns) {
            const way = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(this.orbit.target));
            way.theta += 0.12 * turns[0];
            way.phi += 0.12 * turns[1];
            this.#look(way.makeSafe());
        } else if (zoom) {
            const way = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(this.orbit.target));
            way.radius *= zoom;
            this.#look(way);
        } else return;
        event.preventDefault();
    }
    #look(way) {
        this.moved = true;
        this.camera.position.setFromSpherical(way).add(this.orbit.target);
        this.orbit.update();
        this.draw();
    }
}

/** Each triangle's edges; an edge of two triangles once. */
function edges(index) {
    const lines = new Uint32Array(2 * index.length);
    let size = 0;
    for (let t = 0; t < index.length; t += 3)
        for (let k = 0; k < 3; ++k) {
            const from = index[t + k], to = index[t + (k + 1) % 3];
            lines[size++] = from;
            lines[size++] = to;
        }
    return lines;
}
