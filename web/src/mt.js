// cairn-physics/mt: the same engine with multithreaded steps. docs/web.md is the manual, mt.d.ts the reference.
import createModule from '../dist/mt/cairn.js';
import { CairnError, refuse } from './error.js';
import { compiled, once } from './load.js';
import { attach, objectOf, unknown } from './memory.js';
import { WorkerPool } from './mt/pool.js';

export * from './names.js';

const ENTRY = 'cairn-physics/mt';
const OPTIONS = ['threads', 'source', 'worker'];
const MAX_THREADS = 256; // per world
const DEFAULT_THREADS = 4; // maximum of the default: scenes of some thousand bodies gain little from more threads
const PAGES = { initial: 512, maximum: 65536 }; // memory pages: as in web/CMakeLists.txt

let asked = 0; // number of threads of the pool

/** Loads the module and starts its workers; every other call needs it. Further calls return the same promise. */
export default function init(options = {}) {
    try {
        const threads = threadsOf(objectOf(options, 'init.options'));
        return once(ENTRY, () => load({ ...options, threads }));
    } catch (error) {
        return Promise.reject(error);
    }
}
export { init };

function threadsOf(options) {
    for (const key of Object.keys(options)) if (!OPTIONS.includes(key)) unknown('InitOptions', key, OPTIONS);
    const { threads } = options;
    if (threads === undefined) return asked || Math.min(navigatorThreads(), DEFAULT_THREADS);
    if (!Number.isInteger(threads) || threads < 1 || threads > MAX_THREADS)
        refuse('InitOptions.threads', threads, `must be a whole number from 1 to ${MAX_THREADS}`);
    if (asked !== 0 && threads !== asked)
        refuse(
            'InitOptions.threads',
            String(threads),
            `must be ${asked}, the number with which ${ENTRY} was initialized`,
            'wrongState',
        );
    return threads;
}

// Before version 21, Node has no `navigator`.
const navigatorThreads = () => globalThis.navigator?.hardwareConcurrency ?? DEFAULT_THREADS;

async function load({ threads, source, worker }) {
    const memory = sharedMemory();
    const module = await compiled(
        await (source ?? new URL('../dist/mt/cairn.wasm', import.meta.url)),
        'InitOptions.source',
    );
    const pool = await WorkerPool.of(worker);
    try {
        const made = new Promise((resolve, reject) => {
            createModule({
                wasmMemory: memory,
                workers: threads - 1,
                Worker: pool.Worker,
                instantiateWasm(imports, done) {
                    WebAssembly.instantiate(module, imports).then((instance) => done(instance, module), reject);
                    return {};
                },
            }).then(resolve, reject);
        });
        const emscripten = await Promise.race([made, pool.failure]);
        await pool.ready();
        attach(emscripten, memory);
        asked = threads;
    } catch (error) {
        pool.dismiss();
        throw error;
    }
}

function sharedMemory() {
    if (typeof SharedArrayBuffer === 'undefined' || globalThis.crossOriginIsolated === false) {
        throw new CairnError(
            'unsupported',
            `${ENTRY}: must have SharedArrayBuffer, got a page that is not cross-origin isolated: its server must ` +
                `send 'Cross-Origin-Opener-Policy: same-origin' and 'Cross-Origin-Embedder-Policy: require-corp'; ` +
                `'cairn-physics', with one thread, needs neither`,
            'crossOriginIsolated',
            'false',
        );
    }
    try {
        return new WebAssembly.Memory({ ...PAGES, shared: true });
    } catch (error) {
        throw new CairnError('outOfMemory', `${ENTRY}: shared memory cannot be allocated: ${error.message}`, 'memory');
    }
}
