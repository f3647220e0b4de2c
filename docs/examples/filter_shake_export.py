"""Keeps grasps from above, shakes them, writes the files: ./run python THIS [SCENE] [FOLDER]"""

import sys

import prehend
from prehend import planning

scene, folder = (sys.argv[1:] + ["mug", "out"][len(sys.argv) - 1 :])[:2]
result = prehend.plan(scene, hand="franka_hand", top=30)
above = result.where(lambda grasp: grasp.approach[2] < -0.7)
shaken = planning.shake_grasps(above, "acronym", rank=True)
for grasp in shaken:
    if grasp.shake:
        print(f"epsilon {grasp.epsilon:.4f}, survived {grasp.shake.survived} of {grasp.shake.of}")
prehend.write_grasps(shaken, folder, exports=["csv", "mjcf"])
