// SPDX-License-Identifier: MIT
// What letters are made of, and what surrounds them.

import * as THREE from "three";
import { movable } from "./motion.js";

const dark = matchMedia("(prefers-color-scheme: dark)");

/** Their own colours are those that the page begins with. */
export const finishes = {
    satin: { colour: "#f0502d", roughness: 0.34, light: 1 },
    foil: { colour: "#ff4f8b", metalness: 0.8, roughness: 0.17, light: 2.1 },
    gloss: { colour: "#ff3d77", roughness: 0.12, clearcoat: 1, light: 1.15 },
    chrome: { colour: "#ffffff", metalness: 1, roughness: 0.04, light: 1.25 },
    gold: { colour: "#ffb938", metalness: 1, roughness: 0.16, light: 1.3 },
    lacquer: { colour: "#b3121d", roughness: 0.22, clearcoat: 1, clearcoatRoughness: 0.03, light: 0.9 },
    neon: { colour: "#ff2e88", roughness: 0.5, glows: true, light: 0.3 },
};
// sky: top, horizon, below; lamps: direction, half of their width and height, brightness. page: middle and corners of what is behind.
const studioLamps = [[[-0.75, 0.75, 0.5], 0.42, 0.28, 9], [[0.95, 0.25, 0.35], 0.13, 0.6, 7], [[0.1, 0.98, -0.1], 0.6, 0.25, 5], [[-0.2, 0.12, 1], 0.5, 0.05, 1.6]];
export const worlds = {
    light: { sky: ["#f7f4ee", "#ffffff", "#8f877c"], lamps: studioLamps, page: ["#ffffff", "#d9d3c7"], shadow: 0.34, mirror: 0.1, strength: 0.85 },
    dark: { sky: ["#3a404c", "#8d95a5", "#15171c"], lamps: studioLamps, page: ["#343943", "#0d0f12"], shadow: 0.7, mirror: 0.2, strength: 1 },
    dusk: { sky: ["#16245c", "#ffe4d2", "#32142f"], lamps: [[[-0.6, 0.5, 0.75], 0.5, 0.1, 7], [[0.9, 0.2, 0.5], 0.1, 0.7, 5], [[0, 1, 0.2], 0.4, 0.2, 4]],
            page: ["#e0714f", "#1d1440"], shadow: 0.5, mirror: 0.2, strength: 1.15 },
    night: { sky: ["#0a0c1c", "#4a4f86", "#05060c"], lamps: [[[-0.6, 0.7, 0.5], 0.3, 0.08, 3], [[0.95, 0.2, 0.4], 0.05, 0.7, 3]],
             page: ["#171a2e", "#030409"], shadow: 0.6, mirror: 0.3, strength: 0.8 },
};
export const worldOf = name => worlds[name] ?? worlds[dark.matches ? "dark" : "light"];
export const onDark = call => dark.addEventListener("change", call);

const partShades = { front: 0, back: 0, side: -0.3, front_bevel: 0.07, back_bevel: 0.07, letter_front: 0.9, letter_back: 0.9, letter_side: 0.6 };

/** Materials, and how they change: see dress(). */
class Materials {
    constructor() {
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
        this.normals = movable(new THREE.MeshNormalMaterial());
        this.texture = movable(new THREE.MeshStandardMaterial({ map: checker, roughness: 0.6 }));
        this.line = movable(new THREE.LineBasicMaterial({ transparent: true, opacity: 0.75 }));
        this.wires = movable(new THREE.LineBasicMaterial({ name: "wires", color: 0xcfe8ff, transparent: true, opacity: 0.6 }));
        this.seams = new THREE.LineBasicMaterial({ transparent: true, opacity: 0.3 });
        this.bandLine = new THREE.MeshBasicMaterial({ color: 0x28b4ff, toneMapped: false });
        this.casing = new THREE.MeshStandardMaterial({ color: 0xc4cad4, roughness: 0.3, metalness: 0.7 });
        this.drum = new THREE.MeshStandardMaterial({ color: 0x1b1d22, roughness: 0.6, envMapIntensity: 0.6 });
        this.pole = new THREE.MeshStandardMaterial({ color: 0xe2b04a, roughness: 0.25, metalness: 0.9 });
        this.contour = new THREE.LineBasicMaterial({ color: 0x1a6fd0, depthTest: false });
        this.depth = movable(new THREE.MeshDepthMaterial());
        this.solid = {};
        this.dress("satin", "");
    }

