// SPDX-License-Identifier: MIT
// Moves and colours letters in the shaders of any of three.js' materials. Each vertex has its letter's number, pivot and tint.

export const motions = ["still", "wave", "reveal", "scatter", "typewriter", "flag", "score", "breathe"];
export const lessMotion = matchMedia("(prefers-reduced-motion: reduce)");
const period = 4000, scorePeriod = 9000;  // ms

/** Of all materials: the number of the motion, its time from 0 to 1, how many letters there are; where a flag hangs and its width; a score and its wheels;
 * from which x to which triangles are seen, as wires on a colour of their own. */
export const uniforms = {
    motion: { value: 0 }, motionTime: { value: 0 }, motionLetters: { value: 1 }, flagFrom: { value: 0 }, flagWidth: { value: 1 },
    score: { value: 0 }, wheels: { value: 1 }, wires: { value: [1, 0] }, scanned: { value: [0.07, 0.25, 0.6] },
};
export const wheelStep = 0.78, wheelRadius = 1.4, windowHeight = 0.57;  // em; half of the window's height

const declarations = `
attribute float letter;
attribute vec3 pivot;
attribute vec2 digit;
attribute vec4 tint;
varying vec4 letterTint;
varying vec3 letterPlace;  // its x, for the band of wires; the shade of a fold; the height on a wheel
uniform int motion;
uniform float motionTime, motionLetters, flagFrom, flagWidth, score, wheels;
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
// A flag: a wave that runs from its pole on and grows on the way.
float flagPhase(vec3 p) { return 6.2831853 * (1.9 * (p.x - flagFrom) / flagWidth + 0.1 * p.y - motionTime); }
float flagGrowth(vec3 p) { return clamp(0.08 * flagWidth, 0.1, 0.5) * smoothstep(0.0, 0.6, (p.x - flagFrom) / flagWidth); }
vec2 flagSlope(vec3 p) { return flagGrowth(p) * cos(flagPhase(p)) * 6.2831853 * vec2(1.9 / flagWidth, 0.1); }
// A wheel of ten digits. It moves while the one to its right goes from 9 to 0.
float wheelAngle() {
    float gone = score;
    for (float i = wheels - 1.0; i > digit.x; i -= 1.0) {
        float tens = floor(gone / 10.0);
        gone = tens + max(0.0, gone - 10.0 * tens - 9.0);
    }
    float below = mod(digit.y - mod(gone, 10.0) + 20.0, 10.0);
    return 0.62831853 * (below > 5.0 ? below - 10.0 : below);
}
vec3 onWheel(vec3 v, float angle) { return vec3(v.x, v.y * cos(angle) - v.z * sin(angle), v.y * sin(angle) + v.z * cos(angle)); }
vec3 movedLetter(vec3 p) {
    if (motion == 1) return p + vec3(0.0, 0.12 * sin(6.2831853 * (letter / 8.0 - 2.0 * motionTime)), 0.0);
    if (motion == 2) return pivot + (p - pivot) * letterProgress();
    if (motion == 3) {
        vec3 away = vec3(letterNoise(12.99), letterNoise(78.23), letterNoise(37.71)) * (1.0 - letterProgress());
        return pivot + turnedLetter(p - pivot, letterAngle()) + away;
    }
    if (motion == 4) return letter < (motionLetters + 4.0) * motionTime * 1.4 ? p : pivot;
    if (motion == 5) return p + vec3(0.0, 0.0, flagGrowth(p) * sin(flagPhase(p)));
    if (motion == 6) {
        vec3 axle = vec3(${wheelStep.toFixed(2)} * (digit.x - 0.5 * (wheels - 1.0)), 0.0, ${(-wheelRadius).toFixed(1)});
        float angle = wheelAngle();
        return abs(angle) > 1.1 ? axle : axle + onWheel(p - pivot + vec3(0.0, 0.0, ${wheelRadius.toFixed(1)}), angle);
    }
    return p;
}
vec3 movedNormal(vec3 n, vec3 p) {
    if (motion == 3) return turnedLetter(n, letterAngle());
    if (motion == 5) {
        vec2 slope = flagSlope(p);
        return normalize(vec3(n.xy - n.z * slope, n.z + dot(n.xy, slope)));
    }
    return motion == 6 ? onWheel(n, wheelAngle()) : n;
}
`;
const sideShade = "0.55 * ";  // sides are darker than faces, as in looks.js
const tinted = "pow(letterTint.rgb, vec3(2.2))";  // where a geometry has no tints, WebGL gives (0, 0, 0, 1)

