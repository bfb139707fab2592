// Puts the playground together: node assemble.mjs FOLDER HASHES THREE, where HASHES is what cairn_scene_hashes printed and THREE
// the package of three.js. The folder can be served by any server of files.
import { cp, mkdir, readFile, rm } from 'node:fs/promises';
import { join } from 'node:path';

const [folder, hashes, three] = process.argv.slice(2);
const here = import.meta.dirname;
await rm(folder, { recursive: true, force: true });
await mkdir(join(folder, 'scenes'), { recursive: true });
const list = JSON.parse(await readFile(hashes, 'utf8'));
await cp(hashes, join(folder, 'scenes', 'list.json'));
for (const { file } of list) await cp(join(here, '../../scenes', file), join(folder, 'scenes', file));
for (const file of ['index.html', 'style.css', 'main.js', 'badge.js', 'dragging.js', 'sharing.js', 'simulation.js', 'spawning.js', 'stage.js']) {
    await cp(join(here, file), join(folder, file));
}
for (const part of ['src', 'dist']) await cp(join(here, '..', part), join(folder, 'cairn', part), { recursive: true });
await mkdir(join(folder, 'three'));
for (const file of ['build/three.module.js', 'build/three.core.js', 'examples/jsm/controls/OrbitControls.js', 'LICENSE']) {
    await cp(join(three, file), join(folder, 'three', file.split('/').at(-1)));
}
