"""prehend plans robot grasps: a mesh and a hand in, ranked grasps out.

    import prehend

    result = prehend.plan("mug", hand="franka_hand", top=3)
    for grasp in result:
        print(grasp.epsilon, grasp.X_OH)

What most programs need is here; the rest is in

    options      what a plan and its steps depend on
    planning     the steps of a plan by themselves
    results      what a plan returns
    scenes       scenes, their bodies, meshes
    robots       robots by name, kinematics and its inverse
    files        grasps.json, reports, exports, pictures
    quality      how well contacts hold an object
    dynamics     worlds that move, and controllers
    validation   scores compared with executed grasps

Lengths are in metres, angles in radians. X_AB, a 4 x 4 array, is the pose of frame B in frame A, so that
p_A = X_AB @ p_B for homogeneous points; O is the object's frame, H the hand's base, W the world, B a
robot's base. Names are those of the C++ library (docs/how-to/python.md).

A caller's mistake raises InputError. Long calls run without the GIL; Ctrl-C ends them.
"""

from __future__ import annotations

import typing

from . import dynamics, files, options, planning, quality, results, robots, scenes, validation
from ._core import (
    Cancellation,
    CompiledScene,
    EvaluateOptions,
    Outcome,
    PlanOptions,
    __version__,
)
from ._errors import Cancelled, InputError
from ._names import show_in
from ._steps import Candidate
from .files import write_grasps
from .planning import evaluate, plan, plan_options
from .results import Grasp, PlanResult
from .scenes import Mesh, Scene, compile_scene, load_mesh, load_scene, make_scene

__all__ = [
    "Cancellation",
    "Cancelled",
    "Candidate",
    "CompiledScene",
    "EvaluateOptions",
    "Grasp",
    "InputError",
    "Mesh",
    "Outcome",
    "PlanOptions",
    "PlanResult",
    "Scene",
    "__version__",
    "compile_scene",
    "dynamics",
    "evaluate",
    "files",
    "load_mesh",
    "load_scene",
    "make_scene",
    "options",
    "plan",
    "plan_options",
    "planning",
    "quality",
    "results",
    "robots",
    "scenes",
    "validation",
    "write_grasps",
]

show_in(
    __name__,
    Cancellation,
    Cancelled,
    Candidate,
    CompiledScene,
    EvaluateOptions,
    Grasp,
    InputError,
    Mesh,
    Outcome,
    PlanOptions,
    PlanResult,
    Scene,
)

if not typing.TYPE_CHECKING:  # it would accept any name
    _RENAMED = {
        "Blocker": "results.CollisionCount",
        "Burden": "results.LoadCase",
        "Holding": "results.PayloadMargin",
        "OUTCOMES": "Outcome",
        "TruthPart": "validation.ValidationPart",
        "TruthReport": "validation.ValidationReport",
        "TruthScore": "validation.ValidationScore",
        "compile": "compile_scene",
        "step_world": "dynamics.World.step",
        "truth": "validation.compare_executions",
        "write": "write_grasps",
    }

    def __getattr__(name: str) -> typing.NoReturn:
        """Says where a name is that was here in earlier versions."""
        parts = (dynamics, files, options, planning, quality, results, robots, scenes, validation)
        places = [f"{part.__name__}.{name}" for part in parts if name in part.__all__]
        if name in _RENAMED:
            places = [f"prehend.{_RENAMED[name]}"]
        now = f": it is {places[0]} now" if places else ""
        raise AttributeError(f"module 'prehend' has no attribute {name!r}{now}")
