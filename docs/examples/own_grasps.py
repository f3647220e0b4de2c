"""Simulate and score grasps that another program proposed; here: around a mug, from all sides.

    ./run python docs/examples/own_grasps.py
"""

import numpy as np

import prehend
from prehend import robots

scene = prehend.compile_scene(prehend.load_scene("mug", hand="barrett"))

# The height of the hand's base, and its distance from the mug's axis [m].
height = float(scene.object.vertices[:, 2].mean())
distance = 0.115

# Twelve poses of the hand's base in the object's frame, X_OH. The Barrett hand approaches along its
# z axis, here towards the mug's axis; its x axis points up, and y completes a right-handed frame.
poses = []
for angle in np.linspace(0.0, 2.0 * np.pi, 12, endpoint=False):
    outward = np.array([np.cos(angle), np.sin(angle), 0.0])
    X_OH = np.eye(4)
    X_OH[:3, 2] = -outward
    X_OH[:3, 0] = [0.0, 0.0, 1.0]
    X_OH[:3, 1] = np.cross(-outward, [0.0, 0.0, 1.0])
    X_OH[:3, 3] = distance * outward + [0.0, 0.0, height]
    poses.append(X_OH)

# Each is tried exactly there, without an approach: result i belongs to pose i. The fingers start at
# the named opening (preshape).
opening = robots.preshapes(scene.hand)[0]
result = prehend.evaluate(scene, np.array(poses), preshape=opening)
for i, grasp in enumerate(result):
    blocked = f" ({grasp.blocked_link} met {grasp.blocked_by})" if grasp.blocked_by else ""
    print(f"{30 * i:3} degrees: {grasp.outcome}{blocked}, epsilon {grasp.epsilon:.4f}")

# The contacts of all grasps in flat arrays, with the index of the grasp that each belongs to.
contacts = result.flat_contacts
print(len(contacts), "contacts; of the first grasp:", int((contacts.grasps == 0).sum()))
