// All scene files that come with Cairn, loaded in JavaScript, have the same states as in native code.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import init, { World } from 'cairn-physics';

await init();
const scenes = new URL('../../scenes/', import.meta.url);
const list = JSON.parse(await readFile(`${process.env.CAIRN_WEB}/scene_hashes.json`, 'utf8'));

test('the list contains all scenes', () => assert.ok(list.length > 30));

for (const { name, file, hashes } of list) {
    test(`${name} has the same state in JavaScript as in native code`, async () => {
        const text = await readFile(new URL(file, scenes), 'utf8');
        const world = World.load(text, file);
        for (const [steps, hash] of Object.entries(hashes)) {
            world.step(world.timeStep, Number(steps) - Number(world.stepCount));
            assert.equal(world.stateHash.toString(16).padStart(16, '0'), hash, `after step ${steps}`);
        }
        const copy = World.load(world.saveScene(), 'saved');
        assert.equal(copy.bodyCount, world.bodyCount);
        copy.dispose();
        world.dispose();
    });
}
