// The workers on which the module's threads run, in browsers and in Node, in the form that Emscripten's loader expects.
import { CairnError } from '../error.js';

// Not in the form that bundlers recognize: they would include the worker for Node in the page.
const HERE = import.meta.url;

const isNode = () => globalThis.process?.versions?.node !== undefined && globalThis.process.type !== 'renderer';

// Both kinds use `new Worker` in the form that bundlers recognize, and pass on messages and errors.
function browserWorker(address, onMessage, onError) {
    const worker =
        address === undefined
            ? new Worker(new URL('./worker.js', import.meta.url), { type: 'module' })
            : new Worker(address, { type: 'module' });
    worker.onmessage = ({ data }) => onMessage(data);
    worker.onerror = (event) => {
        event.preventDefault?.();
        onError(event.message || 'its script cannot be loaded');
    };
    return worker;
}

function nodeWorker(NodeWorker, address, onMessage, onError) {
    const worker = new NodeWorker(new URL(address ?? './worker_node.js', HERE), { execArgv: [] });
    worker.on('message', onMessage).on('error', (error) => onError(error.message));
    return worker;
}

export class WorkerPool {
    /** A pool whose workers run the script at that address; default: the script of the package. */
    static async of(address) {
        if (!isNode()) return new WorkerPool((...listeners) => browserWorker(address, ...listeners));
        const { Worker } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:worker_threads');
        return new WorkerPool((...listeners) => nodeWorker(Worker, address, ...listeners));
    }

    constructor(start) {
        const workers = (this.workers = []);
        let fail;
        /** Rejects if a worker cannot be started; never fulfilled. */
        this.failure = new Promise((_, reject) => (fail = reject));
        this.failure.catch(() => {}); // callers that wait for the promise receive the error

        /** The class of which the loader creates its workers. */
        this.Worker = class {
            onmessage = null;
            onerror = null;
            constructor() {
                this.loaded = new Promise((resolve) => (this.isLoaded = resolve));
                this.worker = start(
                    (message) => this.receive(message),
                    (text) => this.stumble(text),
                );
                workers.push(this);
            }
            receive(message) {
                if (message.cmd === 'failed') return this.stumble(message.text);
                this.onmessage({ data: message });
                if (message.cmd === 'loaded') this.isLoaded();
            }
            stumble(text) {
                const error = new CairnError('other', `cairn-physics/mt: a worker failed: ${text}`, 'worker', text);
                fail(error);
                if (pool.isReady) throw error; // no caller waits at this point
            }
            postMessage(message, transfer) {
                this.worker.postMessage(message, transfer);
            }
            terminate() {
                this.worker.terminate();
            }
        };
        const pool = this;
        this.isReady = false;
    }

    /** Resolves when all workers have loaded the module. From then on they do not keep Node running. */
    async ready() {
        await Promise.race([Promise.all(this.workers.map((worker) => worker.loaded)), this.failure]);
        this.isReady = true;
        for (const { worker } of this.workers) worker.unref?.();
    }

    dismiss() {
        for (const worker of this.workers) worker.terminate();
    }
}
