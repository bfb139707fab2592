// The scenes of the determinism tests, made by calls of the npm package: the same hashes as in native code.
// CAIRN_RECORDED_SCENES is the folder that cairn_record_scenes wrote.
import assert from 'node:assert/strict';
import { readdir } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { test } from 'node:test';
import init, { Geometry, World } from 'cairn-physics';

const folder = resolve(process.env.CAIRN_RECORDED_SCENES);
await init();
const scenes = (await readdir(folder)).filter((name) => name.endsWith('.mjs'));

test('all scenes of the determinism tests are there', () => assert.equal(scenes.length, 16));

for (const file of scenes) {
    const { settings, hashes, run } = await import(join(folder, file));
    test(`${file} has the same state in JavaScript as in native code`, () => {
        const world = new World(settings);
        const handles = new Map();
        const keep = (name, handle) => handles.set(name, handle);
        const at = (name) => {
            assert.ok(handles.has(name), `the scene uses a handle ${name} that no call has given`);
            return handles.get(name);
        };
        let steps = 0,
            compared = 0;
        for (const _ of run(world, { keep, at, Geometry })) {
            ++steps;
            if (hashes[steps] === undefined) continue;
            ++compared;
            assert.equal(world.stateHash.toString(16), hashes[steps].toString(16), `after step ${steps}`);
        }
        assert.equal(compared, Object.keys(hashes).length);
        world.dispose();
    });
}
