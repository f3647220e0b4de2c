"""Epsilon of 10,000 grasps of four contacts on a ball of 50 mm: ./run python THIS"""

import time

import numpy as np

from prehend import quality

normals = np.random.default_rng(1).normal(size=(10000, 4, 3))
normals /= np.linalg.norm(normals, axis=2, keepdims=True)
start = time.perf_counter()
epsilon = quality.epsilon(-0.05 * normals, normals, friction=0.5, torque_scale=20.0)
print(f"{(epsilon > 0).sum()} of {len(epsilon)} hold; {time.perf_counter() - start:.2f} s")
