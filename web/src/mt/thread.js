// The worker's side of Emscripten's threads: loads the module that the page sends, and runs threads in it, one after
// the other. It replaces Emscripten's own script, which neither bundlers nor Node with ES modules accept.
import createModule from '../../dist/mt/cairn.js';

/** `listen(receive)` must call `receive` for each message of the page; `post` sends a message. */
export function serve(listen, post) {
    let loading = null;
    const guarded = (work) =>
        Promise.resolve()
            .then(work)
            .catch((error) => post({ cmd: 'failed', text: String(error?.stack ?? error) }));
    listen((message) => {
        if (message.cmd === 'load') loading = guarded(() => load(message, post));
        else if (message.cmd === 'run') loading.then((module) => guarded(() => run(module, message)));
        else loading.then((module) => guarded(() => answer(module, message)));
    });
}

function load({ wasmModule, wasmMemory }, post) {
    return createModule({
        ENVIRONMENT_IS_PTHREAD: true,
        wasmMemory,
        buffer: wasmMemory.buffer,
        postMessage: post,
        instantiateWasm(imports, done) {
            const instance = new WebAssembly.Instance(wasmModule, imports);
            done(instance);
            return instance.exports;
        },
    });
}

// The arguments are those of worker.js of Emscripten 3.1.6: not the main thread, not the main browser thread, may
// block.
function run(module, { threadInfoStruct, start_routine: routine, arg, time }) {
    module.__performance_now_clock_drift = performance.now() - time;
    module.__emscripten_thread_init(threadInfoStruct, 0, 0, 1);
    module.establishStackSpace();
    module.PThread.threadInit();
    try {
        module.__emscripten_thread_exit(module.invokeEntryPoint(routine, arg));
    } catch (error) {
        if (error !== 'unwind') throw error; // thrown by pthread_exit
    }
}

function answer(module, message) {
    if (message.cmd === 'processThreadQueue') {
        if (module._pthread_self()) module._emscripten_current_thread_process_queued_calls();
    } else if (message.cmd === 'processProxyingQueue') {
        if (module._pthread_self()) module._emscripten_proxy_execute_queue(message.queue);
    } else {
        throw new Error(`unknown message ${message.cmd}`);
    }
}
