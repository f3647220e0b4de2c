"""Each script in docs/examples runs, and says or writes what it is about; so do those of
docs/how-to/python.md."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

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