    /** Lines are seen before what surrounds them. */
    drawOn(world) {
        this.line.color.set(world === worlds.light ? 0x1d1f23 : 0xeceae5);
        this.seams.color.copy(this.line.color);
    }

    /** Makes all parts of a finish and a colour; its own colour for "". */
    dress(finish, colour) {
        if (this.finish === finish && this.colour === colour) return;
        const kind = finishes[finish], base = new THREE.Color(colour || kind.colour);
        if (this.finish !== finish) for (const name in this.solid) this.solid[name].dispose();
        for (const name in partShades) {
            if (this.finish !== finish || !this.solid[name]) this.solid[name] = this.#made(name, kind);
            const shade = kind.metalness ? 0.3 * Math.min(0, partShades[name]) : partShades[name];
            const own = base.clone().lerp(new THREE.Color(shade > 0 ? "#ffffff" : "#000000"), Math.abs(shade));
            const material = this.solid[name];
            if (kind.glows) material.emissive.copy(base).multiplyScalar(name === "side" ? 1.5 : 2.2), material.color.set(0x08080c);
            else material.color.copy(own);
        }
        Object.assign(this, { finish, colour });
    }
    #made(name, kind) {
        const { roughness, metalness = 0, clearcoat = 0, clearcoatRoughness = 0.06, light } = kind;
        const common = { name, roughness, metalness, envMapIntensity: light, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
        return movable(clearcoat ? new THREE.MeshPhysicalMaterial({ ...common, clearcoat, clearcoatRoughness }) : new THREE.MeshStandardMaterial(common));
    }
    get glows() { return finishes[this.finish].glows === true; }
}
export const materials = new Materials();

const vector = c => new THREE.Vector3(...new THREE.Color(c).toArray());
const shown = c => new THREE.Vector3(...new THREE.Color().setStyle(c, THREE.LinearSRGBColorSpace).toArray());  // not converted

/** A sky with lamps, as a texture that all materials reflect: nothing is downloaded for it. */
export function environment(renderer, world) {
    const [top, horizon, below] = world.sky.map(vector);
    const lamps = world.lamps.map(([way, width, height, light]) => {
        const f = n => n.toFixed(4), to = new THREE.Vector3(...way).normalize(), right = new THREE.Vector3(0, 1, 0.001).cross(to).normalize();
        const v = x => `vec3(${x.toArray().map(f)})`;
        return `c += lamp(d, ${v(to)}, ${v(right)}, vec2(${f(width)}, ${f(height)})) * ${f(light)};`;
    });
    const material = new THREE.ShaderMaterial({
        side: THREE.BackSide, depthWrite: false, uniforms: { top: { value: top }, horizon: { value: horizon }, below: { value: below } },
        vertexShader: "varying vec3 way; void main() { way = position; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
        fragmentShader: `
varying vec3 way;
uniform vec3 top, horizon, below;
float lamp(vec3 d, vec3 to, vec3 right, vec2 size) {
    float front = dot(d, to);
    if (front <= 0.0) return 0.0;
    vec2 p = abs(vec2(dot(d, right), dot(d, cross(to, right)))) / front;
    vec2 soft = smoothstep(size + 0.06, size - 0.06, p);
    return soft.x * soft.y;
}
void main() {
    vec3 d = normalize(way);
    float h = d.y + 0.155;  // the camera looks down so much: faces of letters mirror the horizon
    vec3 sky = mix(horizon, top, pow(smoothstep(0.0, 0.75, h), 0.7)), land = mix(below, horizon, 0.45 * smoothstep(-0.03, -0.5, h));
    vec3 c = mix(land, sky, smoothstep(-0.012, 0.012, h));
    ${lamps.join("\n    ")}
    gl_FragColor = vec4(c, 1.0);
}` });
    const scene = new THREE.Scene(), sphere = new THREE.Mesh(new THREE.SphereGeometry(5, 32, 16), material);
    scene.add(sphere);
    const maker = new THREE.PMREMGenerator(renderer), made = maker.fromScene(scene, 0.015, 0.1, 20, { size: 128 });
    maker.dispose();
    sphere.geometry.dispose();
    material.dispose();
    return made.texture;
}

