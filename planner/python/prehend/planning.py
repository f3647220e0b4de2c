"""Planning and its steps by themselves: decompose, propose, try, find paths."""

from __future__ import annotations

import copy
import os
from typing import List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._arrays import ArrayLike, as_finite, as_pose
from ._calls import ProgressCallback, call_options
from ._candidates import as_candidates, candidate_fields
from ._core import Progress, TreeModel
from ._errors import InputError
from ._names import show_in
from ._steps import (
    ArmPath,
    Candidate,
    Decomposition,
    Path,
    Primitive,
    Proposals,
    ProposedGrasp,
    Segment,
    SurfaceDistances,
)
from .results import PlanResult, Trial
from .scenes import MeshLike, PathLike, Scene, as_compiled, as_mesh, load_scene

__all__ = [
    "AnyPlan",
    "ArmPath",
    "Candidate",
    "Decomposition",
    "Path",
    "Primitive",
    "Progress",
    "ProposedGrasp",
    "Proposals",
    "Segment",
    "SurfaceDistances",
    "TreeModel",
    "decompose",
    "evaluate",
    "library_test_procedures",
    "load_grasps",
    "load_model",
    "plan",
    "plan_any",
    "plan_arm_path",
    "plan_grasp_path",
    "plan_options",
    "propose_grasps",
    "run_trial",
    "shake_grasps",
]

show_in(
    __name__,
    ArmPath,
    Decomposition,
    Path,
    Primitive,
    Progress,
    ProposedGrasp,
    Proposals,
    Segment,
    SurfaceDistances,
    TreeModel,
)

#: A Scene, one that is compiled already, or what load_scene() or make_scene() make one of: a name of
#: the library, a file, a mesh.
AnyScene = Union[Scene, "_core.CompiledScene", PathLike, MeshLike]


def load_model(file: PathLike) -> TreeModel:
    """A model that was learnt from earlier trials (docs/how-to/learning.md). It orders the candidates of a
    plan with options.search.learned = options.LearnedOrder(model=model).

    Raises:
        InputError: that names the file and what is wrong with it.
    """
    return _core.read_tree_model(os.fsdecode(file))


def plan_options(accuracy: PathLike = "standard") -> "_core.PlanOptions":
    """Options of one accuracy, to be changed further or given to plan().

    Args:
        accuracy: one of options.Accuracy, or a file of settings (docs/reference/accuracy-file.md).

    Raises:
        InputError: for a file that does not exist, or has a setting or a value that does not.
    """
    return _core.plan_options(os.fsdecode(accuracy))


def plan(
    scene: AnyScene,
    options: Optional["_core.PlanOptions"] = None,
    *,
    hand: PathLike = "",
    top: Optional[int] = None,
    threads: int = 0,
    progress: Optional[ProgressCallback] = None,
    seed: Optional[int] = None,
    cancellation: Optional["_core.Cancellation"] = None,
    budget: Optional[float] = None,
) -> PlanResult:
    """Plans grasps of the scene's object and ranks them.

    The same scene, options and seed give the same result, to the byte, on any number of threads.
    Other Python threads run meanwhile.

    Args:
        scene: a Scene, one that is compiled already, or a name, a file or a mesh:
            plan("mug.obj", hand="franka_hand").
        options: what the result depends on; None: PlanOptions().
        hand: in place of the scene's: a name of the library or a robot file; "": the scene's, and
            the barrett hand for a mesh.
        top: how many grasps to return, in place of PlanOptions.rank.top.
        threads: to use; 0: as many as there are processors.
        progress: called with a Progress now and then, in the thread that called. An exception that
            it raises ends the plan and is raised here.
        seed: of everything random, in place of PlanOptions.seed.
        cancellation: ends the plan early once it is requested. Ctrl-C does that as well and raises
            KeyboardInterrupt.
        budget: seconds after which no more work begins; None: no limit. The result has what was
            found until then.

    Returns:
        PlanResult: the grasps, best first, and what became of all other candidates. Its status says
        whether that is all: a plan that was cancelled or ran out of time has what was found until then, and one for an
        object that is too large for the hand has the sizes.

    Raises:
        InputError: paths are wanted of a scene without an arm; as load_scene() and make_scene().
    """
    if seed is not None and seed < 0:
        raise InputError("must be at least 0", field="seed", value=str(seed))
    compiled = as_compiled(scene, hand)
    chosen = copy.deepcopy(_core.PlanOptions() if options is None else options)
    if seed is not None:
        chosen.seed = seed
    if top is not None:
        chosen.rank.top = top
    core = _core.plan(
        compiled,
        chosen,
        call_options(threads, progress, cancellation, budget),
    )
    return PlanResult(core, compiled)


