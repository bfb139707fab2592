// node check.mjs FILE STEPS: reads a recording both through its index and as a stream, verifies all checksums, and
// counts the steps.
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

const [file, steps] = process.argv.slice(2);
const bytes = readFileSync(file);
const decompressHandlers = await loadDecompressHandlers();

function leb128(data, at) {
    let value = 0, shift = 1;
    for (;;) {
        const byte = data[at++];
        value += (byte & 0x7f) * shift;
        if (byte < 0x80) return [value, at];
        shift *= 128;
    }
}

// Counts steps according to the format description in the file: a step is an empty entry followed by a digest of 32
// bytes.
function digestsOf(data) {
    let count = 0;
    for (let [, at] = leb128(data, 0); at < data.length;) {
        const [size, start] = leb128(data, at);
        count += size === 0 ? 1 : 0;
        at = start + (size === 0 ? 32 : size);
    }
    return count;
}

const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
};
const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
const topics = new Map([...reader.channelsById.values()].map((channel) => [channel.id, channel.topic]));
assert.equal(reader.header.profile, "cairn");
for (const schema of reader.schemasById.values()) {
    if (schema.encoding === "cairn" || schema.encoding === "jsonschema")
        JSON.parse(new TextDecoder().decode(schema.data));
}
let digests = 0, messages = 0n;
for await (const message of reader.readMessages()) {
    ++messages;
    if (topics.get(message.channelId) === "/cairn/commands") digests += digestsOf(message.data);
}
assert.equal(digests, Number(steps));
assert.equal(messages, reader.statistics.messageCount);
const metadata = [];
for await (const entry of reader.readMetadata()) metadata.push(entry.name);
assert.deepEqual(metadata, ["cairn"]);

const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
stream.append(bytes);
let streamed = 0n;
for (let record = stream.nextRecord(); record; record = stream.nextRecord()) {
    if (record.type === "Message") ++streamed;
}
assert.ok(stream.done());
assert.equal(streamed, messages);
console.log(`${messages} messages, ${digests} steps`);
