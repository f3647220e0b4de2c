"""Have grasps tried and scored that somebody else proposed, here: around a mug, from all sides.

    ./run python docs/examples/own_grasps.py
"""

import numpy as np

import prehend

scene = prehend.compile(prehend.load_scene("mug", hand="barrett"))

# The height at which the hand comes, and how far its base stays from the axis [m].
height = float(scene.object.vertices[:, 2].mean())
distance = 0.115

# Twelve poses of the hand's base in the object's frame, X_OH: its z is the way the palm moves, here
# towards the axis, its x points up, y completes it.
poses = []
for angle in np.linspace(0.0, 2.0 * np.pi, 12, endpoint=False):
    outward = np.array([np.cos(angle), np.sin(angle), 0.0])
    X_OH = np.eye(4)
    X_OH[:3, 2] = -outward
    X_OH[:3, 0] = [0.0, 0.0, 1.0]
    X_OH[:3, 1] = np.cross(-outward, [0.0, 0.0, 1.0])
    X_OH[:3, 3] = distance * outward + [0.0, 0.0, height]
    poses.append(X_OH)

# Each is tried where it is: result i belongs to pose i. The fingers start at a named opening.
opening = prehend.preshapes(scene.hand)[0]
result = prehend.evaluate(scene, np.array(poses), preshape=opening)
for i, grasp in enumerate(result):
    blocked = f" ({grasp.blocked_link} met {grasp.blocked_by})" if grasp.blocked_by else ""
    print(f"{30 * i:3} degrees: {grasp.outcome}{blocked}, epsilon {grasp.epsilon:.4f}")

# All contacts of all grasps in one array, with the number of the grasp that each belongs to.
contacts = result.flat_contacts
print(len(contacts), "contacts; of the first grasp:", int((contacts.grasps == 0).sum()))