class AnyPlan(NamedTuple):
    """Plans for several objects that stand together."""

    results: List[PlanResult]
    """Of each scene."""
    ranked: List[Tuple[int, int]]
    """Scene and grasp, best first: results[scene][grasp]."""
    first: List[List[str]]
    """Of each scene without a grasp: the other objects that must go before it has one."""


def plan_any(
    scenes: Sequence[AnyScene],
    options: Optional["_core.PlanOptions"] = None,
    *,
    threads: int = 0,
    progress: Optional[ProgressCallback] = None,
    cancellation: Optional["_core.Cancellation"] = None,
    budget: Optional[float] = None,
) -> AnyPlan:
    """Plans grasps of whichever of several objects is easiest, each among the others.

    Args:
        scenes: one for each object, in which the others are obstacles with their names:
            [load_scene(file, object=name) for name in scene_objects(file)].
        options, threads, progress, cancellation, budget: as of plan(), shared by all.

    Raises:
        InputError: as plan(), and for two objects of the same name.
    """
    compiled = [as_compiled(scene) for scene in scenes]
    plans, ranked, first = _core.plan_any(
        compiled,
        _core.PlanOptions() if options is None else options,
        call_options(threads, progress, cancellation, budget),
    )
    results = [PlanResult(core, scene) for core, scene in zip(plans, compiled)]
    return AnyPlan(results, ranked, first)


def evaluate(
    scene: AnyScene,
    grasps: Union[ArrayLike, Sequence[Candidate]],
    *,
    hand: PathLike = "",
    preshape: Union[None, str, Sequence[str]] = None,
    dofs: Optional[ArrayLike] = None,
    options: Optional["_core.EvaluateOptions"] = None,
    threads: int = 0,
    progress: Optional[ProgressCallback] = None,
    cancellation: Optional["_core.Cancellation"] = None,
    budget: Optional[float] = None,
) -> PlanResult:
    """Tries grasps where they are. Nothing is ranked or left out: result i is grasp i.

    Args:
        scene: as of plan().
        grasps: (N, 4, 4), poses of the hand's base in the object's frame, X_OH; or Candidates.
        hand: as of plan().
        preshape: with poses, the name of the opening to start from, one for all or N of them.
            None: the hand's only one.
        dofs: in place of a preshape, (D,) or (N, D): degrees of freedom to start from [rad or m].
        options: what the result depends on; None: EvaluateOptions().
        threads, progress, cancellation, budget: as of plan().

    Raises:
        InputError: for poses that are not rigid, unknown names, values outside the hand's limits.
    """
    compiled = as_compiled(scene, hand)
    core = _core.evaluate(
        compiled,
        as_candidates(compiled.hand, grasps, preshape, dofs),
        _core.EvaluateOptions() if options is None else options,
        call_options(threads, progress, cancellation, budget),
    )
    return PlanResult(core, compiled)


def shake_grasps(
    result: PlanResult,
    procedure: PathLike = "acronym",
    *,
    rank: bool = False,
    threads: int = 0,
    progress: Optional[ProgressCallback] = None,
    cancellation: Optional["_core.Cancellation"] = None,
    budget: Optional[float] = None,
) -> PlanResult:
    """Closes the hand of each grasp in time, lifts the object and shakes it: Grasp.shake.

    Args:
        result: of plan() or evaluate(). It stays as it is.
        procedure: the tests, a name of library_test_procedures() or a file
            (docs/reference/test-procedure-file.md).
        rank: whether grasps that survive more tests come first.
        threads, progress, cancellation, budget: as of plan(). Grasps for which no time was left have
            no ShakeReport, and the status says so.

    Raises:
        InputError: for an unknown procedure, and for a hand or an object that cannot be moved.
    """
    core = _core.shake_grasps(
        result._in_core(),
        os.fsdecode(procedure),
        rank,
        call_options(threads, progress, cancellation, budget),
    )
    return PlanResult(core, result.scene)


