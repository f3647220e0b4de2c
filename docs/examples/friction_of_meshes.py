"""How epsilon of the best grasp grows with friction, on ten meshes: ./run python THIS MESH..."""

import sys

import prehend
from prehend import quality

for mesh in sys.argv[1:11]:
    result = prehend.plan(mesh, hand="barrett", top=1)
    where = {"torque_origin": result.scene.torque_origin, "torque_scale": result.scene.torque_scale}
    for contacts in result.contacts:
        for friction in (0.2, 0.4, 0.6, 0.8):
            epsilon = quality.epsilon(contacts.positions, contacts.normals, friction, **where)
            print(f"{mesh} friction {friction}: epsilon {epsilon:.4f}")
