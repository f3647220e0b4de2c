"""The stubs say what the module has, everything public is documented, and types check strictly."""

import ast
import inspect
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import prehend
from prehend import _core, quality

PACKAGE = pathlib.Path(prehend.__file__).parent
EXAMPLES = pathlib.Path(os.environ["PREHEND_SOURCE"]) / "docs" / "examples"
# What pybind11 and Python give to every class.
COMMON = set(dir(object)) | {"__annotations__", "__module__", "__slots__", "__dict__", "__weakref__"}


def members(cls):
    # setuptools of pybind11: helpers of its own are no part of the interface.
    return {
        name
        for name in vars(cls)
        if name not in COMMON and not name.startswith("_pybind11") and name != "__entries"
    } | ({"__init__"} if "__init__" in vars(cls) else set())


class Stubs(unittest.TestCase):
    def setUp(self):
        self.stub = ast.parse((PACKAGE / "_core.pyi").read_text())

    def test_names(self):
        declared = set()
        for node in self.stub.body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                declared.add(node.name)
            if isinstance(node, ast.AnnAssign):
                declared.add(node.target.id)
        present = {
            name for name in vars(_core) if not name.startswith("__") or name == "__version__"
        }
        self.assertEqual(declared, present)

    def test_members(self):
        for node in self.stub.body:
            if not isinstance(node, ast.ClassDef):
                continue
            declared = set()
            for item in node.body:
                if isinstance(item, ast.FunctionDef):
                    declared.add(item.name)
                if isinstance(item, ast.AnnAssign):
                    declared.add(item.target.id)
            present = members(getattr(_core, node.name))
            with self.subTest(node.name):
                self.assertEqual(declared - {"__init__"}, present - {"__init__"})

    def test_fields_of_options(self):
        for node in self.stub.body:
            cls = getattr(_core, getattr(node, "name", ""), None)
            if not hasattr(cls, "_fields"):
                continue
            fields = [n.target.id for n in node.body if isinstance(n, ast.AnnAssign)][1:]
            init = next(n for n in node.body if getattr(n, "name", "") == "__init__")
            self.assertEqual(tuple(fields), cls._fields)
            self.assertEqual([a.arg for a in init.args.kwonlyargs], fields)
            for name in fields:
                self.assertTrue(getattr(cls, name).__doc__, f"{node.name}.{name}")


class Documentation(unittest.TestCase):
    def test_everything_public_has_a_docstring(self):
        for module in (prehend, quality):
            self.assertTrue(module.__doc__)
            for name in module.__all__:
                thing = getattr(module, name)
                if inspect.isclass(thing) or inspect.isfunction(thing):
                    self.assertTrue(inspect.getdoc(thing), name)
                    self.assertNotEqual(inspect.getdoc(thing), inspect.getdoc(object), name)

    def test_all_is_what_there_is(self):
        for module in (prehend, quality):
            self.assertEqual(len(module.__all__), len(set(module.__all__)))
            for name in module.__all__:
                self.assertTrue(hasattr(module, name), name)


class Types(unittest.TestCase):
    @unittest.skipUnless(shutil.which("mypy"), "there is no mypy")
    def test_mypy_strict(self):
        environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent)}
        for target in [["-p", "prehend"], *([str(file)] for file in sorted(EXAMPLES.glob("*.py")))]:
            found = subprocess.run(
                ["mypy", "--strict", "--ignore-missing-imports", "--cache-dir", os.devnull, "--python-executable", sys.executable]
                + target,
                capture_output=True,
                text=True,
                env=environment,
            )
            with self.subTest(target[-1]):
                self.assertEqual(found.returncode, 0, found.stdout + found.stderr)


if __name__ == "__main__":
    unittest.main()
