export * from './index.js';

export interface InitOptions {
    /**
     * The number of threads: the calling one, and workers, of which a world uses `world.threads - 1` until it is disposed of or
     * uses fewer. 1 to 256; default: the number of hardware threads, but at most 4.
     */
    threads?: number;
    /** The URL of this entry's `cairn.wasm` (`cairn-physics/mt/cairn.wasm`), or its contents; default: beside this module. */
    source?: string | URL | Response | Promise<Response> | ArrayBuffer | ArrayBufferView | WebAssembly.Module;
    /** The URL of the worker script (`cairn-physics/mt/worker`), for bundlers that do not find it; default: beside this module. */
    worker?: string | URL;
}

/**
 * Loads the engine with threads and starts its workers. Every other call needs it, and throws `wrongState` before it is done. Further
 * calls return the same promise. Rejects with `unsupported` in a page that is not cross-origin isolated, `io` if a file cannot be
 * read, `invalidValue` for an invalid option, `wrongState` after `init` of `cairn-physics` or with another number of threads, and
 * `other` if a worker does not start.
 */
export default function init(options?: InitOptions): Promise<void>;
export { init };
