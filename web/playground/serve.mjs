// Serves a folder to this machine only: node serve.mjs FOLDER [PORT]. The headers allow pages to use threads
// (SharedArrayBuffer).
import { createReadStream } from 'node:fs';
import { realpath, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, sep } from 'node:path';

const TYPES = {
    '.html': 'text/html; charset=utf-8',
    '.js': 'text/javascript',
    '.mjs': 'text/javascript',
    '.css': 'text/css',
    '.json': 'application/json',
    '.gltf': 'model/gltf+json',
    '.wasm': 'application/wasm',
    '.svg': 'image/svg+xml',
    '.png': 'image/png',
};

/** Headers that make a page cross-origin isolated, without which browsers do not allow threads. */
export const ISOLATED = {
    'Cross-Origin-Opener-Policy': 'same-origin',
    'Cross-Origin-Embedder-Policy': 'require-corp',
};

/** Starts a server; its address is `server.address()`. */
export async function serve(folder, port = 0, headers = ISOLATED) {
    const root = await realpath(folder);
    const server = createServer(async (request, response) => {
        const answer = (status, text) => response.writeHead(status, { 'Content-Type': 'text/plain' }).end(`${text}\n`);
        if (request.method !== 'GET' && request.method !== 'HEAD') return answer(405, 'only GET and HEAD');
        try {
            const { pathname } = new URL(request.url, 'http://localhost');
            let file = await realpath(join(root, decodeURIComponent(pathname)));
            if ((await stat(file)).isDirectory()) file = await realpath(join(file, 'index.html'));
            if (!file.startsWith(root + sep)) return answer(404, 'not found');
            response.writeHead(200, {
                'Content-Type': TYPES[extname(file)] ?? 'application/octet-stream',
                'Cache-Control': 'no-cache',
                'Content-Length': (await stat(file)).size,
                ...headers,
            });
            if (request.method === 'HEAD') return response.end();
            createReadStream(file)
                .on('error', () => response.destroy())
                .pipe(response);
        } catch (error) {
            answer(error.code === 'ENOENT' || error.code === 'ENOTDIR' ? 404 : 400, 'not found');
        }
    });
    await new Promise((resolve, reject) => server.once('error', reject).listen(port, '127.0.0.1', resolve));
    return server;
}

if (import.meta.url === new URL(`file://${process.argv[1]}`).href) {
    const [folder, port = '8000'] = process.argv.slice(2);
    const server = await serve(folder, Number(port));
    console.log(`http://127.0.0.1:${server.address().port}/   (Ctrl+C ends)`);
}
