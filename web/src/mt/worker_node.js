// The script of a worker in Node.
import { parentPort } from 'node:worker_threads';
import { serve } from './thread.js';

serve(
    (receive) => parentPort.on('message', receive),
    (message, transfer) => parentPort.postMessage(message, transfer),
);
