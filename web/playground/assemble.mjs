// Assembles the playground: node assemble.mjs FOLDER HASHES THREE. HASHES is the output of cairn_scene_hashes, THREE
// the package three.js; the npm package must have been built. Any static file server can serve the folder.
import { cp, mkdir, readFile, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [folder, hashes, three] = process.argv.slice(2);
const here = fileURLToPath(new URL('.', import.meta.url));
const cairn = join(here, '../../build/web/package');
await rm(folder, { recursive: true, force: true });
await mkdir(join(folder, 'scenes'), { recursive: true });
const list = JSON.parse(await readFile(hashes, 'utf8'));
await cp(hashes, join(folder, 'scenes', 'list.json'));
for (const { file } of list) await cp(join(here, '../../scenes', file), join(folder, 'scenes', file));
for (const file of [
    'index.html',
    'style.css',
    'main.js',
    'badge.js',
    'cameras.js',
    'dragging.js',
    'sharing.js',
    'simulation.js',
    'spawning.js',
    'stage.js',
]) {
    await cp(join(here, file), join(folder, file));
}
for (const part of ['src', 'dist']) await cp(join(cairn, part), join(folder, 'cairn', part), { recursive: true });
await mkdir(join(folder, 'three'));
for (const file of [
    'build/three.module.js',
    'build/three.core.js',
    'examples/jsm/controls/OrbitControls.js',
    'LICENSE',
]) {
    await cp(join(three, file), join(folder, 'three', file.split('/').at(-1)));
}
