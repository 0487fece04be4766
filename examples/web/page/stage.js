// SPDX-License-Identifier: MIT
// Draws a mesh with three.js.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Glow } from "./glow.js";
import { Backdrop, environment, materials, onDark, worldOf } from "./looks.js";
import { lessMotion, Motion, uniforms, wheelRadius, wheelStep, windowHeight } from "./motion.js";

export { materials };
export const views = ["solid", "wireframe", "normals", "texture", "contours"];
const rainbow = [0xff3b5c, 0xff9f1c, 0xffd23f, 0x2ec4b6, 0x3a86ff, 0x8f5bff];
const sway = 0.5, swayPeriod = 13000;  // radians to each side, ms
const entry = 1.1, entryTime = 1600;  // from how far round a mesh comes in
const bandTime = 5000, bandPeriod = 8000, bandWidth = 1.5, maxInBand = 600000;  // ms; letters; indices

export class Stage {
    #frame;
    lift = 0;
    covered = () => ({ top: 0, bottom: 0 });  // how much of the stage lies under something, in CSS pixels

    #drawn = true;  // the arrays of the mesh have gone to the graphics card
    #skies = new Map();
    #breathing;  // the triangles of a text that breathes

    constructor(canvas) {
        this.canvas = canvas;
        this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
        this.renderer.autoClear = false;
        this.renderer.toneMapping = THREE.NeutralToneMapping;
        this.renderer.shadowMap.enabled = true;
        this.renderer.shadowMap.type = THREE.VSMShadowMap;
        this.renderer.shadowMap.autoUpdate = false;
        this.scene = new THREE.Scene();
        this.lamp = new THREE.DirectionalLight(0xffffff, 1.6);
        this.lamp.castShadow = true;
        this.lamp.shadow.mapSize.set(1024, 1024);
        this.lamp.shadow.radius = 7;
        this.lamp.shadow.blurSamples = 12;
        this.backdrop = new Backdrop();
        this.group = new THREE.Group();
        this.mirror = new THREE.Group();  // the same below the floor
        this.mirror.scale.y = -1;
        this.scene.add(this.lamp, this.lamp.target, this.group, this.mirror, this.backdrop.back, this.backdrop.floor, this.backdrop.shadow);
        this.camera = new THREE.PerspectiveCamera(30, 1, 0.01, 1000);
        this.orbit = new OrbitControls(this.camera, canvas);
        this.orbit.addEventListener("change", () => this.draw());
        this.orbit.addEventListener("start", () => this.#touch());
        this.moved = false;
        this.turning = !lessMotion.matches;
        this.view = "solid";
        this.look = { finish: "satin", colour: "", world: "auto" };
        this.motion = new Motion(() => this.#wake());
        canvas.addEventListener("keydown", event => this.#key(event));
        canvas.addEventListener("pointermove", event => {  // what letters mirror goes with a mouse that passes
            if (event.pointerType !== "mouse" || event.buttons || lessMotion.matches) return;
            this.scene.environmentRotation.y = 0.9 * (event.offsetX / canvas.clientWidth - 0.5);
            this.draw();
        });
        new ResizeObserver(() => this.#resize()).observe(canvas);
        canvas.addEventListener("webglcontextrestored", () => {  // all that the graphics card had is to be made anew
            this.#skies.clear();
            this.onrestored?.();
        });
        onDark(() => this.dress(this.look));
        lessMotion.addEventListener("change", () => this.turn(!lessMotion.matches));
        this.#resize();
    }

    /** Takes a finish, a colour and surroundings. */
    dress(look) {
        this.look = look;
        materials.dress(look.finish, look.colour);
        const world = worldOf(look.world);
        if (!this.#skies.has(world)) this.#skies.set(world, environment(this.renderer, world));
        this.scene.environment = this.#skies.get(world);
        this.scene.environmentIntensity = world.strength;
        this.backdrop.dress(world);
        materials.drawOn(world);
        if (materials.glows) this.glow ??= new Glow(this.renderer);
        this.draw();
    }

    /** Shows a mesh of typemesh. Its arrays go to the graphics card from where they are, and are not kept. */
    show(mesh, { motion = "still", target = 0, rainbow: isColourful = false, breathes = false } = {}) {
        const rings = this.view === "contours" ? mesh.contours() : undefined;  // first, as the module's memory may grow, which ends views
        this.group.traverse(child => child.geometry?.dispose());
        this.group.clear();
        this.mirror.clear();
        const { low, high } = mesh.bounds;
        this.box = new THREE.Box3(new THREE.Vector3(...low), new THREE.Vector3(...high));
        const wheels = motion === "score" ? new Set(mesh.letters.map(l => l.word)).size : 0;
        Object.entries({ flagFrom: low[0], flagWidth: Math.max(0.1, high[0] - low[0]), wheels }).forEach(([name, v]) => { uniforms[name].value = v; });
        let bands;
        this.wires = undefined;
        // About a letter's size, however many lines or columns there are.
        this.unit = Math.max(0.15 * (high[1] - low[1]), Math.sqrt((high[0] - low[0]) * (high[1] - low[1]) / Math.max(1, mesh.statistics.glyphs))) || 1;
        this.#breathing = breathes ? mesh.index.slice() : undefined;
        if (mesh.index.length > 0) {
            const geometry = this.#geometry();
            this.#fill(geometry, mesh);
            const letters = this.#letters(mesh, isColourful);
            for (const name in letters) geometry.setAttribute(name, letters[name]);
            for (const part of mesh.parts) geometry.addGroup(part.start, part.count, geometry.groups.length);
            const lone = this.view === "normals" ? materials.normals : this.view === "texture" ? materials.texture : null;
            const solid = mesh.parts.map(p => lone ?? materials.solid[p.name]);
            this.group.add(this.#placed(new THREE.Mesh(geometry, solid)));
            if (this.#hasFloor) this.mirror.add(this.#placed(new THREE.Mesh(geometry, solid)));
            this.group.children[0].castShadow = this.#hasFloor && !materials.glows;
            this.group.children[0].customDepthMaterial = materials.depth;
            if (this.view === "wireframe") this.#lines(geometry.attributes.position, edges(mesh.index), materials.line, letters);
            else if (this.view === "solid" && breathes) this.#lines(geometry.attributes.position, wallEdges(mesh), materials.seams);
            else if (this.view === "solid" && motion === "still" && this.turning && !this.moved && !lessMotion.matches && !materials.glows &&
                     mesh.index.length <= maxInBand && high[0] - low[0] > 2.5 * (high[1] - low[1]) && high[2] - low[2] < 0.7 * this.unit)  // a line of text, not bent
                bands = geometry.attributes.position;
            if (rings) this.#lines(this.#array(rings, 3), null, materials.contour);
            if (this.#hasFloor && motion === "flag") this.#pole();
            if (this.view !== "contours" && wheels > 0) this.#casing(wheels);
        }
        this.#light();
        if (bands) this.#band(bands, edges(mesh.index));
        this.#sweep(-1);
        this.#drawn = false;
        this.motion.set(this.view === "contours" ? "still" : motion, mesh.letters.length, target);
        if (!this.moved) this.fit(true);
        else this.draw();
    }

    /** The next mesh of a text that breathes: in the place of the last one, if it has the same triangles. */
    move(mesh) {
        const geometry = this.group.children[0]?.geometry;
        if (!geometry || geometry.attributes.position.count !== mesh.statistics.vertices || !isSame(this.#breathing, mesh.index))
            return this.show(mesh, { breathes: true });
        for (const [name, view] of [["position", mesh.position], ["normal", mesh.normal]])
            Object.assign(geometry.attributes[name], { array: view, needsUpdate: true });
        this.renderer.shadowMap.needsUpdate = true;
        return this.draw();
    }

    /** The colours of vertices that letters have of their own: see motion.js. */
    get tints() { return this.group.children[0]?.geometry.attributes.tint?.array; }

    get #hasFloor() { return this.view === "solid" || this.view === "wireframe"; }

    /** Floor, mirror and shadow fit the mesh. */
    #light() {
        const size = this.box.getSize(new THREE.Vector3()), middle = this.box.getCenter(new THREE.Vector3());
        const ground = this.box.min.y - 0.03 * Math.min(1, size.y), reach = 0.5 * Math.hypot(size.x, size.y, size.z) + 0.2;
        this.ground = ground;
        this.mirror.position.y = 2 * ground;
        this.backdrop.place(middle, ground, reach, this.unit);
        this.lamp.target.position.copy(middle);
        this.lamp.position.copy(middle).add(new THREE.Vector3(-0.45, 1.15, 0.8).multiplyScalar(2 * reach));
        const eye = this.lamp.shadow.camera;
        Object.assign(eye, { left: -1.6 * reach, right: 1.6 * reach, top: 1.6 * reach, bottom: -1.6 * reach, near: 0.1 * reach, far: 6 * reach });
        eye.updateProjectionMatrix();
        this.renderer.shadowMap.needsUpdate = true;
    }

    #fill(geometry, mesh) {
        for (const [name, size] of [["position", 3], ["normal", 3], ["uv", 2]]) geometry.setAttribute(name, this.#array(mesh[name], size));
        geometry.setIndex(this.#array(mesh.index, 1));
    }

    /** The letter, pivot, digit and tint of each vertex, if the mesh knows them. */
    #letters(mesh, isColourful) {
        const { letter, letters, tint } = mesh, made = {};
        if (tint.length > 0) made.tint = new THREE.BufferAttribute(tint.slice(), 4, true);
        if (letter.length === 0) return made;
        const pivots = new Float32Array(3 * letter.length), digits = new Float32Array(2 * letter.length), begun = new Map();
        const places = letters.map(({ word }, i) => {
            if (!begun.has(word)) begun.set(word, i);
            return [word, i - begun.get(word)];
        });
        letter.forEach((k, i) => { pivots.set(letters[k].pivot, 3 * i), digits.set(places[k], 2 * i); });
        if (isColourful && !made.tint) made.tint = new THREE.BufferAttribute(rainbowOf(letter), 4, true);
        made.letter = new THREE.BufferAttribute(Float32Array.from(letter), 1);
        made.pivot = new THREE.BufferAttribute(pivots, 3);
        made.digit = new THREE.BufferAttribute(digits, 2);
        return made;
    }

    #lines(points, index, material, letters = {}) {
        const geometry = this.#geometry();
        for (const name in letters) geometry.setAttribute(name, letters[name]);
        geometry.setAttribute("position", points);
        if (index) geometry.setIndex(new THREE.BufferAttribute(index, 1));
        const lines = this.#placed(new THREE.LineSegments(geometry, material));
        this.group.add(lines);
        return lines;
    }
    /** What is not of the text, and is not saved: it stands with it, and is mirrored. */
    #prop(geometry, material, place) {
        if (!this.#hasFloor) return;
        for (const group of [this.group, this.mirror]) {
            const one = this.#placed(new THREE.Mesh(geometry, material));
            one.position.set(...place);
            one.castShadow = group === this.group;
            group.add(one);
        }
    }
    /** Of a flag; the ground is at its foot. */
    #pole() {
        const { min, max } = this.box, height = max.y - min.y, width = max.x - min.x, radius = Math.min(0.07, 0.04 * height);
        const foot = min.y - 0.45 * height, top = max.y + 0.12 * height, x = min.x - 0.6 * radius;
        this.#prop(new THREE.CylinderGeometry(radius, radius, top - foot, 24), materials.pole, [x, (foot + top) / 2, 0]);
        this.#prop(new THREE.SphereGeometry(1.9 * radius, 24, 16), materials.pole, [x, top, 0]);
        this.box.min.set(x - radius, foot, -0.08 * width);
        this.box.max.set(max.x, top + 2 * radius, 0.08 * width);
    }
    /** Of wheels: a drum that carries the digits, behind a window that shows one row of them. */
    #casing(wheels) {
        const width = wheelStep * wheels + 0.12, high = windowHeight + 0.24, rim = 0.2, [back, front] = [-0.55, 0.14], middle = (back + front) / 2;
        for (let i = 0; i < wheels; ++i) {
            const drum = new THREE.CylinderGeometry(wheelRadius - 0.04, wheelRadius - 0.04, 0.96 * wheelStep, 48, 1, true, -0.58, 1.16).rotateZ(Math.PI / 2);
            this.#prop(drum, materials.drum, [wheelStep * (i - 0.5 * (wheels - 1)), 0, -wheelRadius]);
        }
        const box = (x, y, z, place) => this.#prop(new THREE.BoxGeometry(x, y, z), materials.casing, place);
        for (const side of [-1, 1]) {
            box(width + 2 * rim, high - windowHeight, front - back, [0, side * (high + windowHeight) / 2, middle]);
            box(rim, 2 * windowHeight, front - back, [side * (width + rim) / 2, 0, middle]);
        }
        box(width, 2 * high, 0.05, [0, 0, back]);
        this.box.set(new THREE.Vector3(-width / 2 - rim, -high, back), new THREE.Vector3(width / 2 + rim, high, front));
    }
    /** A band between two bright lines, in which the triangles are seen: also in the mirror. */
    #band(points, index) {
        const { min, max } = this.box, high = max.y - min.y + 0.3 * this.unit, wide = 0.022 * this.unit;
        this.wires = this.#lines(points, index, materials.wires);
        this.edges = [0, 1].map(() => this.#placed(new THREE.Mesh(new THREE.BoxGeometry(wide, high, wide), materials.bandLine)));
        for (const edge of this.edges) edge.position.set(0, this.ground + high / 2, max.z + 0.1 * this.unit);
        this.group.add(...this.edges);
        this.mirrored = [this.wires, ...this.edges].map(one => one.clone());
        this.mirror.add(...this.mirrored);
    }
    /** The band passes over a mesh that turns, now and then; since: ms. */
    #sweep(since) {
        const wires = uniforms.wires.value, { min, max } = this.box ?? {};
        wires[0] = 1, wires[1] = 0;
        const at = since % bandPeriod / bandTime, seen = since >= 0 && at < 1;
        if (this.wires) {
            for (const one of [this.wires, ...this.edges, ...this.mirrored]) one.visible = seen;
            if (seen) {
                const width = bandWidth * this.unit, place = min.x - width + (max.x - min.x + width) * at;
                wires[0] = place, wires[1] = place + width;
                for (const [i, x] of wires.entries()) this.edges[i].position.x = this.mirrored[i + 1].position.x = x;
            }
        }
        this.onscan?.(this.wires && seen ? this.#seenAt((wires[0] + wires[1]) / 2) : undefined);
    }
    get above() { return this.box && this.#seenAt((this.box.min.x + this.box.max.x) / 2); }
    /** Where a place above the text is seen, in CSS pixels. */
    #seenAt(x) {
        this.camera.updateMatrixWorld();
        const { max } = this.box, place = new THREE.Vector3(x, max.y + 0.35 * this.unit, max.z).project(this.camera);
        return { x: (0.5 + 0.5 * place.x) * this.canvas.clientWidth, y: (0.5 - 0.5 * place.y) * this.canvas.clientHeight };
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
    fit(keepsTurn = false) {
        this.moved = false;
        if (!this.box) return;
        const size = this.box.getSize(new THREE.Vector3()), middle = this.box.getCenter(new THREE.Vector3());
        const half = Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
        const { clientHeight: height } = this.canvas, { top, bottom } = this.covered(), free = Math.max(0.3, 1 - (top + bottom) / height);
        const forHeight = size.y / (half * Math.min(0.8, free)), forWidth = size.x / (half * this.camera.aspect);
        const distance = Math.max(forHeight, forWidth, 0.1) * 0.62 + size.z, tall = THREE.MathUtils.smoothstep(forHeight / Math.max(forWidth, 1e-9), 0.75, 1);
        if (this.#hasFloor) middle.y -= (0.08 - 0.06 * tall) * size.y;
        this.lift = tall * (bottom - top) / 2 / height;  // what is tall stands between what lies over the stage
        this.#aim();
        this.orbit.target.copy(middle);
        const way = new THREE.Vector3(-0.22, 0.16, 1).normalize().multiplyScalar(distance);
        if (keepsTurn) way.applyAxisAngle(new THREE.Vector3(0, 1, 0), this.turned ?? 0);
        else this.turned = 0, this.begun = undefined;
        this.camera.position.copy(middle).add(way);
        Object.assign(this.orbit, { minDistance: distance / 20, maxDistance: 6 * distance });
        this.camera.near = distance / 100;
        this.camera.far = distance * 100;
        this.camera.updateProjectionMatrix();
        this.orbit.update();
        this.draw();
    }

    /** Lets the mesh turn slowly from side to side, until it is touched. */
    turn(on) {
        this.turning = on;
        this.begun = undefined;
        this.turned = 0;
        this.ontouch?.();
        if (on) this.fit();
        else this.#sweep(-1);
        this.#wake();
    }
    #touch() {
        this.moved = true;
        if (this.turning) this.turn(false);
    }

    /** Draws before the next frame, once. */
    draw() {
        this.#frame ??= requestAnimationFrame(time => this.#step(time));
    }
    #wake() { this.draw(); }
    #step(time) {
        this.#frame = undefined;
        this.motion.step(time);
        if (this.motion.moves) this.renderer.shadowMap.needsUpdate = this.#hasFloor;
        const turns = this.turning && !this.moved && this.box;
        if (turns) {
            this.begun ??= time;
            const since = time - this.begun, coming = entry * Math.max(0, 1 - since / entryTime) ** 3;
            const angle = sway * Math.sin(2 * Math.PI * since / swayPeriod) - coming, by = angle - (this.turned ?? 0);
            this.camera.position.sub(this.orbit.target).applyAxisAngle(new THREE.Vector3(0, 1, 0), by).add(this.orbit.target);
            this.turned = angle;
            this.orbit.update();
            this.#sweep(since);
        } else this.#sweep(-1);
        const breathes = this.breath?.(time);
        this.drawNow();
        if (turns || this.motion.moves || breathes) this.draw();
    }
    /** Before the module's memory may grow, which ends the arrays of a mesh: it is drawn if it has not been, as in a hidden tab. */
    settle() {
        if (this.#drawn) return;
        this.drawNow();
        this.draw();  // a frame that was waiting, for a mesh that turns, is gone with the last line
    }
    /** For a picture to keep: without the band of triangles, which then goes on. */
    drawPlain() {
        this.#sweep(-1);
        this.drawNow();
        this.draw();
    }
    drawNow() {
        this.#drawn = true;
        if (this.#frame !== undefined) cancelAnimationFrame(this.#frame), this.#frame = undefined;
        const { renderer, scene, camera, backdrop } = this;
        const floor = this.#hasFloor && this.group.children.length > 0 && camera.position.y > this.ground;
        backdrop.visible = floor;
        this.mirror.visible = floor;
        renderer.getDrawingBufferSize(backdrop.uniforms.size.value);
        renderer.clear();
        renderer.render(scene, camera);
        if (!materials.glows || !this.#hasFloor || !this.glow) return;
        backdrop.visible = backdrop.back.visible = this.mirror.visible = false;
        const tops = scene.environmentIntensity;
        scene.environmentIntensity = 0;
        this.lamp.visible = false;
        this.glow.draw(scene, camera);
        this.lamp.visible = backdrop.back.visible = true;
        scene.environmentIntensity = tops;
    }

    #resize() {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        if (width === 0 || height === 0) return;
        this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.#aim();
        if (!this.moved) this.fit(true);
        if (!this.box) return;
        this.drawNow();  // else nothing is seen until the next frame
        this.draw();
    }

    /** Moves the picture up or down by a share of the stage. */
    #aim() {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        this.camera.setViewOffset(width, height, 0, this.lift * height, width, height);
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
        this.#touch();
        this.camera.position.setFromSpherical(way).add(this.orbit.target);
        this.orbit.update();
        this.draw();
    }
}

/** A colour for each letter: the tints of vertices that belong to these letters. */
export function rainbowOf(letter) {
    const tints = new Uint8Array(4 * letter.length), of = k => rainbow[k % rainbow.length];
    letter.forEach((k, i) => tints.set([of(k) >> 16, of(k) >> 8 & 255, of(k) & 255, 0], 4 * i));
    return tints;
}

const isSame = (some, others) => some?.length === others.length && some.every((v, i) => v === others[i]);

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
/** The edges of a prism's walls, without the diagonals of their faces. */
function wallEdges(mesh) {
    const { position: p, index } = mesh, lines = [], is = (a, b, k) => p[3 * a + k] === p[3 * b + k];
    for (const { name, start, count } of mesh.parts)
        for (let t = start; name === "side" && t < start + count; t += 3)
            for (let k = 0; k < 3; ++k) {
                const from = index[t + k], to = index[t + (k + 1) % 3];
                if (is(from, to, 2) || (is(from, to, 0) && is(from, to, 1))) lines.push(from, to);
            }
    return Uint32Array.from(lines);
}
