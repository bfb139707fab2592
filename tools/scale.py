#!/usr/bin/env python3
"""One world on many ranks: makes a pit, measures it and its checkpoints, fits a model of a step, and says what that predicts (docs/scale.md).

usage: tools/scale.py pit BODIES FILE.gltf
       tools/scale.py measure CAIRN FILE.gltf [--ranks 1,2,4,8] [--frames 20] [--out FILE.json]
       tools/scale.py weak CAIRN BODIES [--ranks 1,2,4,8] [--settle 110] [--frames 20] [--folder DIR] [--out FILE.json]
       tools/scale.py checkpoints CAIRN FILE.gltf [--ranks 1,2,4,8] [--times 3] [--folder DIR]
       tools/scale.py predict FILE.json [--latency 2e-6] [--bandwidth 1e10]
"""
import argparse
import json
import math
import os
import random
import subprocess
import sys
import tempfile

FACES = 6  # neighboring cubes of bodies, one per face
SWEEPS = 12  # passes over the colors per step: two in each of six substeps
# Bytes: a velocity, the result of a body including the tests of its pairs, and that of a contact.
ROW, BODY, CONTACT = 32, 150, 12


def write_pit(bodies, path):
    """Writes balls, cubes and bricks in a square pit that is as deep as wide, closely packed without touching, with
    small random offsets."""
    numbers = random.Random(1)
    side = math.ceil(bodies ** (1 / 3))
    half, gap = 0.55 * side + 0.5, 1.1
    fixed = lambda at, size, shape: {"translation": at, "extensions": {"KHR_physics_rigid_bodies": {"collider": {
        "geometry": {"shape": shape}, "physicsMaterial": 0}}}}
    shapes = [{"type": "sphere", "sphere": {"radius": 0.5}}, {"type": "box", "box": {"size": [0.85, 0.85, 0.85]}},
              {"type": "box", "box": {"size": [0.95, 0.7, 0.6]}},
              {"type": "box", "box": {"size": [2 * half + 4, 2, 2 * half + 4]}},
              {"type": "box", "box": {"size": [2, 2 * side + 8, 2 * half + 4]}},
              {"type": "box", "box": {"size": [2 * half + 4, 2 * side + 8, 2]}}]
    nodes = [fixed([0, -1, 0], 0, 3)]
    for sign in (-1, 1):
        nodes += [fixed([sign * (half + 1), side, 0], 0, 4), fixed([0, side, sign * (half + 1)], 0, 5)]
    for i in range(bodies):
        x, y, z = i % side, i // (side * side), i // side % side
        at = [gap * (n - (side - 1) / 2) + 0.03 * numbers.uniform(-1, 1) for n in (x, 0, z)]
        at[1] = 0.6 + 1.02 * y
        nodes.append({"translation": at, "extensions": {"KHR_physics_rigid_bodies": {"motion": {}, "collider": {
            "geometry": {"shape": i % 3}, "physicsMaterial": 0}}}})
    scene = {"asset": {"version": "2.0", "generator": "tools/scale.py"},
             "extensionsUsed": ["KHR_physics_rigid_bodies", "KHR_implicit_shapes"],
             "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
             "extensions": {"KHR_implicit_shapes": {"shapes": shapes}, "KHR_physics_rigid_bodies": {
                 "physicsMaterials": [{"staticFriction": 0.5, "dynamicFriction": 0.5, "restitution": 0}]}}}
    with open(path, "w", encoding="utf-8") as file:
        json.dump(scene, file)


def run(cairn, scene, ranks, frames, *options):
    command = [cairn, "run", scene, "--frames", str(frames), "--json", *(options or ("--threads", "1"))]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-n", str(ranks)] + command
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_btl_base_warn_component_unused="0")
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit status {done.returncode}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def measured(cairn, scene, ranks, frames):
    result = run(cairn, scene, ranks, frames)
    steps, per_rank = result["steps"], result["ranks"]
    mean = lambda name: sum(r[name] for r in per_rank) / len(per_rank) / steps
    greatest = lambda name: max(r[name] for r in per_rank)
    return {"ranks": ranks, "bodies": result["bodies"], "contacts": result["contacts"], "hash": result["hash"],
            "wall_ms": result["ms_per_step"]["median"], "compute_ms": 1e3 * mean("processor_seconds_else"),
            "slowest_ms": 1e3 * greatest("processor_seconds_else") / steps, "messages": mean("messages"),
            "kilobytes": 1e-3 * mean("bytes"), "memory_mb": greatest("memory_mb")}


