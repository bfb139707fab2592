#!/usr/bin/env python3
"""Reads an animated .glb file by the glTF 2.0 specification alone, and compares it with a trajectory of the same run.

usage: check_animation.py RUN.glb RUN.csv

It shares no code with the library: this is how another program sees the file. Every offset, count and index is checked
against the buffer, the bounds of POSITION against the vertices, key times for their order, quaternions for their
length; then every key frame against the line of `cairn run --csv` for the same body and moment.
"""
import csv
import json
import math
import struct
import sys

COMPONENTS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
FORMATS = {5123: "H", 5125: "I", 5126: "f"}


def require(condition, message):
    if not condition:
        sys.exit("check_animation: " + message)


def read_container(path):
    with open(path, "rb") as file:
        data = file.read()
    magic, version, length = struct.unpack_from("<4sII", data, 0)
    require(magic == b"glTF" and version == 2 and length == len(data), "bad header")
    json_length, json_type = struct.unpack_from("<I4s", data, 12)
    require(json_type == b"JSON" and json_length % 4 == 0, "bad JSON chunk")
    start = 20 + json_length
    binary_length, binary_type = struct.unpack_from("<I4s", data, start)
    require(binary_type == b"BIN\0" and binary_length % 4 == 0, "bad binary chunk")
    require(start + 8 + binary_length == len(data), "chunks do not fill the file")
    return json.loads(data[20:start]), data[start + 8 :]


class Reader:
    def __init__(self, document, binary):
        self.document, self.binary = document, binary
        require(len(document["buffers"]) == 1 and "uri" not in document["buffers"][0], "one buffer in the file")
        require(document["buffers"][0]["byteLength"] <= len(binary), "buffer longer than its chunk")

    def accessor(self, index):
        accessor = self.document["accessors"][index]
        view = self.document["bufferViews"][accessor["bufferView"]]
        count, width = accessor["count"], COMPONENTS[accessor["type"]]
        letter = FORMATS[accessor["componentType"]]
        size = struct.calcsize("<" + letter)
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        require(count > 0 and start % size == 0, f"accessor {index}: count or alignment")
        require("byteStride" not in view, f"accessor {index}: packed")
        require(accessor.get("byteOffset", 0) + count * width * size <= view["byteLength"], f"accessor {index}: view")
        require(view.get("byteOffset", 0) + view["byteLength"] <= len(self.binary), f"accessor {index}: buffer")
        flat = struct.unpack_from(f"<{count * width}{letter}", self.binary, start)
        rows = [flat[i : i + width] for i in range(0, len(flat), width)]
        for name, pick in (("min", min), ("max", max)):
            if name in accessor:
                found = [pick(row[k] for row in rows) for k in range(width)]
                given = [struct.unpack("<f", struct.pack("<f", v))[0] for v in accessor[name]]
                require(found == given, f"accessor {index}: {name} is {given}, and the data have {found}")
        return rows

    def check_meshes(self):
        triangles = 0
        for mesh in self.document["meshes"]:
            for primitive in mesh["primitives"]:
                attributes = primitive["attributes"]
                require("min" in self.document["accessors"][attributes["POSITION"]], "POSITION has bounds")
                vertices = self.accessor(attributes["POSITION"])
                if "NORMAL" in attributes:
                    normals = self.accessor(attributes["NORMAL"])
                    require(len(normals) == len(vertices), "a normal for each vertex")
                    require(all(abs(math.dist(n, (0, 0, 0)) - 1) < 1e-3 for n in normals), "unit normals")
                indices = [row[0] for row in self.accessor(primitive["indices"])]
                require(len(indices) % 3 == 0 and max(indices) < len(vertices), "indices in range")
                require(primitive["material"] < len(self.document["materials"]), "material in range")
                triangles += len(indices) // 3
        return triangles

    def tracks(self):
        """Key frames of every node that moves: times, translations, rotations."""
        tracks = {}
        for animation in self.document.get("animations", []):
            for channel in animation["channels"]:
                sampler = animation["samplers"][channel["sampler"]]
                require(sampler["interpolation"] == "LINEAR", "linear interpolation")
                times = [row[0] for row in self.accessor(sampler["input"])]
                require("min" in self.document["accessors"][sampler["input"]], "key times have bounds")
                require(times[0] == 0 and all(a < b for a, b in zip(times, times[1:])), "key times increase from 0")
                values = self.accessor(sampler["output"])
                require(len(values) == len(times), "a value for each key time")
                track = tracks.setdefault(channel["target"]["node"], {"times": times})
                track[channel["target"]["path"]] = values
        for track in tracks.values():
            require(set(track) == {"times", "translation", "rotation"}, "translation and rotation of what moves")
            rotations = track["rotation"]
            require(all(abs(math.dist(q, (0, 0, 0, 0)) - 1) < 1e-4 for q in rotations), "unit quaternions")
            near = all(sum(a * b for a, b in zip(p, q)) >= 0 for p, q in zip(rotations, rotations[1:]))
            require(near, "quaternions do not jump to their negatives")
        return tracks


def main():
    document, binary = read_container(sys.argv[1])
    require(document["asset"]["version"] == "2.0", "version")
    reader = Reader(document, binary)
    triangles = reader.check_meshes()
    tracks = reader.tracks()
    nodes = document["nodes"]
    roots = document["scenes"][document["scene"]]["nodes"]
    shown = list(roots)
    for node in shown:
        shown.extend(nodes[node].get("children", []))
    require(sorted(shown) == list(range(len(nodes))), "every node is shown once")

    moments = {}
    with open(sys.argv[2], newline="") as file:
        for line in csv.DictReader(file):
            moments.setdefault(int(line["body"]), []).append(line)
    require(len(moments) <= len(roots), "a node for each body")
    frames = 0
    for body, lines in sorted(moments.items()):
        node = nodes[roots[body]]
        track = tracks.get(roots[body])
        for i, line in enumerate(lines):
            if track:
                require(len(track["times"]) == len(lines), "a key frame for each moment")
                require(abs(track["times"][i] - float(line["time"])) < 1e-4, "key times are those of the run")
                position, rotation = track["translation"][i], track["rotation"][i]
                frames += 1
            else:
                position, rotation = node.get("translation", [0, 0, 0]), node.get("rotation", [0, 0, 0, 1])
            wanted = [float(line[k]) for k in ("px", "py", "pz")]
            scale = 1 + max(abs(v) for v in wanted)
            require(math.dist(position, wanted) < 1e-5 * scale, f"body {body}, moment {i}: position {position}")
            wanted = [float(line[k]) for k in ("qx", "qy", "qz", "qw")]
            alike = abs(sum(a * b for a, b in zip(rotation, wanted)))
            require(abs(alike - 1) < 1e-4, f"body {body}, moment {i}: rotation {rotation}")
    print(f"{len(moments)} bodies, {triangles} triangles, {frames} key frames agree")


if __name__ == "__main__":
    main()
