"""Plot how the quality of a plan's best grasps depends on the friction coefficient.

    ./run python docs/examples/epsilon_over_friction.py [FOLDER]

Writes FOLDER/epsilon_over_friction.png, and shows it where there is a display.
"""

import os
import sys
from pathlib import Path

import matplotlib
import numpy as np

import prehend
from prehend import options, quality

on_screen = bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
if not on_screen:
    matplotlib.use("Agg")
import matplotlib.pyplot as plt

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
scene = prehend.compile_scene(prehend.load_scene("mug"))
result = prehend.plan(scene, prehend.PlanOptions(rank=options.RankOptions(top=4)))

# For each grasp, one call for all friction coefficients: the same contacts once for each of them.
frictions = np.linspace(0.02, 1.2, 60)
figure, axes = plt.subplots(figsize=(7.5, 4.8), layout="constrained")
for rank, grasp in enumerate(result, 1):
    contacts = grasp.contacts
    epsilon = quality.epsilon(
        [contacts.positions] * len(frictions),
        [contacts.normals] * len(frictions),
        frictions,
        torque_origin=scene.torque_origin,
        torque_scale=scene.torque_scale,
    )
    label = f"rank {rank}: {len(contacts)} contacts, {grasp.preshape}"
    axes.plot(frictions, epsilon, label=label, linewidth=2)

axes.set_title(f"Grasps of the {scene.name} by the {scene.hand.name} hand, as point contacts")
axes.set_xlabel("friction coefficient of all contacts [1]")
axes.set_ylabel("quality ε [N per N of total normal force]")
axes.set_xlim(0.0, frictions[-1])
axes.set_ylim(bottom=0.0)
axes.grid(alpha=0.3)
axes.legend(loc="upper left", frameon=False)

folder.mkdir(parents=True, exist_ok=True)
figure.savefig(folder / "epsilon_over_friction.png", dpi=150)
print("wrote", folder / "epsilon_over_friction.png")
if on_screen:
    plt.show()
