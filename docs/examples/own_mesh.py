"""Plan grasps of a mesh that is made in code and stands between two walls.

    ./run python docs/examples/own_mesh.py
"""

import numpy as np

import prehend

# A prism: eight points around a circle, at the bottom and at the top. Lengths are in metres.
angles = np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False)
ring = 0.03 * np.column_stack([np.cos(angles), np.sin(angles)])
vertices = np.vstack([np.column_stack([ring, np.full(8, z)]) for z in (0.0, 0.12)])

# Each triangle is three indices of vertices. Their order does not matter: prehend turns all
# triangles to face outward.
faces = []
for i in range(8):
    j = (i + 1) % 8
    faces += [[i, j, 8 + i], [j, 8 + j, 8 + i]]  # the side
for i in range(1, 7):
    faces += [[0, i + 1, i], [8, 8 + i, 9 + i]]  # the two ends

# Instead of the pair, a trimesh.Trimesh or any other object with vertices and faces can be passed.
scene = prehend.make_scene(
    (vertices, faces), hand="barrett", name="prism", material="wood", mass=0.4
)

# Two walls beside it, as obstacles. X_WB is the pose of the wall's frame in the world.
wall = (
    np.array([[x, y, z] for x in (0.0, 0.01) for y in (-0.2, 0.2) for z in (0.0, 0.3)]),
    np.array(
        [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1]]
        + [[2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
    ),
)
for side in (-0.2, 0.2):
    X_WB = np.eye(4)
    X_WB[0, 3] = side
    scene.add_obstacle(f"wall at {side}", wall, X_WB)

options = prehend.PlanOptions(search=prehend.options.SearchOptions(trials=200))
result = prehend.plan(scene, options)
print(result)
for blocker in result.blockers[:3]:
    print(f"{blocker.count} times {blocker.link} met {blocker.by}: {blocker.outcome}")
