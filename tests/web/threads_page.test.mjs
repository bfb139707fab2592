// cairn-physics/mt in pages: the scenes of the determinism tests have the hashes of native code on 1 to 3 threads.
import assert from 'node:assert/strict';
import { cp, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { BROWSERS, inBrowser } from './browser.mjs';
import { recordedScenes } from './recorded.mjs';

const names = (await recordedScenes()).map(([name]) => name);
let folder;

before(async () => {
    folder = await mkdtemp(join(tmpdir(), 'cairn-threads-'));
    const here = (name) => fileURLToPath(new URL(name, import.meta.url));
    await cp(here('node_modules/cairn-physics'), join(folder, 'package'), { recursive: true });
    await cp(process.env.CAIRN_RECORDED_SCENES, join(folder, 'recorded'), { recursive: true });
    await cp(here('replay.mjs'), join(folder, 'replay.mjs'));
    await writeFile(join(folder, 'index.html'), '<!doctype html><link rel="icon" href="data:," />');
});
after(() => rm(folder, { recursive: true, force: true }));

for (const browser of BROWSERS)
    test(
        `all scenes have the states of native code in ${browser.name} on 1, 2 and 3 threads`,
        { skip: browser.skip },
        () =>
            inBrowser(
                folder,
                async (page, address) => {
                    await page.goto(address);
                    const compared = await page.evaluate(async (files) => {
                        const mt = await import('/package/src/mt.js');
                        const { replay } = await import('/replay.mjs');
                        await mt.default({ threads: 3 });
                        let count = 0;
                        for (const file of files) {
                            const scene = await import(`/recorded/${file}`);
                            for (const threads of [1, 2, 3]) {
                                try {
                                    replay(scene, mt, { threads });
                                } catch (error) {
                                    throw new Error(`${file}, ${threads} threads: ${error.message}`);
                                }
                                ++count;
                            }
                        }
                        return count;
                    }, names);
                    assert.equal(compared, 3 * 17);
                },
                { browser },
            ),
    );
