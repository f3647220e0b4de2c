#!/usr/bin/python3
"""Published grasps, and the same off their place, as executions for ./run truth.

    /usr/bin/python3 benchmarks/success/moved_grasps.py FOLDER > moved.json
    ./run truth moved.json

FOLDER holds grasps/dexycb_franka_*.json and ycb/*.obj. Each grasp is there twice: as it was
published, which counts as lifted, and moved by 15 mm along a random direction or, every other one,
turned by 25 degrees about a random axis through the middle of its palm, which counts as
failed. Objects weigh 0.1 kg.
"""
import json
import math
import pathlib
import random
import sys

import numpy as np

PIVOT = np.array([0.0, 0.0, 0.06595])  # the origin of the hand in its robot file [m]
DISTANCE = 0.015  # m
ANGLE = math.radians(25.0)


def direction(dice):
    while True:
        v = np.array([dice.uniform(-1.0, 1.0) for _ in range(3)])
        if 1e-3 < np.linalg.norm(v) <= 1.0:
            return v / np.linalg.norm(v)


def turn_about(axis, angle):
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross


def quaternion(turn):
    """w, x, y, z of the rotation nearest to `turn`, as the files have only seven digits."""
    u, _, vt = np.linalg.svd(turn)
    r = u @ vt
    k = np.array([
        [r[0, 0] - r[1, 1] - r[2, 2], 0, 0, 0],
        [r[1, 0] + r[0, 1], r[1, 1] - r[0, 0] - r[2, 2], 0, 0],
        [r[2, 0] + r[0, 2], r[2, 1] + r[1, 2], r[2, 2] - r[0, 0] - r[1, 1], 0],
        [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], np.trace(r)]])
    x, y, z, w = np.linalg.eigh(k / 3.0, UPLO="L")[1][:, -1]
    return [float(v) for v in (w, x, y, z)]


def execution(name, turn, position, lifted):
    return {"object": name, "session": "published" if lifted else "moved", "lifted": lifted,
            "X_object_hand": {"position": [float(v) for v in position],
                              "quaternion_wxyz": quaternion(turn)}}


def executions_of(name, file):
    dice = random.Random(name)
    rows = []
    for i, matrix in enumerate(file["grasps"]):
        pose = np.array(matrix, float)
        turn, position = pose[:3, :3], pose[:3, 3] + file["frame_offset_m"]
        rows.append(execution(name, turn, position, True))
        if i % 2 == 0:
            rows.append(execution(name, turn, position + DISTANCE * direction(dice), False))
        else:
            turned = turn_about(direction(dice), ANGLE) @ turn
            rows.append(execution(name, turned, position + turn @ PIVOT - turned @ PIVOT, False))
    return rows


def main(folder):
    files = sorted((folder / "grasps").glob("dexycb_franka_*.json"))
    names = [f.stem.removeprefix("dexycb_franka_") for f in files]
    rows = [row for name, f in zip(names, files)
            for row in executions_of(name, json.loads(f.read_text()))]
    objects = [{"name": n, "scene": str((folder / "ycb" / f"{n}.obj").resolve()), "mass": 0.1}
               for n in names]
    json.dump({"format": "prehend truth 1", "hand": "franka_hand", "objects": objects,
               "executions": rows}, sys.stdout, indent=1)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
