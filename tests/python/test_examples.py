"""Each script in docs/examples runs, and says or writes what it is about; so do those of
docs/how-to/python.md."""

import contextlib
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock

import ros_messages

SOURCE = pathlib.Path(os.environ["PREHEND_SOURCE"])
EXAMPLES = SOURCE / "docs" / "examples"


def run(file, *words, folder):
    environment = {k: v for k, v in os.environ.items() if "DISPLAY" not in k}
    environment["MPLCONFIGDIR"] = folder
    return subprocess.run(
        [sys.executable, str(file), *words],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
    )


class MoveGroup:
    """What the ROS 2 example sees of rclpy and move_group: takes all but the segment `refuses`."""

    def __init__(self, refuses=None):
        self.scenes = []
        self.trajectories = []
        self.refuses = refuses

    def apply(self, request):
        ros_messages.check("ApplyPlanningScene.Request", request)
        self.scenes.append(request.scene)
        answer = ros_messages.Message("ApplyPlanningScene.Response")
        answer.success = True
        return answer

    def execute(self, goal):
        ros_messages.check("ExecuteTrajectory.Goal", goal)
        self.trajectories.append(goal.trajectory.joint_trajectory)
        result = ros_messages.Message("ExecuteTrajectory.Result")
        result.error_code.val = 99999 if len(self.trajectories) - 1 == self.refuses else 1
        return result

    def modules(self):
        future, space = ros_messages.Future, types.SimpleNamespace

        class Node:
            def __init__(self, name):
                self.get_logger = lambda: space(info=print, error=print)

            def create_client(_, kind, name):
                assert (kind, name) == (service, "apply_planning_scene")
                return space(
                    wait_for_service=lambda seconds: True,
                    call_async=lambda request: future(self.apply(request)),
                )

        class ActionClient:
            def __init__(self, node, kind, name):
                assert (kind, name) == (action, "execute_trajectory")

            def wait_for_server(self, seconds):
                return True

            def send_goal_async(_, goal):
                result = future(space(result=self.execute(goal)))
                return future(space(accepted=True, get_result_async=lambda: result))

        service = space(Request=ros_messages.message_class("ApplyPlanningScene.Request"))
        action = space(Goal=ros_messages.message_class("ExecuteTrajectory.Goal"))
        nothing = {"init": lambda: None, "shutdown": lambda: None}
        return {
            "rclpy": space(spin_until_future_complete=lambda node, future: None, **nothing),
            "rclpy.action": space(ActionClient=ActionClient),
            "rclpy.node": space(Node=Node),
            "moveit_msgs": space(),
            "moveit_msgs.action": space(ExecuteTrajectory=action),
            "moveit_msgs.msg": space(MoveItErrorCodes=space(SUCCESS=1)),
            "moveit_msgs.srv": space(ApplyPlanningScene=service),
            "rosidl_runtime_py": space(),
            "rosidl_runtime_py.set_message": space(
                set_message_fields=ros_messages.set_message_fields
            ),
        }


