// The scenes of the determinism tests, created by calls of the npm package, have the same hashes as in native code.
import { test } from 'node:test';
import assert from 'node:assert/strict';
import init, { Geometry, World } from 'cairn-physics';
import { recordedScenes } from './recorded.mjs';
import { replay } from './replay.mjs';

await init();
const scenes = await recordedScenes();

test('all scenes of the determinism tests are there', () => assert.equal(scenes.length, 17));

for (const [name, scene] of scenes)
    test(`${name} has the same state in JavaScript as in native code`, () => replay(scene, { World, Geometry }));
