// Loads an animated .glb file with three.js and compares what it shows with a trajectory of the same run.
//
// usage: node check_animation.mjs RUN.glb RUN.csv
//
// For every moment of `cairn run --csv` the animation is set to that time, and each body's node must stand where its
// line says. Bodies are the first roots of the scene, in order (docs/scene_format.md).
import { readFileSync } from "node:fs";
import * as three from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

function fail(message) {
    console.error(`check_animation: ${message}`);
    process.exit(1);
}

function readLines(path) {
    const [head, ...lines] = readFileSync(path, "utf8").trim().split("\n");
    const names = head.split(",");
    return lines.map((line) => Object.fromEntries(line.split(",").map((text, i) => [names[i], text])));
}

async function load(path) {
    globalThis.self ??= globalThis; // the loader expects a browser's global object
    const bytes = readFileSync(path);
    const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
    return new GLTFLoader().parseAsync(buffer, "");
}

const [animated, trajectory] = process.argv.slice(2);
if (!trajectory) fail("usage: check_animation.mjs RUN.glb RUN.csv");
const file = await load(animated);
const lines = readLines(trajectory);
const roots = file.parser.json.scenes[file.parser.json.scene].nodes;
const nodes = await Promise.all(roots.map((index) => file.parser.getDependency("node", index)));

const mixer = new three.AnimationMixer(file.scene);
const actions = file.animations.map((clip) => mixer.clipAction(clip).setLoop(three.LoopOnce, 1));
for (const action of actions) action.clampWhenFinished = true; // keeps the last pose
const position = new three.Vector3(), rotation = new three.Quaternion(), scale = new three.Vector3();
let compared = 0, moved = 0;
for (const line of lines) {
    for (const action of actions) action.reset().play();
    mixer.setTime(Number(line.time));
    file.scene.updateMatrixWorld(true);
    const node = nodes[Number(line.body)];
    if (!node) fail(`body ${line.body}: there is no node`);
    node.matrixWorld.decompose(position, rotation, scale);
    const wanted = new three.Vector3(Number(line.px), Number(line.py), Number(line.pz));
    const turn = new three.Quaternion(Number(line.qx), Number(line.qy), Number(line.qz), Number(line.qw));
    const off = position.distanceTo(wanted), angle = rotation.angleTo(turn);
    if (!(off < 1e-4 * (1 + wanted.length()))) fail(`body ${line.body} at ${line.time} s is ${off} m off`);
    if (!(angle < 2e-3)) fail(`body ${line.body} at ${line.time} s is turned by ${angle} rad`);
    compared += 1;
    moved += position.length() > 0 ? 1 : 0;
}
if (compared === 0 || moved === 0) fail("nothing to compare");
let meshes = 0;
file.scene.traverse((node) => (meshes += node.isMesh ? 1 : 0));
if (meshes === 0) fail("nothing to see");
console.log(`three.js ${three.REVISION}: ${compared} poses agree, ${meshes} meshes`);