def weak(arguments):
    """Weak scaling: the same number of bodies per rank for each number of ranks; each world is also run by one process.
    Measures the time of a step per rank."""
    runs = []
    print("| ranks | bodies | contacts a body | processor time of one process for that world, ms a step | of each rank | "
          "slowest / mean | efficiency | clock, ms a step | memory of one process, MB | of each rank |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory(dir=arguments.folder) as folder:
        for ranks in arguments.ranks:
            pit, fallen = os.path.join(folder, "pit.gltf"), os.path.join(folder, "fallen.gltf")
            write_pit(ranks * arguments.bodies, pit)
            run(arguments.cairn, pit, 1, arguments.settle, "--save", fallen)
            alone = measured(arguments.cairn, fallen, 1, arguments.frames)
            shared = measured(arguments.cairn, fallen, ranks, arguments.frames) if ranks > 1 else alone
            if alone["hash"] != shared["hash"]:
                sys.exit(f"the states differ: one process {alone['hash']}, {ranks} ranks {shared['hash']}")
            runs.append({"alone": alone, "shared": shared})
            efficiency = runs[0]["shared"]["compute_ms"] / shared["compute_ms"]
            print(f"| {ranks} | {alone['bodies']} | {alone['contacts'] / alone['bodies']:.2f} | {alone['compute_ms']:.1f} | "
                  f"{shared['compute_ms']:.1f} | {shared['slowest_ms'] / shared['compute_ms']:.2f} | "
                  f"{100 * efficiency:.0f} % | {shared['wall_ms']:.0f} | {alone['memory_mb']:.0f} | "
                  f"{shared['memory_mb']:.0f} |", flush=True)
    if arguments.out:
        with open(arguments.out, "w", encoding="utf-8") as file:
            json.dump(runs, file, indent=1)


def measure(arguments):
    runs = []
    for ranks in arguments.ranks:
        runs.append(measured(arguments.cairn, arguments.scene, ranks, arguments.frames))
        r = runs[-1]
        print(f"| {ranks} | {r['hash']} | {r['wall_ms']:.0f} | {r['compute_ms']:.1f} | "
              f"{r['slowest_ms'] / r['compute_ms']:.2f} | {r['messages']:.0f} | {r['kilobytes']:.0f} | "
              f"{r['memory_mb']:.0f} |", flush=True)
    if len({r["hash"] for r in runs}) != 1:
        sys.exit("the states differ: " + ", ".join(f"{r['ranks']} ranks {r['hash']}" for r in runs))
    if arguments.out:
        with open(arguments.out, "w", encoding="utf-8") as file:
            json.dump(runs, file, indent=1)


def checkpoints(arguments):
    """The processor time and the wall-clock time of a checkpoint on rank 0: the minimum of several runs, as other
    programs and the disk cache prolong some of them."""
    print("| ranks | all parts, MB | part of a rank, MB | processor time of a rank for its snapshot, ms | for its part, ms | "
          "clock, ms |")
    print("|---|---|---|---|---|---|")
    for ranks in arguments.ranks:
        rows = []
        for _ in range(arguments.times):
            with tempfile.TemporaryDirectory(dir=arguments.folder) as folder:
                place = os.path.join(folder, "ck")
                now = run(arguments.cairn, arguments.scene, ranks, 1, "--threads", "1", "--checkpoint", place)["checkpoints"]
                part = os.path.getsize(os.path.join(place, "step_1", "part_0"))
                rows.append([now["megabytes"], 1e-6 * part] +
                            [1e3 * now[name] for name in ("processor_seconds_saving", "processor_seconds_own_part", "seconds")])
        print(f"| {ranks} | " + " | ".join(f"{min(column):.1f}" for column in zip(*rows)) + " |", flush=True)


def fit_line(points):
    """Least squares of y = a + b x."""
    n, sx = len(points), sum(x for x, _ in points)
    sy, sxx, sxy = sum(y for _, y in points), sum(x * x for x, _ in points), sum(x * y for x, y in points)
    b = (n * sxy - sx * sy) / (n * sxx - sx * sx)
    return (sy - b * sx) / n, b


def delay_of_waiting(ranks, rounds, jitter, seed=1):
    """The mean time of a round in a network of ranks, each of which waits for its six neighbors in a cube after each
    round. A round takes 1 +- jitter (its standard deviation)."""
    side = max(2, round(ranks ** (1 / 3)))
    numbers = random.Random(seed)
    index = lambda x, y, z: (x % side * side + y % side) * side + z % side
    cells = [(x, y, z) for x in range(side) for y in range(side) for z in range(side)]
    near = [[index(x + d, y, z) for d in (-1, 0, 1)] + [index(x, y + d, z) for d in (-1, 1)] +
            [index(x, y, z + d) for d in (-1, 1)] for x, y, z in cells]
    now = [0.0] * len(cells)
    for _ in range(rounds):
        ready = [t + max(0.0, numbers.gauss(1, jitter)) for t in now]
        now = [max(ready[k] for k in near[i]) for i in range(len(cells))]
    return max(now) / rounds


def predict(arguments):
    with open(arguments.file, encoding="utf-8") as file:
        runs = json.load(file)
    bodies = runs[0]["bodies"]
    replicated, shared = fit_line([(1 / r["ranks"], r["compute_ms"]) for r in runs])
    imbalance = max(r["slowest_ms"] / r["compute_ms"] for r in runs)
    cut = [r for r in runs if r["ranks"] > 1]
    rounds = max(r["messages"] for r in cut) / min(FACES, cut[-1]["ranks"] - 1)
    print(f"fit: {1e3 * replicated / bodies:.2f} us a body on every rank, {1e3 * shared / bodies:.2f} us a body shared out, "
          f"slowest {imbalance:.2f} of the mean, some {rounds:.0f} rounds of messages a step")
    delays = {n: delay_of_waiting(n, 200, 0.1) for n in (8, 64, 1000)}
    print("waiting (rounds that vary by 10 %): " + ", ".join(f"{n} ranks {d:.2f}" for n, d in delays.items()))
    whole = 1e-3 * (replicated + shared) / bodies  # s per body, if all stages were distributed
    waiting = delays[1000]
    print("| bodies | ranks | as it is, s a step | memory a rank, GB | all shared out, s a step | efficiency | memory, GB |")
    print("|---|---|---|---|---|---|---|")
    memory = 1e6 * runs[0]["memory_mb"] / bodies
    memory_left = 1e6 * cut[-1]["memory_mb"] / bodies
    for count in (1e6, 1e8, 1e10):
        for ranks in (8, 100, 10_000):
            here = count / ranks
            border = FACES * here ** (2 / 3)
            traffic = rounds * arguments.latency + SWEEPS * ROW * border / arguments.bandwidth
            now = 1e-3 * count / bodies * (replicated + shared * imbalance / ranks)
            now += traffic + (BODY + CONTACT * runs[0]["contacts"] / bodies) * count / arguments.bandwidth
            then = here * whole * imbalance * waiting + traffic
            print(f"| {count:.0e} | {ranks} | {now:.3g} | {1e-9 * memory_left * count:.3g} | {then:.3g} | "
                  f"{100 * here * whole / then:.0f} % | {1e-9 * memory * (here + border):.3g} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    pit = commands.add_parser("pit")
    pit.add_argument("bodies", type=int)
    pit.add_argument("file")
    measuring = commands.add_parser("measure")
    measuring.add_argument("cairn")
    measuring.add_argument("scene")
    measuring.add_argument("--frames", type=int, default=20)
    measuring.add_argument("--out")
    weakly = commands.add_parser("weak")
    weakly.add_argument("cairn")
    weakly.add_argument("bodies", type=int, help="of each rank")
    weakly.add_argument("--settle", type=int, default=110, help="steps until most bodies touch")
    weakly.add_argument("--frames", type=int, default=20)
    weakly.add_argument("--folder", help="for scenes on the way")
    weakly.add_argument("--out")
    writing = commands.add_parser("checkpoints")
    writing.add_argument("cairn")
    writing.add_argument("scene")
    writing.add_argument("--times", type=int, default=3)
    writing.add_argument("--folder", help="for the checkpoints: on the disk that is measured")
    predicting = commands.add_parser("predict")
    predicting.add_argument("file")
    predicting.add_argument("--latency", type=float, default=2e-6, help="s")
    predicting.add_argument("--bandwidth", type=float, default=1e10, help="bytes a second")
    for parallel in measuring, weakly, writing:
        parallel.add_argument("--ranks", type=lambda s: [int(n) for n in s.split(",")], default=[1, 2, 4, 8])
    arguments = parser.parse_args()
    if arguments.command == "pit":
        write_pit(arguments.bodies, arguments.file)
    elif arguments.command == "measure":
        measure(arguments)
    elif arguments.command == "weak":
        weak(arguments)
    elif arguments.command == "checkpoints":
        checkpoints(arguments)
    else:
        predict(arguments)


if __name__ == "__main__":
    main()
