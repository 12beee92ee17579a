# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes recorded_scenes.json, which the stratum `trajectory` draws from, of folders that `pcm simulate` has left:

    pcm simulate bubbles --out bubbles && pcm simulate pedestrian --out pedestrian
    python3 record_scenes.py bubbles pedestrian > recorded_scenes.json

Of every pairing that touched it keeps some short stretches of accepted steps, one after the other, at even distances
over all that are recorded.
"""
import json
import math
import pathlib
import sys

STRETCHES = 4  # of a pairing, at most
STEPS = 4  # of a stretch
GREATEST_STEP = 5e-3  # s, of both scenes


def quaternion(A):
    """Of a rotation by rows, the greatest component positive."""
    squares = [1 + A[0] + A[4] + A[8], 1 + A[0] - A[4] - A[8], 1 - A[0] + A[4] - A[8], 1 - A[0] - A[4] + A[8]]
    s = 2 * math.sqrt(max(squares))
    differences = A[7] - A[5], A[2] - A[6], A[3] - A[1]
    xy, xz, yz = A[1] + A[3], A[2] + A[6], A[5] + A[7]
    rows = {
        0: (s * s / 4, *differences),
        1: (differences[0], s * s / 4, xy, xz),
        2: (differences[1], xy, s * s / 4, yz),
        3: (differences[2], xz, yz, s * s / 4),
    }
    return [x / s for x in rows[squares.index(max(squares))]]


def steps_of(file):
    """13 numbers each: w x y z of the unit quaternion, r, v, w; signs of quaternions go on from step to step."""
    steps = []
    for line in file.read_text().splitlines():
        numbers = [float.fromhex(word) for word in line.split()]
        q = quaternion(numbers[:9])
        if steps and sum(a * b for a, b in zip(q, steps[-1])) < 0:
            q = [-x for x in q]
        steps.append(q + numbers[9:])
    return steps


def follow(a, b):
    """Whether one step may be the next one after the other: where contact is lost between, nothing is recorded."""
    way = math.dist(a[4:7], b[4:7])
    speed = max(math.hypot(*a[7:10]), math.hypot(*b[7:10]))
    return way <= 1.5 * GREATEST_STEP * speed + 1e-6


def stretches_of(steps):
    whole = [
        steps[k : k + STEPS]
        for k in range(len(steps) - STEPS + 1)
        if all(follow(steps[i], steps[i + 1]) for i in range(k, k + STEPS - 1))
    ]
    n = min(STRETCHES, len(whole))
    return [whole[(2 * i + 1) * len(whole) // (2 * n)] for i in range(n)]


def rounded(step):
    """Nine digits of the pose, six of the velocities: what is drawn lies between steps anyway."""
    return [float(f"{x:.9g}") for x in step[:7]] + [float(f"{x:.6g}") for x in step[7:]]


def main():
    surfaces, pairings = {}, []
    for folder in map(pathlib.Path, sys.argv[1:]):
        scene = json.loads((folder / "scene.json").read_text())
        for body in [scene.get("ground", {}), *scene["bodies"]]:
            for surface in body.get("surfaces", []):
                surfaces[surface["name"]] = {"make": surface["make"], "parameters": surface.get("parameters", {})}
        index = json.loads((folder / "trajectory" / "trajectory.json").read_text())
        for pairing in index["pairings"]:
            stretches = stretches_of(steps_of(folder / "trajectory" / pairing["poses"]))
            if stretches:
                names = {side: index["surfaces"][pairing[side]]["name"] for side in "EF"}
                pairings.append({**names, "law": pairing["law"], "stretches": stretches})

    print('{\n"surfaces": {')
    print(",\n".join(f"  {json.dumps(name)}: {json.dumps(made)}" for name, made in surfaces.items()))
    print('},\n"pairings": [')
    for pairing in pairings:
        names = f'"E": {json.dumps(pairing["E"])}, "F": {json.dumps(pairing["F"])}'
        print(f' {{{names},\n  "law": {json.dumps(pairing["law"])},')
        text = ",\n".join(
            "   [" + ",\n    ".join(json.dumps(rounded(step), separators=(",", ":")) for step in stretch) + "]"
            for stretch in pairing["stretches"]
        )
        print('  "stretches": [\n' + text + "]}" + ("" if pairing is pairings[-1] else ","))
    print("]}")


if __name__ == "__main__":
    main()
