// cairn-physics: rigid bodies in WebAssembly. docs/web.md is the manual, index.d.ts the reference.
import createModule from '../dist/cairn.js';
import { compiled, once } from './load.js';
import { attach } from './memory.js';

export * from './names.js';

/** Loads the module; every other call needs it. Further calls return the same promise. */
export default function init(source) {
    return once('cairn-physics', () => load(source));
}
export { init };

async function load(source) {
    const module = await compiled(await (source ?? new URL('../dist/cairn.wasm', import.meta.url)), 'init.source');
    attach(
        await new Promise((resolve, reject) => {
            createModule({
                instantiateWasm(imports, done) {
                    WebAssembly.instantiate(module, imports).then((instance) => done(instance, module), reject);
                    return {};
                },
            }).then(resolve, reject);
        }),
    );
}
