"""Has MoveIt 2 carry out a path that prehend planned: a ROS 2 node.

    ./run plan panda_on_table --path --export moveit --top 1 --out out
    python3 docs/examples/ros2/execute_path.py out 1

Adds the planned object and obstacles to MoveIt's planning scene, and sends the segments of the path
(transfer, approach, close, lift, ...) to move_group one after the other. A segment that fails ends
it. Needs rclpy, moveit_msgs, rosidl_runtime_py and PyYAML, and a move_group that runs.
"""

import pathlib
import sys

import rclpy
import yaml
from moveit_msgs.action import ExecuteTrajectory
from moveit_msgs.msg import MoveItErrorCodes
from moveit_msgs.srv import ApplyPlanningScene
from rclpy.action import ActionClient
from rclpy.node import Node
from rosidl_runtime_py.set_message import set_message_fields

# Seconds to wait for move_group.
PATIENCE = 10.0


class MoveGroup:
    """What move_group offers to a node."""

    def __init__(self, node):
        self.node = node
        self.scene = node.create_client(ApplyPlanningScene, "apply_planning_scene")
        self.execution = ActionClient(node, ExecuteTrajectory, "execute_trajectory")

    def is_there(self):
        return self.scene.wait_for_service(PATIENCE) and self.execution.wait_for_server(PATIENCE)

    def wait_for(self, future):
        rclpy.spin_until_future_complete(self.node, future)
        return future.result()

    def add_scene(self, scene):
        """Whether the message, as a dictionary, was applied to the planning scene."""
        request = ApplyPlanningScene.Request()
        set_message_fields(request.scene, scene)
        return self.wait_for(self.scene.call_async(request)).success

    def execute(self, trajectory):
        """Whether the robot went along a RobotTrajectory, as a dictionary."""
        goal = ExecuteTrajectory.Goal()
        set_message_fields(goal.trajectory, trajectory)
        handle = self.wait_for(self.execution.send_goal_async(goal))
        if not handle.accepted:
            return False
        result = self.wait_for(handle.get_result_async()).result
        return result.error_code.val == MoveItErrorCodes.SUCCESS


def carry_out(folder, rank, group, log):
    """Whether the whole path was carried out."""
    if not group.is_there():
        log.error("there is no move_group")
        return False
    scene = yaml.safe_load((folder / "planning_scene_moveit.yaml").read_text())
    for body in scene["world"]["collision_objects"]:
        body["operation"] = bytes([body["operation"]])  # a `byte` is no number in Python
    if not group.add_scene(scene):
        log.error("the planning scene was refused")
        return False
    for part in yaml.safe_load((folder / f"path_{rank}_moveit.yaml").read_text()):
        log.info(part["segment"])
        if not group.execute(part["trajectory"]):
            log.error(f"{part['segment']} was not carried out")
            return False
    return True


def main():
    if len(sys.argv) != 3:
        sys.exit("execute_path.py FOLDER RANK")
    rclpy.init()
    node = Node("prehend_path")
    done = carry_out(pathlib.Path(sys.argv[1]), sys.argv[2], MoveGroup(node), node.get_logger())
    rclpy.shutdown()
    return 0 if done else 1


if __name__ == "__main__":
    sys.exit(main())