/** Lets a material move and colour letters. Geometries without letters stay still, as their motion is 0 then. */
export function movable(material) {
    material.customProgramCacheKey = () => `movable ${material.name === "side" || material.name === "wires" ? material.name : ""}`;  // what differs below
    material.onBeforeCompile = shader => {
        Object.assign(shader.uniforms, uniforms);
        shader.vertexShader = declarations + shader.vertexShader
            .replace("#include <beginnormal_vertex>", "#include <beginnormal_vertex>\nobjectNormal = movedNormal(objectNormal, position);")
            .replace("#include <begin_vertex>", `#include <begin_vertex>\ntransformed = movedLetter(transformed);\nletterTint = tint;
letterPlace = vec3(position.x, motion == 5 ? 1.0 + 0.45 * clamp(flagSlope(position).x, -1.0, 0.3) : 1.0, motion == 6 ? transformed.y : 0.0);`);
        const isHidden = material.name === "wires" ? "!areWires" : "false";
        shader.fragmentShader = "varying vec4 letterTint;\nvarying vec3 letterPlace;\nuniform vec2 wires;\nuniform vec3 scanned;\n" + shader.fragmentShader
            .replace("#include <clipping_planes_fragment>", `#include <clipping_planes_fragment>
bool areWires = letterPlace.x > wires.x && letterPlace.x < wires.y;
if (${isHidden} || abs(letterPlace.z) > ${(windowHeight + 0.2).toFixed(2)}) discard;`)
            .replace("#include <normal_fragment_begin>", material.isMeshStandardMaterial ? `#include <normal_fragment_begin>
vec3 eyeward = normalize(vViewPosition);  // at an outline, normals between vertices may face away, and would be black there
normal = normalize(normal + max(0.0, 0.06 - dot(normal, eyeward)) * eyeward);
nonPerturbedNormal = normal;` : "#include <normal_fragment_begin>")
            .replace("#include <dithering_fragment>", material.isMeshStandardMaterial ? `#include <dithering_fragment>
if (areWires) gl_FragColor = vec4(scanned * (0.55 + 0.45 * normal.z), 1.0);` : "#include <dithering_fragment>")
            .replace("#include <color_fragment>", `#include <color_fragment>\ndiffuseColor.rgb = letterPlace.y * mix(${material.name === "side" ? sideShade : ""}${tinted}, diffuseColor.rgb, letterTint.a);`)
            .replace("#include <emissivemap_fragment>", `#include <emissivemap_fragment>
float glow = max(max(emissive.r, emissive.g), emissive.b);
totalEmissiveRadiance = mix(glow * ${tinted}, totalEmissiveRadiance, letterTint.a);${material.name === "side" ? `
totalEmissiveRadiance += 0.32 * glow * pow(max(0.0, dot(normal, normalize(vViewPosition))), 3.0);` : ""}`);  // tubes are brighter in their middle
    };
    return material;
}

/** What moves letters from frame to frame; nothing for those who want less motion. */
export class Motion {
    /** changed() is called when it begins or ends. */
    constructor(changed) {
        this.changed = changed;
        this.moves = false;
        lessMotion.addEventListener("change", () => this.name && this.set(this.name, this.letters, this.target));
    }
    /** target: what a score comes to. */
    set(name, letters, target = 0) {
        const begins = name !== this.name || target !== this.target;
        Object.assign(this, { name, letters, target });
        this.moves = !["still", "breathe"].includes(name) && letters > 0 && !lessMotion.matches;
        uniforms.motion.value = this.moves || (name === "score" && letters > 0) ? motions.indexOf(name) : 0;
        uniforms.motionLetters.value = Math.max(1, letters);
        uniforms.score.value = this.moves ? uniforms.score.value : target;
        if (begins) this.begun = undefined;
        this.changed();
    }
    step(time) {
        if (!this.moves) return;
        uniforms.motionTime.value = time % period / period;
        this.begun ??= time;
        const now = (time - this.begun) % scorePeriod / scorePeriod;  // it is there, rolls back, and up again
        const back = Math.min(1, Math.max(0, (now - 0.2) / 0.15)), up = Math.min(1, Math.max(0, (now - 0.38) / 0.6));
        const share = now < 0.36 ? 1 - back * back * (3 - 2 * back) : 1 - (1 - up) ** 3;
        uniforms.score.value = Math.round(1000 * this.target * share) / 1000;
    }
}