class RosExample(unittest.TestCase):
    """docs/examples/ros2 with classes of the message definitions in place of ROS."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        words = "plan panda_on_table --path --export moveit --trials 200 --top 1 --out"
        subprocess.run(
            [os.environ["PREHEND_PROGRAM"], *words.split(), cls.folder.name],
            check=True,
            capture_output=True,
        )

    def carry_out(self, group):
        try:
            import yaml  # noqa: F401
        except ImportError:
            self.skipTest("there is no PyYAML")
        file = EXAMPLES / "ros2" / "execute_path.py"
        with unittest.mock.patch.dict(sys.modules, group.modules()):
            example = types.ModuleType("execute_path")
            exec(compile(file.read_text(), file, "exec"), example.__dict__)
            with unittest.mock.patch.object(sys, "argv", [file.name, self.folder.name, "1"]):
                with contextlib.redirect_stdout(io.StringIO()) as text:
                    status = example.main()
        return status, text.getvalue().split("\n")[:-1]

    def test_a_path_is_carried_out(self):
        group = MoveGroup()
        status, said = self.carry_out(group)
        self.assertEqual(status, 0, said)
        self.assertEqual(said[:3], ["transfer", "approach", "close"])
        self.assertEqual(len(group.trajectories), len(said))
        scene = group.scenes[0]
        self.assertTrue(scene.is_diff)
        self.assertEqual({body.id for body in scene.world.collision_objects} & {"bottle", "table"},
                         {"bottle", "table"})
        at = {}
        for trajectory in group.trajectories:
            self.assertTrue(all(name.startswith("panda_") for name in trajectory.joint_names))
            first = dict(zip(trajectory.joint_names, trajectory.points[0].positions))
            for name in at.keys() & first.keys():
                self.assertAlmostEqual(at[name], first[name], delta=1e-9)
            at.update(zip(trajectory.joint_names, trajectory.points[-1].positions))
            times = [p.time_from_start.sec + 1e-9 * p.time_from_start.nanosec
                     for p in trajectory.points]
            self.assertEqual(times, sorted(set(times)))
        self.assertEqual(len(at), 9)

    def test_a_segment_that_fails_ends_it(self):
        group = MoveGroup(refuses=1)
        status, said = self.carry_out(group)
        self.assertEqual(status, 1)
        self.assertEqual(said, ["transfer", "approach", "approach was not carried out"])


class Examples(unittest.TestCase):
    def example(self, name, *words):
        with tempfile.TemporaryDirectory() as folder:
            done = run(EXAMPLES / name, *words, folder=folder)
            files = {
                str(file.relative_to(folder)): file.read_bytes()
                for file in pathlib.Path(folder).rglob("*")
                if file.is_file() and "fontlist" not in file.name
            }
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout, files

    def test_plan_scene(self):
        text, files = self.example("plan_scene.py", "mug", "out")
        self.assertRegex(text, r"\n   1   0\.\d{4} ")
        self.assertIn("out/grasps.json", files)

    def test_own_mesh(self):
        text, _ = self.example("own_mesh.py")
        self.assertRegex(text, r"complete: [1-9]\d* grasps")
        self.assertIn("wall at", text)

    def test_own_grasps(self):
        text, _ = self.example("own_grasps.py")
        self.assertEqual(text.count("degrees"), 12)
        self.assertIn("stable", text)

    def test_quality_batch(self):
        text, _ = self.example("quality_batch.py")
        self.assertIn("alone: True", text)
        self.assertIn("balanced", text)

    def test_short_scripts(self):
        mesh = str(SOURCE / "docs" / "tutorial" / "bottle.obj")
        text, _ = self.example("friction_of_meshes.py", mesh)
        values = [float(number) for number in re.findall(r"epsilon ([\d.]+)", text)]
        self.assertEqual(len(values), 4)
        self.assertEqual(values, sorted(values))
        text, files = self.example("filter_shake_export.py")
        self.assertRegex(text, r"survived \d of \d")
        self.assertLessEqual({"out/grasps.json", "out/grasps.csv", "out/grasp_1.xml"}, set(files))
        text, _ = self.example("quality_of_many.py")
        self.assertRegex(text, r"^[1-9]\d* of 10000 hold")
        for name in ("friction_of_meshes.py", "filter_shake_export.py", "quality_of_many.py"):
            self.assertLessEqual(len((EXAMPLES / name).read_text().splitlines()), 15)

    def test_own_controller(self):
        text, _ = self.example("own_controller.py")
        errors = [float(number) for number in re.findall(r"([\d.]+) rad", text)]
        self.assertEqual(len(errors), 3)
        self.assertGreater(errors[0], 2 * errors[1])
        self.assertLess(errors[2], 1e-3)

    def test_epsilon_over_friction(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("there is no matplotlib")
        _, files = self.example("epsilon_over_friction.py", "plots")
        self.assertTrue(files["plots/epsilon_over_friction.png"].startswith(b"\x89PNG"))

    def test_all_are_tested(self):
        here = pathlib.Path(__file__).read_text()
        for file in EXAMPLES.glob("*.py"):
            self.assertIn(f'"{file.name}"', here)
            self.assertLess(len(file.read_text().splitlines()), 60, file.name)

    def test_the_examples_of_the_documentation(self):
        text = (SOURCE / "docs" / "how-to" / "python.md").read_text()
        examples = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertTrue(examples)
        for code in examples:
            with tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder) / "example.py"
                file.write_text(code)
                done = run(file, folder=folder)
            self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
