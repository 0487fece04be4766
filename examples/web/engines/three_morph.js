// SPDX-License-Identifier: MIT
// three.js plays a GLB of `text_to_mesh --morph wght=100..900`: its animation goes along the axis and back.

import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const canvas = document.getElementById("canvas"), renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(30, canvas.clientWidth / canvas.clientHeight, 0.1, 200);
scene.background = new THREE.Color(0x12141a);
const sun = new THREE.DirectionalLight(0xffffff, 2.5);
sun.position.set(-2, 3, 4);
scene.add(new THREE.HemisphereLight(0xffffff, 0x404858, 1.6), sun);

const { scene: text, animations } = await new GLTFLoader().loadAsync("text.glb");
scene.add(text);
const box = new THREE.Box3().setFromObject(text), middle = box.getCenter(new THREE.Vector3()), size = box.getSize(new THREE.Vector3());
const distance = 1.3 * Math.max(size.y, size.x / camera.aspect) / (2 * Math.tan(Math.PI / 12));
camera.position.copy(middle).add(new THREE.Vector3(-0.15, 0.18, 1).multiplyScalar(distance));
camera.lookAt(middle);

const mixer = new THREE.AnimationMixer(text);
mixer.clipAction(animations[0]).play();

/** Shows the animation at a time in seconds. */
function show(time) {
    mixer.setTime(time);
    renderer.render(scene, camera);
}
globalThis.played = { THREE, text, renderer, show, duration: animations[0].duration, animation: animations[0] };  // for the console
renderer.setAnimationLoop(time => show(time / 1000 % animations[0].duration));
