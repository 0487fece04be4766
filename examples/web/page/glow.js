// SPDX-License-Identifier: MIT
// Light that spreads around what glows: the letters alone, drawn small, blurred, and added to the picture.

import * as THREE from "three";

const vertexShader = "varying vec2 at; void main() { at = 0.5 * position.xy + 0.5; gl_Position = vec4(position.xy, 0.0, 1.0); }";
const blur = `
varying vec2 at;
uniform sampler2D from;
uniform vec2 step;
void main() {
    vec4 c = 0.204 * texture2D(from, at);
    for (int i = 1; i < 4; ++i) {
        float k = float(i), w = i == 1 ? 0.18 : i == 2 ? 0.124 : 0.094;
        c += w * (texture2D(from, at + step * k * 1.4) + texture2D(from, at - step * k * 1.4));
    }
    gl_FragColor = c;
}`;
const add = `
varying vec2 at;
uniform sampler2D from, wide;
void main() {
    vec3 c = 0.2 * texture2D(from, at).rgb + 0.26 * texture2D(wide, at).rgb;
    gl_FragColor = vec4(pow(1.0 - exp(-c), vec3(1.0 / 1.8)), 1.0);
}`;

export class Glow {
    #quad = new THREE.Mesh(new THREE.PlaneGeometry(2, 2));
    #eye = new THREE.Camera();
    #sizes = [3, 9].map(part => ({ part, one: target(), two: target() }));
    #blur = new THREE.ShaderMaterial({ vertexShader, fragmentShader: blur, depthTest: false, uniforms: { from: { value: null }, step: { value: new THREE.Vector2() } } });
    #add = new THREE.ShaderMaterial({ vertexShader, fragmentShader: add, depthTest: false, depthWrite: false, transparent: true, blending: THREE.AdditiveBlending,
                                      toneMapped: false, uniforms: { from: { value: null }, wide: { value: null } } });
    #black = new THREE.Color(0);

    constructor(renderer) {
        this.renderer = renderer;
        this.#quad.frustumCulled = false;
    }

    /** Adds the glow of the scene; only what glows is to be visible now. */
    draw(scene, camera) {
        const { renderer } = this, size = renderer.getDrawingBufferSize(new THREE.Vector2()), [fine, wide] = this.#sizes;
        for (const s of this.#sizes)
            for (const t of [s.one, s.two]) t.setSize(Math.max(1, size.x / s.part | 0), Math.max(1, size.y / s.part | 0));
        const tones = renderer.toneMapping;
        renderer.toneMapping = THREE.NoToneMapping;
        renderer.setRenderTarget(fine.one);
        renderer.setClearColor(this.#black, 1);
        renderer.clear();
        renderer.render(scene, camera);
        for (let i = 0; i < 2; ++i) this.#pass(fine.one, fine.two, 1, 0), this.#pass(fine.two, fine.one, 0, 1);
        this.#pass(fine.one, wide.one, 1, 1);
        for (let i = 0; i < 2; ++i) this.#pass(wide.one, wide.two, 1, 0), this.#pass(wide.two, wide.one, 0, 1);
        renderer.setRenderTarget(null);
        renderer.setClearColor(this.#black, 0);
        this.#add.uniforms.from.value = fine.one.texture;
        this.#add.uniforms.wide.value = wide.one.texture;
        this.#quad.material = this.#add;
        renderer.render(this.#quad, this.#eye);
        renderer.toneMapping = tones;
    }
    #pass(from, to, x, y) {
        this.#blur.uniforms.from.value = from.texture;
        this.#blur.uniforms.step.value.set(x / from.width, y / from.height);
        this.#quad.material = this.#blur;
        this.renderer.setRenderTarget(to);
        this.renderer.render(this.#quad, this.#eye);
    }
}
const target = () => new THREE.WebGLRenderTarget(1, 1, { type: THREE.HalfFloatType });