def load_grasps(file: PathLike, scene: Optional[AnyScene] = None) -> PlanResult:
    """Reads a grasps.json, of the program or of write_grasps().

    Args:
        scene: the scene that the grasps are of; None: the one that the file names.

    Raises:
        InputError: that names the file, the grasp and the field, also where the file names no scene.
    """
    name = os.fsdecode(file)
    if scene is None:
        asked = _core.scene_of_grasps(name)
        if not asked["scene"]:
            raise InputError("names no scene: pass it as `scene`", field="scene", value=name)
        scene = load_scene(asked.pop("scene"), **asked)
    compiled = as_compiled(scene)
    return PlanResult(_core.load_grasps(compiled, name), compiled)


def library_test_procedures() -> List[str]:
    """Names of the test procedures that come with prehend."""
    return _core.library_test_procedures()


def run_trial(
    scene: AnyScene,
    candidate: Candidate,
    options: Optional["_core.TrialOptions"] = None,
    *,
    cancellation: Optional["_core.Cancellation"] = None,
) -> Trial:
    """Tries one candidate, from its pre-grasp to contacts and quality.

    Raises:
        InputError: for a candidate that is not of this hand.
        Cancelled: once the cancellation is requested.
    """
    compiled = as_compiled(scene)
    fields = _core.run_trial(
        compiled,
        candidate_fields(compiled.hand, candidate),
        _core.TrialOptions() if options is None else options,
        call_options(1, None, cancellation),
    )
    return Trial._of(fields)


def decompose(
    mesh: MeshLike,
    options: Optional["_core.DecomposeOptions"] = None,
    *,
    cancellation: Optional["_core.Cancellation"] = None,
) -> Decomposition:
    """Splits a mesh into the few boxes, spheres and cylinders that explain its surface.

    Raises:
        InputError: for a mesh without area, or with an index or a vertex that cannot be used.
        Cancelled: once the cancellation is requested.
    """
    vertices, faces = as_mesh(mesh)
    fields = _core.decompose(
        vertices,
        faces,
        _core.DecomposeOptions() if options is None else options,
        call_options(1, None, cancellation),
    )
    return Decomposition._of(fields)


def propose_grasps(
    scene: AnyScene,
    primitives: Optional[Sequence[Primitive]] = None,
    options: Optional["_core.CandidateOptions"] = None,
    *,
    count: int = 800,
    cancellation: Optional["_core.Cancellation"] = None,
) -> Proposals:
    """Where a hand should be tried.

    Args:
        scene: a Scene, or one that is compiled already.
        primitives: of the object; None: those that the scene gives, else those of decompose().
        options: None: CandidateOptions().
        count: how many; the sequence of candidates, coarse to fine, has no end.

    Raises:
        InputError: for a primitive without a size.
        Cancelled: once the cancellation is requested.
    """
    compiled = as_compiled(scene)
    if primitives is None:
        given = [Primitive(**fields) for fields in _core.given_primitives(compiled)]
        primitives = given or decompose(compiled.object, cancellation=cancellation).primitives
    fields = _core.propose_grasps(
        compiled,
        [_primitive_fields(primitive) for primitive in primitives],
        count,
        _core.CandidateOptions() if options is None else options,
        call_options(1, None, cancellation),
    )
    grasps: List[ProposedGrasp] = [
        ProposedGrasp(Candidate(**candidate), primitive, rule)
        for candidate, primitive, rule in fields["grasps"]
    ]
    return Proposals(grasps, fields["smallest_width"], fields["largest_opening"])


def plan_grasp_path(
    grasp: Trial,
    options: Optional["_core.GraspPathOptions"] = None,
    *,
    cancellation: Optional["_core.Cancellation"] = None,
) -> Optional[Path]:
    """The arm's whole way to a grasp: from its start, collision-free, timed within the limits of its
    joints, checked twice. None where there is none.

    Args:
        grasp: a stable one of a scene with an arm.
        options: None: GraspPathOptions().

    Raises:
        InputError: for a grasp that does not hold or that no arm reaches.
        Cancelled: once the cancellation is requested.
    """
    if grasp.arm_dofs is None:
        raise InputError("no arm reaches it", field="grasp")
    if not grasp.stable:
        raise InputError("does not hold", field="grasp", value=grasp.outcome)
    fields = _core.plan_grasp_path(
        grasp._in_core(),
        _core.GraspPathOptions() if options is None else options,
        call_options(1, None, cancellation),
    )
    return None if fields is None else Path._of(fields)


