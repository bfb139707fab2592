// The playground in browsers, operated as by a user.
import assert from 'node:assert/strict';
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { BROWSERS, colorsOf, inBrowser, pictureOf } from './browser.mjs';

const folder = join(process.env.CAIRN_WEB, 'playground');
const pictures = join(process.env.CAIRN_WEB, 'pictures');
await mkdir(pictures, { recursive: true });

const stepped = (page, count) =>
    page.waitForFunction(
        (n) => globalThis.playground?.simulation?.world.stepCount >= BigInt(n),
        { timeout: 60000 },
        count,
    );
const textOf = (page, id) => page.$eval(`#${id}`, (element) => element.textContent);

for (const browser of BROWSERS) visits(browser);

function visits(browser) {
    const visit = (name, work) =>
        test(`${browser.name}: ${name}`, { skip: browser.skipDrawing }, () => inBrowser(folder, work, { browser }));
    const picture = (page, name) => pictureOf(page, join(pictures, `${name}_${browser.name.toLowerCase()}.png`));

    visit('the first scene runs, is drawn, and has the hash of native code', async (page, address) => {
        await page.goto(address);
        await stepped(page, 61);
        await page.waitForFunction(() => document.getElementById('badge').dataset.state === 'same', { timeout: 20000 });
        assert.match(await textOf(page, 'badge'), /^After \d+ steps: this browser ([0-9a-f]{16}) = native \1$/);
        const { colors, foreground } = await colorsOf(page, await picture(page, 'welcome'));
        assert.ok(colors > 20 && foreground > 0.2, `${colors} colors, ${foreground} of the pixels in the foreground`);
    });

    visit('the badge reports hashes that differ', async (page, address) => {
        await page.setRequestInterception(true);
        page.on('request', (request) => {
            if (!request.url().endsWith('list.json')) return request.continue();
            return request.respond({
                contentType: 'application/json',
                body: JSON.stringify([
                    { name: 'welcome', file: 'welcome.gltf', title: 'Cairn', hashes: { 60: '0123456789abcdef' } },
                ]),
            });
        });
        await page.goto(address);
        await page.waitForFunction(() => document.getElementById('badge').dataset.state === 'different', {
            timeout: 60000,
        });
        assert.match(await textOf(page, 'badge'), /0123456789abcdef: not the same/);
    });

    visit('a scene can be chosen by the address, paused, stepped and reset', async (page, address) => {
        await page.goto(`${address}#scene=07_pyramid`);
        await stepped(page, 20);
        assert.equal(await page.$eval('#scenes', (select) => select.value), '07_pyramid');
        await page.click('#play');
        const steps = () => page.evaluate(() => Number(globalThis.playground.simulation.world.stepCount));
        const paused = await steps();
        await new Promise((resolve) => setTimeout(resolve, 300));
        assert.equal(await steps(), paused);
        await page.click('#step');
        assert.equal(await steps(), paused + 1);
        await picture(page, 'pyramid');
        await page.click('#reset');
        await stepped(page, 1);
        assert.ok((await steps()) < paused);
    });

    visit('spawned bodies fall, are drawn, and end the comparison of hashes', async (page, address) => {
        await page.goto(`${address}#scene=01_open_plane`);
        await stepped(page, 5);
        for (const kind of ['box', 'sphere', 'capsule', 'cylinder', 'cone', 'hull']) {
            const before = await page.evaluate(() => globalThis.playground.simulation.world.bodyCount);
            await page.select('#kind', kind);
            await page.click('#spawn');
            const { count, drawn, height } = await page.evaluate(() => {
                const { simulation, stage } = globalThis.playground;
                return {
                    count: simulation.world.bodyCount,
                    drawn: stage.view.ids.length,
                    height: simulation.world.positions.at(-2),
                };
            });
            assert.deepEqual([count, drawn], [before + 1, before + 1], kind);
            await page.waitForFunction(
                (was) => globalThis.playground.simulation.world.positions.at(-2) < was - 0.3,
                { timeout: 20000 },
                height,
            );
        }
        await page.waitForFunction(() => document.getElementById('badge').textContent.includes('Changed by hand'), {
            timeout: 20000,
        });
        await picture(page, 'spawned');
    });

    visit('a dragged body follows the mouse, and is released', async (page, address) => {
        await page.goto(`${address}#scene=08_tower`);
        await stepped(page, 10);
        const at = await page.evaluate(() => {
            // the position of the topmost body on the screen
            const {
                simulation: { world },
                stage,
            } = globalThis.playground;
            const top = world.bodies
                .map((id) => world.body(id))
                .filter((body) => body.type === 'dynamic')
                .sort((a, b) => b.position.y - a.position.y)[0];
            const { x, y } = stage.controls.target.clone().copy(top.position).project(stage.eye);
            globalThis.dragged = top;
            return { x: ((x + 1) / 2) * innerWidth, y: ((1 - y) / 2) * innerHeight, from: top.position };
        });
        await page.mouse.move(at.x, at.y);
        await page.mouse.down();
        await page.mouse.move(at.x + 150, at.y + 20, { steps: 10 });
        await page.waitForFunction(
            (from) => {
                const { x, y, z } = globalThis.dragged.position;
                return Math.hypot(x - from.x, y - from.y, z - from.z) > 0.5;
            },
            { timeout: 30000 },
            at.from,
        );
        assert.equal(await page.evaluate(() => globalThis.dragged.joints.length), 1);
        await picture(page, 'dragged');
        await page.mouse.up();
        assert.equal(await page.evaluate(() => globalThis.dragged.joints.length), 0);
    });

    visit('a link to a shared scene opens the same scene', async (page, address) => {
        await page.goto(`${address}#scene=11_newtons_cradle`);
        await stepped(page, 30);
        await page.click('#play');
        await page.click('#share');
        await page.waitForFunction(() => location.hash.startsWith('#gltf='));
        const look = () => page.evaluate(() => Array.from(globalThis.playground.simulation.world.positions));
        const before = await look(),
            link = await page.evaluate(() => location.href);
        await page.goto('about:blank');
        await page.goto(link);
        await stepped(page, 0);
        const [bodies, after] = [
            before.length / 3,
            await page.evaluate(() => globalThis.playground.simulation.world.bodyCount),
        ];
        assert.equal(after, bodies);
        assert.match(await textOf(page, 'badge'), /No native run|^$/);
    });

    visit(
        'a scene file of the user opens; a file that is no scene is refused, and the open scene continues',
        async (page, address) => {
            await page.goto(`${address}#scene=01_open_plane`);
            await stepped(page, 5);
            const input = await page.$('#file');
            await input.uploadFile(join(folder, 'scenes/12_t_handles.gltf'));
            await page.waitForFunction(() => globalThis.playground.simulation.title === 'T-handles', {
                timeout: 20000,
            });
            await stepped(page, 3);
            await input.uploadFile(join(folder, 'style.css'));
            await page.waitForFunction(() => document.getElementById('message').textContent !== '', { timeout: 20000 });
            assert.match(await textOf(page, 'message'), /style\.css/);
            const steps = await page.evaluate(() => Number(globalThis.playground.simulation.world.stepCount));
            await stepped(page, steps + 5);
        },
    );

    for (const [name, fragment] of [
        ['a damaged link', '#gltf=AAAA'],
        ['an unknown scene', '#scene=99_nothing'],
        ['a link without a scene', '#nonsense'],
    ]) {
        visit(`${name} is refused with a message`, async (page, address) => {
            await page.goto(address + fragment);
            await page.waitForFunction(() => document.getElementById('message').textContent !== '', { timeout: 30000 });
            assert.match(await textOf(page, 'message'), /the link|there is no scene/);
        });
    }
}
