// node readings.mjs FILE: the messages of a recording for other programs, decoded by protobuf.js with the schemas in
// the file and compared with Foxglove's own schemas. Prints JSON: the number of messages and the last message of each
// topic.
import foxglove from "@foxglove/schemas/jsonschema.js";
import { McapIndexedReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";
import protobuf from "protobufjs";
import "protobufjs/ext/descriptor/index.js";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

const bytes = readFileSync(process.argv[2]);
const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
};
const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers: await loadDecompressHandlers() });

// Checks that the fields of a message, and of nested messages, exist in Foxglove's schema with the same type.
function compare(type, schema) {
    for (const field of type.fieldsArray) {
        let known = schema.properties[field.name];
        assert.ok(known, `${type.name}.${field.name} is no field of Foxglove's`);
        if (field.repeated && known.type === "array") known = known.items;
        if (field.resolvedType instanceof protobuf.Type && known.type === "object" && !/google/.test(field.type))
            compare(field.resolvedType, known);
    }
}

const types = new Map();
for (const [id, schema] of reader.schemasById) {
    if (schema.encoding !== "protobuf") continue;
    const root = protobuf.Root.fromDescriptor(schema.data);
    root.resolveAll();
    const type = root.lookupType(schema.name);
    types.set(id, type);
    const [space, name] = schema.name.split(".");
    if (space === "foxglove") compare(type, foxglove[name]);
}
const found = {};
for await (const message of reader.readMessages()) {
    const channel = reader.channelsById.get(message.channelId), type = types.get(channel.schemaId);
    if (!type) continue;
    const decoded = type.decode(message.data);
    assert.equal(type.verify(decoded), null);
    const { count = 0, first } = found[channel.topic] ?? {};
    const last = type.toObject(decoded, { longs: Number, enums: String, defaults: false });
    found[channel.topic] = { count: count + 1, first: first ?? last, last };
}
console.log(JSON.stringify(found));
