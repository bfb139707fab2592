// Opens pages in headless browsers that render in software.
import { existsSync } from 'node:fs';
import { writeFile } from 'node:fs/promises';
import puppeteer from 'puppeteer-core';
import { serve } from '../../web/playground/serve.mjs';

/**
 * Chromium and Firefox. `skip`: false, or the reason for which tests in this browser are skipped; `skipDrawing`: the
 * same for tests that draw with WebGL.
 */
export const BROWSERS = [
    {
        name: 'Chromium',
        path: process.env.CAIRN_CHROMIUM ?? '/usr/bin/chromium',
        variable: 'CAIRN_CHROMIUM',
        options: { args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] },
    },
    {
        name: 'Firefox',
        path: process.env.CAIRN_FIREFOX ?? '/usr/bin/firefox-esr',
        variable: 'CAIRN_FIREFOX',
        options: {
            browser: 'firefox',
            extraPrefsFirefox: { 'webgl.force-enabled': true, 'gfx.x11-egl.force-enabled': true },
        },
        drawsWithDisplay: true,
    },
].map((browser) => {
    const { name, path, variable, drawsWithDisplay } = browser;
    const skip = existsSync(path) ? false : `${name} is not installed: no ${path} (or set ${variable} to its path)`;
    const noDisplay =
        drawsWithDisplay && !process.env.DISPLAY
            ? `${name} has no WebGL without a display, which xvfb-run provides`
            : false;
    return { ...browser, skip, skipDrawing: skip || noDisplay };
});
export const CHROMIUM = BROWSERS[0];

/**
 * Runs `visit(page, address)`. `site`: a folder to be served, or the address (http://...) of a running server. Throws
 * if the page reports an error. `headers`: response headers, instead of those that `serve` sends for threads.
 */
export async function inBrowser(site, visit, { browser: { path, options } = CHROMIUM, headers } = {}) {
    const server = site.startsWith('http://') ? null : await serve(site, 0, headers);
    const browser = await puppeteer.launch({ executablePath: path, headless: true, ...options });
    const problems = [];
    try {
        const page = await browser.newPage();
        await page.setViewport({ width: 960, height: 600 });
        page.on('pageerror', (error) => problems.push(`error in the page: ${error.message}`));
        page.on('requestfailed', (request) => problems.push(`${request.url()}: ${request.failure()?.errorText}`));
        page.on('console', (message) => message.type() === 'error' && problems.push(`console: ${message.text()}`));
        const result = await visit(page, server ? `http://127.0.0.1:${server.address().port}/` : site);
        if (problems.length > 0) throw new Error(problems.join('\n'));
        return result;
    } catch (error) {
        throw problems.length > 0 ? new Error([error.message, ...problems].join('\n')) : error;
    } finally {
        await browser.close();
        server?.close();
        server?.closeAllConnections?.();
    }
}

/** A screenshot of the page, in base64. It is also written to `file`, for inspection. */
export async function pictureOf(page, file) {
    const base64 = await page.screenshot({ encoding: 'base64' });
    await writeFile(file, Buffer.from(base64, 'base64'));
    return base64;
}

/**
 * The number of different colors of a picture (the upper four bits of each channel), and the fraction of its pixels
 * that do not have the most frequent color.
 */
export async function colorsOf(page, base64) {
    return page.evaluate(async (data) => {
        const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
        const canvas = new OffscreenCanvas(image.width, image.height);
        const context = canvas.getContext('2d');
        context.drawImage(image, 0, 0);
        const { data: bytes } = context.getImageData(0, 0, image.width, image.height);
        const counts = new Map();
        for (let i = 0; i < bytes.length; i += 4) {
            const color = ((bytes[i] >> 4) << 8) | ((bytes[i + 1] >> 4) << 4) | (bytes[i + 2] >> 4);
            counts.set(color, (counts.get(color) ?? 0) + 1);
        }
        const most = Math.max(...counts.values());
        return { colors: counts.size, foreground: 1 - most / (bytes.length / 4) };
    }, base64);
}