def plan_arm_path(
    scene: AnyScene,
    dofs: Optional[ArrayLike] = None,
    X_WH: Optional[ArrayLike] = None,
    options: Optional["_core.GraspPathOptions"] = None,
    *,
    straight: bool = False,
    cancellation: Optional["_core.Cancellation"] = None,
) -> ArmPath:
    """The motion of an arm from where the scene starts to a posture, or to one that has the hand at
    a pose. The hand keeps its joints.

    Args:
        scene: one with an arm.
        dofs: all degrees of freedom of the platform at the goal [rad or m].
        X_WH: 4 x 4, of the hand's base in the world, in place of dofs.
        options: None: GraspPathOptions().
        straight: the hand moves to X_WH in a straight line, turning at a constant rate.

    Raises:
        InputError: for a scene without an arm, unless one of dofs and X_WH is given, and for
            straight without X_WH.
        Cancelled: once the cancellation is requested.
    """
    compiled = as_compiled(scene)
    robot = compiled.robot
    if robot is None:
        raise InputError("has no arm", field="scene")
    if (dofs is None) == (X_WH is None):
        raise InputError("one of dofs and X_WH is needed", field="dofs")
    if straight and X_WH is None:
        raise InputError("needs X_WH", field="straight")
    goals = [] if dofs is None else [as_finite(dofs, "dofs", (len(robot.dofs),))]
    fields = _core.plan_arm_path(
        compiled,
        goals,
        None if X_WH is None else as_pose(X_WH, "X_WH"),
        straight,
        _core.GraspPathOptions() if options is None else options,
        call_options(1, None, cancellation),
    )
    path = None if fields["path"] is None else Path._of(fields["path"])
    return ArmPath(fields["end"], fields["why"], path, fields["relative_length"])


def _primitive_fields(primitive: Primitive) -> "dict[str, object]":
    """What the planner takes. Raises InputError for a size that is missing or not positive."""
    fields: "dict[str, object]" = {
        "shape": primitive.shape,
        "X_OP": as_pose(primitive.X_OP, "X_OP"),
    }
    if primitive.shape in ("rim", "bar"):
        return {**fields, **_curve_fields(primitive)}
    sizes = {
        "box": ["size"],
        "sphere": ["radius"],
        "cylinder": ["radius", "height"],
        "cone": ["radius_low", "radius_high", "height"],
    }
    for name in sizes.get(primitive.shape, []):
        value = getattr(primitive, name)
        if value is None:
            raise InputError(f"a {primitive.shape} needs it", field=name)
        array = as_finite(value, name, (3,) if name == "size" else ())
        tip = primitive.shape == "cone" and name != "height"
        if not ((array > 0.0).all() or (tip and float(array) == 0.0)):
            raise InputError("must be positive", field=name, value=str(value))
        fields[name] = array if name == "size" else float(array)
    return fields


def _curve_fields(curve: Primitive) -> "dict[str, object]":
    """Those of a rim or a bar, beside its shape and pose."""
    if curve.points is None:
        raise InputError(f"a {curve.shape} needs them", field="points")
    points = np.ascontiguousarray(curve.points, dtype=float)
    if points.ndim != 2 or points.shape[0] < 2 or points.shape[1] != 3:
        raise InputError("must be (n, 3), n at least 2", field="points", value=str(points.shape))
    fields: "dict[str, object]" = {
        "points": as_finite(points, "points", points.shape),
        "closed": bool(curve.closed),
    }
    is_rim = curve.shape == "rim"
    for name in ["width", "depth"] if is_rim else ["width"]:
        value = getattr(curve, name)
        if value is None or not float(as_finite(value, name, ())) > 0.0:
            raise InputError("must be positive", field=name, value=str(value))
        fields[name] = float(value)
    for name in ["into", "across"] if is_rim else []:
        value = getattr(curve, name)
        if value is None:
            raise InputError("a rim needs them", field=name)
        array = as_finite(value, name, points.shape)
        length = np.linalg.norm(array, axis=1, keepdims=True)
        if not (length > 0.0).all():
            raise InputError("must not be zero", field=name)
        fields[name] = array / length
    return fields
