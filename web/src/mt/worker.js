// The script of a worker in a browser.
import { serve } from './thread.js';

serve(
    (receive) => (self.onmessage = ({ data }) => receive(data)),
    (message, transfer) => self.postMessage(message, transfer),
);
