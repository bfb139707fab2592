// The workers whose threads the module uses, of browsers and of Node, as Emscripten's loader wants them.
import { CairnError } from '../error.js';

// Not written as bundlers look for it, which would take the worker for Node into the page.
const HERE = import.meta.url;

const isNode = () => globalThis.process?.versions?.node !== undefined && globalThis.process.type !== 'renderer';

// Both kinds begin with `new Worker`, in the form that bundlers know, and call back with messages and errors.
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
    /** A pool whose workers run the script at that address; left out: the one of the package. */
    static async of(address) {
        if (!isNode()) return new WorkerPool((...listeners) => browserWorker(address, ...listeners));
        const { Worker } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:worker_threads');
        return new WorkerPool((...listeners) => nodeWorker(Worker, address, ...listeners));
    }

    constructor(start) {
        const workers = (this.workers = []);
        let fail;
        /** Rejects when a worker cannot be started; never fulfilled. */
        this.failure = new Promise((_, reject) => (fail = reject));
        this.failure.catch(() => {}); // those who wait for it get it

        /** What the loader makes its workers of. */
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
                if (pool.isReady) throw error; // nobody waits any more
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

    /** When all workers have loaded the module. From then on, they do not keep Node from ending. */
    async ready() {
        await Promise.race([Promise.all(this.workers.map((worker) => worker.loaded)), this.failure]);
        this.isReady = true;
        for (const { worker } of this.workers) worker.unref?.();
    }

    dismiss() {
        for (const worker of this.workers) worker.terminate();
    }
}
