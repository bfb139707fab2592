// What a worker of a browser runs.
import { serve } from './thread.js';

serve(
    (receive) => (self.onmessage = ({ data }) => receive(data)),
    (message, transfer) => self.postMessage(message, transfer),
);
