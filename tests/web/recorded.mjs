// Imports the scenes of the determinism tests that cairn_record_scenes has written to the folder CAIRN_RECORDED_SCENES.
import { readdir } from 'node:fs/promises';
import { join, resolve } from 'node:path';

export async function recordedScenes() {
    const folder = resolve(process.env.CAIRN_RECORDED_SCENES);
    const names = (await readdir(folder)).filter((name) => name.endsWith('.mjs'));
    return Promise.all(names.map(async (name) => [name, await import(join(folder, name))]));
}
