"""The stubs say what the module has, everything public is documented, and types check strictly."""

import ast
import builtins
import enum
import inspect
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import prehend
from prehend import _core

MODULES = [prehend] + [
    getattr(prehend, name) for name in prehend.__all__ if inspect.ismodule(getattr(prehend, name))
]

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
            if issubclass(getattr(_core, node.name), enum.Enum):
                continue  # below
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


    def test_values_of_enumerations(self):
        for node in self.stub.body:
            cls = getattr(_core, getattr(node, "name", ""), None)
            if not (inspect.isclass(cls) and issubclass(cls, enum.Enum)):
                continue
            declared = {item.targets[0].id: item.value.value for item in node.body}
            with self.subTest(node.name):
                self.assertEqual(declared, {one.name: one.value for one in cls})


# Fields of C++ results that have another name in Python, by struct.
OTHER_NAMES = {
    "Candidate": {"approach_O": "approach"},
    "LoadCase": {"down_O": "down"},
    "Robustness": {
        "position_margin": "spare",
        "weakest_O": "weakest",
        "weakest_end": "weakest_outcome",
    },
    "Trial": {
        "blocked": "blocked_link",
        "arm_pair": "blocked_link",
        "overlap_shift": "gave_way",
    },
    "Tried": {
        "candidate": "candidates",
        "X_OH": "poses",
        "approach_O": "approach",
        "outcome": "outcomes",
    },
    "PlanResult": {"times": "seconds"},
}

# Fields that Python leaves out, and why.
ONLY_IN_CPP = {
    "Trial": {
        "X_OC": "X_OH and X_WH are of the moved object already",
        "arm_line": "plan_grasp_path() gives the whole path",
        "seconds": "not the same in every run",
    },
    "ScoredGrasp": {
        "trial": "its fields are the grasp's",
        "sections": "they are for the report",
        "tried": "the place in tried follows from the pose",
        "lift": "it is that of the path",
    },
    "Robustness": {"epsilons": "their mean and a low percentile are there"},
    "Refinement": {"parent": "an index into tried"},
    "Tried": {"collision_of": "blockers count them"},
    "HeldByPads": {"stiffness": "its softest motion is there"},
    "PlanResult": {"trial_seconds": "timings_json() has them"},
    "ProposedGrasp": {
        name: "state of the sequence of proposals"
        for name in ("width", "stand_off", "way", "choices", "level", "preferred")
    },
    "ContactForces": {"torque_multipliers": "only with a hand, which quality has not"},
    "StepResult": {name: "of the solver" for name in ("newton_steps", "shortened")},
}

# Structs that Python has under another name, or with their fields in arrays.
CLASSES = {
    "Trajectory": prehend.planning.Path,
    "TrajectorySegment": prehend.planning.Segment,
    "ScoredGrasp": prehend.Grasp,
}


def class_of(struct):
    found = [getattr(module, struct) for module in MODULES if hasattr(module, struct)]
    return CLASSES.get(struct) or found[0]


class Parity(unittest.TestCase):
    """Python has what C++ has."""

    def test_fields_of_results(self):
        self.assertIn("Decomposition", _core.fields_of_results)
        for struct, fields in _core.fields_of_results.items():
            if struct == "GraspContact":  # point is spread over position, normal, friction, ...
                continue
            cls = class_of(struct)
            names = set(getattr(cls, "_fields", ())) | set(getattr(cls, "__dataclass_fields__", ()))
            if cls is prehend.PlanResult:
                source = inspect.getsource(cls.__init__)
                names = {name for name in (*fields, "seconds") if f"self.{name}: " in source}
            left_out = ONLY_IN_CPP.get(struct, {})
            for field in fields:
                with self.subTest(f"{struct}.{field}"):
                    name = OTHER_NAMES.get(struct, {}).get(field, field)
                    self.assertNotEqual(name in names, field in left_out)

    def test_every_class_of_options_is_public(self):
        public = {getattr(module, name) for module in MODULES for name in module.__all__}
        for name, cls in vars(_core).items():
            if hasattr(cls, "_fields") and inspect.isclass(cls):
                self.assertIn(cls, public, name)


class Names(unittest.TestCase):
    def test_few_names_come_first(self):
        self.assertLessEqual(len(prehend.__all__), 30)
        for module in MODULES:
            for name in module.__all__:
                if not name.startswith("__"):
                    self.assertFalse(hasattr(builtins, name), name)

    def test_classes_say_where_they_are(self):
        for module in MODULES:
            for name in module.__all__:
                thing = getattr(module, name)
                if inspect.isclass(thing) and hasattr(thing, "__module__"):
                    with self.subTest(name):
                        self.assertNotIn("_", thing.__module__)
                        self.assertIs(getattr(sys.modules[thing.__module__], name), thing)

    def test_former_names_say_where_they_are_now(self):
        for name, place in {
            "solve_all": "prehend.robots.solve_all",
            "compile": "prehend.compile_scene",
            "truth": "prehend.validation.compare_executions",
            "step_world": "prehend.dynamics.World.step",
        }.items():
            with self.assertRaisesRegex(AttributeError, f"{place} now"):
                getattr(prehend, name)
        with self.assertRaisesRegex(AttributeError, "no attribute 'nothing'$"):
            prehend.nothing

    def test_members_are_strings(self):
        outcome = prehend.Outcome.no_contact
        self.assertEqual(outcome, "no_contact")
        self.assertEqual(f"{outcome} {outcome!s}", "no_contact no_contact")
        self.assertIs(prehend.Outcome("no_contact"), outcome)
        self.assertEqual({outcome: 1}["no_contact"], 1)
        self.assertEqual(outcome.__doc__, "the hand closed without touching the object")
        self.assertEqual(prehend.results.PlanCount.primitives_given, "primitives given")


class Documentation(unittest.TestCase):
    def test_everything_public_has_a_docstring(self):
        for module in MODULES:
            self.assertTrue(module.__doc__)
            for name in module.__all__:
                thing = getattr(module, name)
                if inspect.isclass(thing) or inspect.isfunction(thing):
                    self.assertTrue(inspect.getdoc(thing), name)
                    self.assertNotEqual(inspect.getdoc(thing), inspect.getdoc(object), name)

    def test_all_is_what_there_is(self):
        for module in MODULES:
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