/** What is behind, and a polished floor of the very same colours: it dims the mirrored letters below it. */
export class Backdrop {
    constructor() {
        this.uniforms = { inner: { value: new THREE.Vector3() }, outer: { value: new THREE.Vector3() }, size: { value: new THREE.Vector2(1, 1) },
                          mirror: { value: 0.2 }, fade: { value: 1 }, middle: { value: new THREE.Vector3() } };
        const shades = `
uniform vec3 inner, outer;
uniform vec2 size;
vec3 backdrop() {
    vec2 p = (gl_FragCoord.xy / size - vec2(0.5, 0.52)) * vec2(1.0, 0.9);
    return mix(inner, outer, smoothstep(0.05, 0.72, length(p)));
}`;
        this.back = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), new THREE.ShaderMaterial({
            uniforms: this.uniforms, depthTest: false, depthWrite: false, toneMapped: false,
            vertexShader: "void main() { gl_Position = vec4(position.xy, 1.0, 1.0); }",
            fragmentShader: shades + "void main() { gl_FragColor = vec4(backdrop(), 1.0); }" }));
        this.back.frustumCulled = false;
        this.back.renderOrder = -1;
        this.floor = new THREE.Mesh(new THREE.CircleGeometry(1, 48).rotateX(-Math.PI / 2), new THREE.ShaderMaterial({
            uniforms: this.uniforms, transparent: true, depthWrite: false, toneMapped: false,
            vertexShader: "varying vec2 place; varying vec3 way; void main() { place = position.xz; vec4 at = modelMatrix * vec4(position, 1.0); way = at.xyz - cameraPosition; gl_Position = projectionMatrix * viewMatrix * at; }",
            fragmentShader: shades + `
varying vec2 place;
varying vec3 way;
uniform float mirror, fade;
uniform vec3 middle;  // of the letters, on the floor
void main() {
    vec3 to = middle - cameraPosition;
    float below = to.y - way.y * dot(to.xz, to.xz) / max(1e-6, dot(way.xz, to.xz));  // how deep what is mirrored here stands
    gl_FragColor = vec4(backdrop(), 1.0 - mirror * smoothstep(0.9, 0.1, length(place)) * (1.0 - smoothstep(0.1, 1.0, below / fade)));
}` }));
        this.floor.renderOrder = 1;
        this.shadow = new THREE.Mesh(new THREE.PlaneGeometry(2, 2).rotateX(-Math.PI / 2), new THREE.ShadowMaterial({ depthWrite: false }));
        this.shadow.material.onBeforeCompile = shader => {  // it fades before the edge of its map
            shader.uniforms.fade = this.uniforms.fade;  // and far behind, where the shadows of a last line's upper ones lie
            shader.vertexShader = "varying vec2 place;\nvarying float behind;\n" + shader.vertexShader.replace("#include <begin_vertex>", "#include <begin_vertex>\nplace = position.xz;\nbehind = -length(modelMatrix[2].xyz) * position.z;");
            shader.fragmentShader = "varying vec2 place;\nvarying float behind;\nuniform float fade;\n" +
                shader.fragmentShader.replace(/\}\s*$/, "gl_FragColor.a *= smoothstep(1.0, 0.6, length(place)) * (1.0 - smoothstep(0.6, 1.3, behind / fade)); }");
        };
        this.shadow.receiveShadow = true;
        this.shadow.renderOrder = 2;
    }
    dress(world) {
        this.uniforms.inner.value.copy(shown(world.page[0]));
        this.uniforms.outer.value.copy(shown(world.page[1]));
        this.uniforms.mirror.value = world.mirror;
        this.shadow.material.opacity = world.shadow;
    }
    place(middle, ground, reach, unit) {
        this.uniforms.middle.value.set(middle.x, ground, middle.z);
        this.uniforms.fade.value = 1.5 * unit;
        for (const [one, size] of [[this.floor, 4 * reach], [this.shadow, 1.5 * reach]]) {
            one.position.set(middle.x, ground, middle.z);
            one.scale.setScalar(size);
        }
    }
    set visible(on) { this.floor.visible = this.shadow.visible = on; }
}
