// SPDX-License-Identifier: MIT
// Moves letters in the vertex shader of any of three.js' materials. Each vertex has its letter's number and pivot.

export const motions = ["still", "wave", "reveal", "scatter", "typewriter"];
export const lessMotion = matchMedia("(prefers-reduced-motion: reduce)");
const period = 4000;  // ms

/** Of all materials: the number of the motion, its time from 0 to 1, and how many letters there are. */
export const uniforms = { motion: { value: 0 }, motionTime: { value: 0 }, motionLetters: { value: 1 } };

const declarations = `
attribute float letter;
attribute vec3 pivot;
uniform int motion;
uniform float motionTime, motionLetters;
float letterNoise(float n) { return 2.0 * fract(sin((letter + 1.0) * n) * 43758.5453) - 1.0; }
// How far a letter's own motion has come: there and back, one letter after another.
float letterProgress() {
    float there = 1.0 - abs(2.0 * motionTime - 1.0);
    return smoothstep(0.0, 1.0, clamp((there * 1.5 - 0.5 * letter / motionLetters) / 0.9, 0.0, 1.0));
}
vec3 turnedLetter(vec3 v, float angle) {
    return vec3(v.x * cos(angle) - v.y * sin(angle), v.x * sin(angle) + v.y * cos(angle), v.z);
}
float letterAngle() { return motion == 3 ? 3.0 * letterNoise(91.7) * (1.0 - letterProgress()) : 0.0; }
vec3 movedLetter(vec3 p) {
    if (motion == 1) return p + vec3(0.0, 0.12 * sin(6.2831853 * (letter / 8.0 - 2.0 * motionTime)), 0.0);
    if (motion == 2) return pivot + (p - pivot) * letterProgress();
    if (motion == 3) {
        vec3 away = vec3(letterNoise(12.99), letterNoise(78.23), letterNoise(37.71)) * (1.0 - letterProgress());
        return pivot + turnedLetter(p - pivot, letterAngle()) + away;
    }
    if (motion == 4) return letter < (motionLetters + 4.0) * motionTime * 1.4 ? p : pivot;
    return p;
}
`;

/** Lets a material move letters. Geometries without letters stay still, as their motion is 0 then. */
export function movable(material) {
    material.onBeforeCompile = shader => {
        Object.assign(shader.uniforms, uniforms);
        shader.vertexShader = declarations + shader.vertexShader
            .replace("#include <beginnormal_vertex>", "#include <beginnormal_vertex>\nobjectNormal = turnedLetter(objectNormal, letterAngle());")
            .replace("#include <begin_vertex>", "#include <begin_vertex>\ntransformed = movedLetter(transformed);");
    };
    return material;
}

/** Calls draw before each frame while letters move; none of them for those who want less motion. */
export class Motion {
    #frame;
    constructor(draw) {
        this.draw = draw;
        lessMotion.addEventListener("change", () => this.set(this.name, this.letters));
    }
    set(name, letters) {
        this.name = name;
        this.letters = letters;
        const moves = name !== "still" && letters > 0 && !lessMotion.matches;
        uniforms.motion.value = moves ? motions.indexOf(name) : 0;
        uniforms.motionLetters.value = Math.max(1, letters);
        if (!moves) cancelAnimationFrame(this.#frame), this.#frame = undefined, this.draw();
        else this.#frame ??= requestAnimationFrame(time => this.#step(time));
    }
    #step(time) {
        uniforms.motionTime.value = time % period / period;
        this.draw();
        this.#frame = requestAnimationFrame(next => this.#step(next));
    }
}
