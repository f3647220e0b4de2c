"""Compute the quality of many grasps at once, without a scene: three fingertips on a ball.

    ./run python docs/examples/quality_batch.py
"""

import numpy as np

from prehend import quality

# A thousand grasps of three contacts each: arrays of shape (G, N, 3), G = 1000, N = 3.
random = np.random.default_rng(1)
directions = random.normal(size=(1000, 3, 3))
directions /= np.linalg.norm(directions, axis=2, keepdims=True)
radius = 0.05  # m
positions = radius * directions
normals = -directions  # unit, into the object

# Torques are divided by the radius, so that epsilon does not depend on the size of the ball.
epsilon = quality.epsilon(positions, normals, friction=0.5, torque_scale=1.0 / radius)
print(f"{(epsilon > 0.0).mean():.0%} hold; the best has epsilon {epsilon.max():.4f}")

# The same grasp alone has the same epsilon.
best = int(epsilon.argmax())
alone = quality.epsilon(positions[best], normals[best], 0.5, torque_scale=1.0 / radius)
print("alone:", alone == epsilon[best])

# How hard must its fingers press to hold a ball of 3 N? A wrench is [force; torque * torque_scale].
forces = quality.balancing_forces(
    [0.0, 0.0, -3.0, 0.0, 0.0, 0.0],
    positions[best],
    normals[best],
    0.5,
    torque_scale=1.0 / radius,
)
print(f"{forces.outcome}: no finger presses with more than {forces.largest_normal:.2f} N")
