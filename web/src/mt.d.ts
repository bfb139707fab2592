export * from './index.js';

export interface InitOptions {
    /**
     * How many threads there are: the one that calls, and workers, of which a world takes `world.threads - 1` until it is disposed
     * of or takes fewer. 1 to 256; default: as the machine has, but at most 4.
     */
    threads?: number;
    /** Where the file `cairn.wasm` of this entry is (`cairn-physics/mt/cairn.wasm`), or what is in it; default: beside this module. */
    source?: string | URL | Response | Promise<Response> | ArrayBuffer | ArrayBufferView | WebAssembly.Module;
    /** Where the script of a worker is (`cairn-physics/mt/worker`), for bundlers that do not find it; default: beside this module. */
    worker?: string | URL;
}

/**
 * Loads the engine with threads and starts its workers. Every other call needs it, and throws `wrongState` before it is done. Further
 * calls return the same promise. Rejects with `unsupported` in a page that is not cross-origin isolated, `io` where a file cannot
 * be read, `invalidValue` for a wrong option, `wrongState` after `init` of `cairn-physics` or with another number of threads, and
 * `other` where a worker does not start.
 */
export default function init(options?: InitOptions): Promise<void>;
export { init };
