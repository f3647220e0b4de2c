"""What trials and plans return: plain values with NumPy arrays that own their memory."""

from __future__ import annotations

import copy
from dataclasses import dataclass, field, fields as fields_of
from functools import cached_property
from typing import Any, Callable, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Type, TypeVar, cast

import numpy as np

from . import _core, _notebook
from ._errors import InputError
from ._arrays import FloatArray, IntArray
from ._core import (
    ContactModel,
    EpsilonStatus,
    Hint,
    LiftEnd,
    Outcome,
    PlanCount,
    PlanStatus,
    Stage,
)
from ._names import show_in
from ._steps import Candidate, Decomposition, Path, Primitive

__all__ = [
    "Advice",
    "CollisionCount",
    "Contact",
    "ContactModel",
    "Contacts",
    "EpsilonStatus",
    "FirstSlip",
    "FreeClosing",
    "FreeEnd",
    "Grasp",
    "HeldByPads",
    "HeldShapes",
    "Hint",
    "LiftEnd",
    "LoadCase",
    "Outcome",
    "PadPatch",
    "PayloadMargin",
    "PhaseReport",
    "PlanCount",
    "PlanResult",
    "PlanStatus",
    "Refinement",
    "Robustness",
    "RuleCount",
    "ShakeReport",
    "ShakeTestReport",
    "Stage",
    "StageCount",
    "Trial",
    "Tried",
]

show_in(__name__, ContactModel, EpsilonStatus, Hint, LiftEnd, PlanCount, PlanStatus, Stage)


Kind = TypeVar("Kind")


def _made(kind: Type[Kind], values: Dict[str, Any]) -> Kind:
    """An object of a dataclass from its fields among the values; others have no place in it."""
    return kind(**{one.name: values[one.name] for one in fields_of(kind)})


class Contact(NamedTuple):
    """A point where a link of the hand touches the object, in the object's frame O."""

    position: FloatArray
    """(3,) [m]."""
    normal: FloatArray
    """(3,): unit, into the object."""
    friction: float
    """Coefficient."""
    torsion: float
    """Soft fingers: largest torque about the normal over largest friction force; suction cups: radius
    of the lip [m]; else 0."""
    moment: float
    """Suction cups: largest tilting torque over the force of the vacuum [m]; else 0."""
    vacuum: float
    """Suction cups: force of the vacuum [N]; else 0."""
    gap: float
    """Between link and object [m]."""
    model: ContactModel
    """What it can exert."""
    link: str
    """Name of the link."""
    seen: Optional[bool]
    """Of an object that was seen in part: whether a camera saw the surface there; None of others."""


@dataclass(frozen=True, eq=False)
class Contacts(Sequence[Contact]):
    """Contacts of one or several grasps, as arrays; a sequence of Contact as well."""

    positions: FloatArray
    """(M, 3), object's frame [m]."""
    normals: FloatArray
    """(M, 3): unit, into the object."""
    friction: FloatArray
    """(M,): coefficients."""
    torsion: FloatArray
    """(M,) [m]."""
    moment: FloatArray
    """(M,) [m]."""
    vacuum: FloatArray
    """(M,) [N]."""
    gap: FloatArray
    """(M,) [m]."""
    models: List[ContactModel]
    """M contact models."""
    links: List[str]
    """M names of links."""
    seen: List[Optional[bool]]
    """M times: whether a camera saw the surface there; None of an object whose surface is known."""
    grasps: IntArray
    """(M,): the number of the grasp that each contact belongs to."""

    def __len__(self) -> int:
        return len(self.links)

    def __getitem__(self, i: Any) -> Any:
        if isinstance(i, slice):
            return [self[k] for k in range(*i.indices(len(self)))]
        return Contact(
            self.positions[i],
            self.normals[i],
            float(self.friction[i]),
            float(self.torsion[i]),
            float(self.moment[i]),
            float(self.vacuum[i]),
            float(self.gap[i]),
            self.models[i],
            self.links[i],
            self.seen[i],
        )

    def __iter__(self) -> Iterator[Contact]:
        return (self[i] for i in range(len(self)))

    def __repr__(self) -> str:
        return f"<{len(self)} contacts>"

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "Contacts":
        fields["models"] = [ContactModel(model) for model in fields["models"]]
        return Contacts(**fields, grasps=np.zeros(len(fields["links"]), dtype=np.intc))

    @staticmethod
    def _joined(parts: Sequence["Contacts"]) -> "Contacts":
        def rows(name: str, columns: Tuple[int, ...]) -> FloatArray:
            arrays = [getattr(part, name) for part in parts]
            return np.concatenate(arrays) if arrays else np.zeros((0, *columns))

        return Contacts(
            rows("positions", (3,)),
            rows("normals", (3,)),
            rows("friction", ()),
            rows("torsion", ()),
            rows("moment", ()),
            rows("vacuum", ()),
            rows("gap", ()),
            [model for part in parts for model in part.models],
            [link for part in parts for link in part.links],
            [seen for part in parts for seen in part.seen],
            np.repeat(np.arange(len(parts), dtype=np.intc), [len(part) for part in parts]),
        )


@dataclass(frozen=True, eq=False)
class Trial:
    """What became of one candidate."""

    outcome: Outcome
    """Outcome.stable if the grasp holds, else why it does not."""
    epsilon: float
    """Smallest disturbance that breaks the grasp, a lower bound; 0 unless it holds."""
    preferred: bool = field(repr=False)
    """Whether it holds and touches preferred regions of the object only."""
    epsilon_upper: float
    """Upper bound of the same."""
    epsilon_status: EpsilonStatus
    """How the search for epsilon ended."""
    weakest_wrench: FloatArray = field(repr=False)
    """(6,): the disturbance that it resists least, [force; torque * torque_scale]."""
    X_OH: FloatArray = field(repr=False)
    """(4, 4): the hand's base in the object's frame."""
    X_WH: FloatArray = field(repr=False)
    """(4, 4): and in the world's."""
    approach: FloatArray = field(repr=False)
    """(3,): unit, object's frame: the hand came this way."""
    travel: float = field(repr=False)
    """Length of the approach until the grasp [m]."""
    gave_way: FloatArray = field(repr=False)
    """(3,): by this the hand moved at first, out of a small overlap, object's frame [m]."""
    back_offs: int = field(repr=False)
    """How often the hand went back and closed again."""
    pushed: FloatArray = field(repr=False)
    """(3,): the finger that touched first pushed the object by this, object's frame [m]."""
    turned: float = field(repr=False)
    """By this the object turned between the fingers [rad]."""
    slid: float = field(repr=False)
    """And by this its centre of mass moved there [m]."""
    preshape: Optional[str]
    """The opening that the hand came with; None where it has no name."""
    dofs: FloatArray = field(repr=False)
    """(D,): degrees of freedom of the closed hand [rad or m]."""
    joints: FloatArray = field(repr=False)
    """(J,): its joints [rad or m]."""
    arm_dofs: Optional[FloatArray] = field(repr=False)
    """Degrees of freedom of arm and hand at the grasp, the hand as it starts; None without an arm."""
    contacts: Contacts
    """Where the hand touches the object."""
    blocked_link: Optional[str]
    """The link that was blocked, for outcomes that end in _blocked."""
    blocked_by: Optional[str]
    """The object, obstacle or link that blocked it."""
    overlap: Optional[float]
    """Of hand_blocked: how far the hand would have to move to overlap nothing [m].

    None if farther than 20 mm, and in plans, which leave such grasps out.
    """
    candidate: Candidate = field(repr=False)
    """What was tried."""
    _trial: Optional["_core._Trial"] = field(repr=False)

    @property
    def stable(self) -> bool:
        """Whether the grasp holds."""
        return self.outcome is Outcome.stable

    # A pickle has the values. What C++ keeps for pictures and paths is of one process.
    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "_trial": None}

    def __copy__(self: Kind) -> Kind:
        return cast(Kind, _copy(self))

    def __deepcopy__(self: Kind, memo: Dict[int, Any]) -> Kind:
        return cast(Kind, _deep_copy(self, memo, "_trial"))

    def _in_core(self) -> "_core._Trial":
        if self._trial is None:
            raise InputError(
                "was unpickled, which brings its values alone; try its candidate again with run_trial()",
                field="grasp",
            )
        return self._trial

    @classmethod
    def _of(cls: Type[Kind], fields: Dict[str, Any]) -> Kind:
        fields["outcome"] = Outcome(fields["outcome"])
        fields["epsilon_status"] = EpsilonStatus(fields["epsilon_status"])
        fields["contacts"] = Contacts._of(fields["contacts"])
        fields["candidate"] = Candidate(**fields["candidate"])
        return _made(cls, fields)

    def _repr_html_(self) -> str:
        return _notebook.trial_html(self)


def _copy(value: Any) -> Any:
    copied = object.__new__(type(value))
    copied.__dict__.update(value.__dict__)
    return copied


def _deep_copy(value: Any, memo: Dict[int, Any], *shared: str) -> Any:
    """A deep copy but for the attributes `shared`, which do not change."""
    copied = _copy(value)
    memo[id(value)] = copied
    for name, part in value.__dict__.items():
        copied.__dict__[name] = part if name in shared else copy.deepcopy(part, memo)
    return copied


def _by_outcome(counts: Dict[str, int]) -> Dict[Outcome, int]:
    return {Outcome(outcome): count for outcome, count in counts.items()}


@dataclass(frozen=True, eq=False)
class LoadCase:
    """What it takes to hold the object's weight in one attitude."""

    down: FloatArray = field(repr=False)
    """(3,): where gravity pulls, unit, object's frame."""
    sum_of_normals: float
    """The smallest sum of normal forces that balances the weight, inf where none do [N]."""
    largest_normal: float
    """The smallest largest normal force that does [N]."""
    strength: float
    """How many times the weight the drives hold with the efforts in the robot's file; 0 where no
    forces balance it, inf where it loads no drive whose effort is known."""


@dataclass(frozen=True, eq=False)
class PayloadMargin:
    """What a grasp's weight takes: in the attitude of the scene and in the worst of 42."""

    given: LoadCase
    """As the object lies in the scene."""
    worst: LoadCase
    """In the attitude with the largest sum of normal forces."""

    @property
    def holds(self) -> bool:
        """Whether the drives hold the weight as the object lies."""
        return self.given.strength >= 1.0


class FreeEnd(NamedTuple):
    """How a hand that closed on an object that is free to move ended."""

    kept: bool
    """Whether the object is in the hand."""
    epsilon: float
    """Where the object ended; 0 where it is lost."""
    strength: float
    """So many times the weight the drives hold there; 0 where it is lost."""
    moved: float
    """How far the object's centre of mass moved [m]."""


@dataclass(frozen=True, eq=False)
class Robustness:
    """How a grasp fares with errors of pose, friction and centre of mass (UncertaintyOptions)."""

    samples: int
    """Trials that were made."""
    held: int
    """In so many of them the hand closed on the object and holds its weight."""
    interval: Tuple[float, float]
    """Contains the true share with a probability of 90 %."""
    epsilon_mean: float
    """Mean epsilon of the trials."""
    epsilon_low: float
    """At most a tenth of the trials have less."""
    outcomes: Dict[Outcome, int] = field(repr=False)
    """How many trials ended with each outcome."""
    spare: float
    """The object may be off by this along any axis of the hand, of 0, 1, 2.5, 5 and 10 mm [m]."""
    weakest: FloatArray = field(repr=False)
    """(3,): the direction in which it may be off the least, object's frame; 0: none."""
    weakest_outcome: Outcome = field(repr=False)
    """How a trial ends that is farther off that way; stable: the drives do not hold the weight."""
    strength: float
    """So many times the weight the drives hold without errors; of a hand that is blocked or misses
    the object then, in the first trial in which it closes."""
    free: Optional[FreeEnd]
    """How it ends there on an object that is free to move; None where that was not tried."""
    success: float
    """Probability that it lifts the object, as of grasps that were carried out in simulation."""

    @property
    def probability(self) -> float:
        """Share of the trials that held."""
        return self.held / self.samples

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "Robustness":
        fields["outcomes"] = _by_outcome(fields["outcomes"])
        fields["weakest_outcome"] = Outcome(fields["weakest_outcome"])
        free = fields["free"]
        if free is not None:
            fields["free"] = FreeEnd(**free)
        return _made(Robustness, fields)


class Refinement(NamedTuple):
    """What the refinement of a grasp took and gave."""

    gain: float
    """By how much its objective is larger than before."""
    trials: int
    """That were made for it."""


@dataclass(frozen=True, eq=False)
class FreeClosing:
    """How a grasp ends on an object that is free to move while the hand closes."""

    outcome: Outcome
    """What became of the object; stable or not_force_closure: it is in the hand."""
    epsilon: float
    """Where the object ends; 0 without force closure."""
    X_OH: FloatArray = field(repr=False)
    """(4, 4): pose of the hand's base in the frame of the object, where that ends."""
    X_OC: FloatArray = field(repr=False)
    """(4, 4): where the object ends, in the frame in which it stood."""
    joints: FloatArray = field(repr=False)
    """(J,): of the closed hand [rad or m]."""

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "FreeClosing":
        fields["outcome"] = Outcome(fields["outcome"])
        return _made(FreeClosing, fields)


@dataclass(frozen=True, eq=False)
class PadPatch:
    """Where a pad of finite elements bears on the object, in the object's frame O."""

    link: str
    nodes: int
    """How many of the pad bear."""
    approach: float
    """Of the pad's base from where the pad first touches [m]."""
    load: float
    """Along `normal` [N]."""
    center: FloatArray = field(repr=False)
    """(3,): of pressure [m]."""
    normal: FloatArray = field(repr=False)
    """(3,): unit, into the object."""
    torsion: float
    """Largest torque about the normal over friction and load [m]."""
    fitted_torsion: float
    """Of the ellipsoid nearest to the limit surface [m]."""
    fit_error: float
    """Farthest that the limit surface lies from it, as a part of it."""


@dataclass(frozen=True, eq=False)
class HeldByPads:
    """What the pads of a grasp do together."""

    softest: float
    """Stiffness of the softest motion of the object while everything sticks [N/m]."""
    patches: List[PadPatch]

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "HeldByPads":
        return HeldByPads(
            fields["softest"], [_made(PadPatch, patch) for patch in fields["patches"]]
        )


class PhaseReport(NamedTuple):
    """What happened during a phase of a test. The object moves relative to the hand."""

    kind: str
    """Such as "lift" or "shake" (docs/reference/test-procedure-file.md)."""
    seconds: float
    """That it took [s]."""
    moved: float
    """Farthest [m]."""
    turned: float
    """Farthest [rad]."""
    sank: float
    """Lowest in the world below where it began [m]."""
    rose: float
    """At the end, above where it began [m]."""
    touching: int
    """Links that touch the object at the end."""


class FirstSlip(NamedTuple):
    """The contact that was the first to slide."""

    link: str
    time: float
    """Since the test began [s]."""


class ShakeTestReport(NamedTuple):
    """How one test ended."""

    name: str
    """Of the test; "prepare" before all tests."""
    outcome: str
    """ "survived", or why not, such as "dropped"."""
    failed_at: Optional[float]
    """Since the test began [s]; None where it survived."""
    first_slip: Optional[FirstSlip]
    largest_pull: Optional[float]
    """What its growing pulls reached before it failed [m/s^2]; None without such a phase."""
    phases: List[PhaseReport]

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "ShakeTestReport":
        slip = fields["first_slip"]
        fields["first_slip"] = None if slip is None else FirstSlip(**slip)
        fields["phases"] = [PhaseReport(**phase) for phase in fields["phases"]]
        return ShakeTestReport(**fields)


@dataclass(frozen=True)
class ShakeReport:
    """What became of a grasp that was closed, lifted and shaken."""

    procedure: str
    """Name of the test procedure."""
    survived: int
    """How many tests it survived, without the preparation."""
    of: int
    """How many there are."""
    holds: bool
    """All, after a preparation that did not fail."""
    largest_pull: Optional[float]
    """The largest disturbance survived, in the weakest test [m/s^2]; None without such a test."""
    tests: List[ShakeTestReport] = field(repr=False)

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "ShakeReport":
        fields["tests"] = [ShakeTestReport._of(test) for test in fields["tests"]]
        return _made(ShakeReport, fields)


@dataclass(frozen=True)
class HeldShapes:
    """On which shapes an object that was seen in part may have a grasp holds."""

    likely: bool
    """The completed one."""
    thin: Optional[bool]
    """The least that it may be; None where that was not tried."""
    thick: Optional[bool]
    """The most."""
    unseen: float
    """Part of the hand's way to the grasp, 0 to 1, that lies behind what the cameras saw."""
    certainty: float
    """How firmly it holds on all of them, and with the hand 3 mm beside, less for what is unseen:
    grasps are ranked by it."""


@dataclass(frozen=True, eq=False)
class Grasp(Trial):
    """A trial as a plan returns it."""

    volume: float
    """Of the hull of the wrenches that the grasp can exert; 0 without force closure, NaN where the
    plan was cancelled before."""
    epsilon_nearby: Optional[Tuple[float, float]]
    """Of a stable grasp: the least and the largest epsilon with the hand moved by next to nothing
    or the contact threshold changed by 10 %; None where the volume was not computed."""
    holding: Optional[PayloadMargin] = field(repr=False)
    """What its weight takes; None without contacts and where the volume was not computed."""
    pads: Optional[HeldByPads] = field(repr=False)
    """Of contacts by finite elements; None of others and where the volume was not computed."""
    robustness: Optional[Robustness] = field(repr=False)
    """How it fares with errors of the pose; None where that was not asked for."""
    free: Optional[FreeClosing] = field(repr=False)
    """How it ends on an object that is free to move; None where that was not asked for."""
    shake: Optional[ShakeReport] = field(repr=False)
    """What planning.shake_grasps() showed; None where it was not shaken."""
    shapes: Optional[HeldShapes]
    """Of an object that was seen in part; None of others, and where time ran out."""
    primitive: Optional[int]
    """Number of the primitive that it came from; None for a grasp that was given."""
    rule: str
    """Which rule of the primitive; "given" for a grasp that was given."""
    refinement: Optional[Refinement]
    """Of a grasp that was refined: what that gained, and the trials it took."""
    path: Optional[Path] = field(repr=False)
    """The arm's way to it, where that was asked for."""

    @classmethod
    def _of(cls: Type[Kind], fields: Dict[str, Any]) -> Kind:
        path = fields["path"]
        fields["path"] = None if path is None else Path._of(path)
        holding = fields["holding"]
        if holding is not None:
            fields["holding"] = PayloadMargin(
                LoadCase(**holding["given"]), LoadCase(**holding["worst"])
            )
        pads = fields["pads"]
        if pads is not None:
            fields["pads"] = HeldByPads._of(pads)
        robustness = fields["robustness"]
        if robustness is not None:
            fields["robustness"] = Robustness._of(robustness)
        free = fields["free"]
        if free is not None:
            fields["free"] = FreeClosing._of(free)
        shake = fields["shake"]
        if shake is not None:
            fields["shake"] = ShakeReport._of(shake)
        shapes = fields["shapes"]
        if shapes is not None:
            fields["shapes"] = _made(HeldShapes, shapes)
        refinement = fields["refinement"]
        if refinement is not None:
            fields["refinement"] = Refinement(*refinement)
        return super()._of(fields)


@dataclass(frozen=True)
class CollisionCount:
    """How many candidates ended in `outcome` because `link` met `by`."""

    outcome: Outcome
    link: str
    by: str
    count: int


@dataclass(frozen=True)
class StageCount:
    """What a stage of a plan makes and how many came out of it."""

    what: PlanCount
    count: int


class Advice(NamedTuple):
    """Something that may help where a plan found no grasp."""

    hint: Hint
    """What may help."""
    words: str
    """What to change and why, with the option of the program or the field of the scene file."""


class RuleCount(NamedTuple):
    """How the candidates of one rule ended."""

    rule: str
    outcomes: Dict[Outcome, int]


class Tried(NamedTuple):
    """All candidates that were tried, in the order they were made."""

    candidates: IntArray
    """(N,): the place of each among those that were proposed or given."""
    poses: FloatArray
    """(N, 4, 4): where the approach was to end, the hand in the object's frame."""
    approach: FloatArray
    """(N, 3): unit, object's frame."""
    outcomes: List[Outcome]
    """N outcomes."""

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "Tried":
        fields["outcomes"] = [Outcome(outcome) for outcome in fields["outcomes"]]
        return Tried(**fields)


_UNPICKLED = (
    "was unpickled, which brings its values alone; keep its scene, or write_grasps() and load_grasps()"
)


class PlanResult:
    """What plan() and evaluate() return. A sequence of its grasps: len(result), result[0], ..."""

    def __init__(self, core: "_core._PlanResult", scene: "_core.CompiledScene") -> None:
        self._core: Optional["_core._PlanResult"] = core
        self._scene: Optional["_core.CompiledScene"] = scene
        fields = core.fields()
        self.grasps: List[Grasp] = [Grasp._of(core.grasp(i)) for i in range(fields["count"])]
        """plan(): best first; evaluate(): as given."""
        self.status: PlanStatus = PlanStatus(fields["status"])
        """How the call ended."""
        self.reason: str = fields["words"]
        """Why nothing could be tried, in one line; "" where something was."""
        self.advice: List[Advice] = [
            Advice(Hint(hint), words) for hint, words in fields["advice"]
        ]
        """Of plan() without a grasp: what may help."""
        self.rules: List[RuleCount] = [
            RuleCount(rule, _by_outcome(outcomes)) for rule, outcomes in fields["rules"]
        ]
        """Of plan() without a grasp: how the candidates of each rule ended."""
        self.untested: int = fields["untested"]
        """Candidates that a call which was cancelled or ran out of time left untried."""
        self.families: int = fields["ways"]
        """Of plan(): families of grasps, each a rule of a primitive with a preshape and a depth."""
        self.families_untested: int = fields["ways_untested"]
        """Of plan(): how many of them no trial has looked at."""
        self.smallest_width: float = fields["smallest_width"]
        """Of plan(): smallest size that a rule wanted to close on [m]."""
        self.largest_opening: float = fields["largest_opening"]
        """Of plan(): largest size that an opening of the hand takes [m]."""
        self.outcomes: Dict[Outcome, int] = _by_outcome(fields["outcomes"])
        """How many candidates ended how."""
        self.blockers: List[CollisionCount] = [
            CollisionCount(Outcome(outcome), *of) for outcome, *of in fields["blockers"]
        ]
        """What was in the way, most often first."""
        self.stages: List[StageCount] = [
            StageCount(PlanCount(what), count) for what, count in fields["stages"]
        ]
        """What came out of each stage."""
        self.seconds: Dict[Stage, float] = {
            Stage(stage): seconds for stage, seconds in fields["seconds"].items()
        }
        """How long each stage took [s]."""
        self.primitives: List[Primitive] = [Primitive(**one) for one in fields["primitives"]]
        """The object's, which Grasp.primitive counts."""
        solids = fields["solids"]
        self.solids: Optional[Decomposition] = Decomposition._of(solids) if solids else None
        """Of plan(): the first of `primitives`, and how far the surface is from them. None where the
        scene states the primitives."""
        self.tried: Tried = Tried._of(fields["tried"])
        """All candidates."""

    def __len__(self) -> int:
        return len(self.grasps)

    def __getitem__(self, i: int) -> Grasp:
        return self.grasps[i]

    def __iter__(self) -> Iterator[Grasp]:
        return iter(self.grasps)

    def __repr__(self) -> str:
        best = f", best epsilon {self.grasps[0].epsilon:.4f}" if self.grasps else ""
        return f"<prehend.PlanResult, {self.status}: {len(self)} grasps of {sum(self.outcomes.values())} tried{best}>"

    @property
    def scene(self) -> "_core.CompiledScene":
        """What was planned for.

        Raises:
            InputError: the result was unpickled.
        """
        if self._scene is None:
            raise InputError(_UNPICKLED, field="result")
        return self._scene

    def _in_core(self) -> "_core._PlanResult":
        if self._core is None:
            raise InputError(_UNPICKLED, field="result")
        return self._core

    # As of Trial.
    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "_core": None, "_scene": None}

    def __copy__(self) -> "PlanResult":
        return cast(PlanResult, _copy(self))

    def __deepcopy__(self, memo: Dict[int, Any]) -> "PlanResult":
        return cast(PlanResult, _deep_copy(self, memo, "_core", "_scene"))

    def where(self, keep: Callable[[Grasp], object]) -> "PlanResult":
        """A result that has only the grasps for which `keep` is true, in the same order."""
        kept = [i for i, grasp in enumerate(self.grasps) if keep(grasp)]
        if self._core is not None:
            return PlanResult(_core.with_grasps(self._core, kept), self.scene)
        fewer: PlanResult = _copy(self)
        for name, value in vars(PlanResult).items():
            if isinstance(value, cached_property):
                fewer.__dict__.pop(name, None)
        fewer.grasps = [self.grasps[i] for i in kept]
        return fewer

    def _repr_html_(self) -> str:
        return _notebook.plan_html(self)

    def _array(self, name: str, shape: Tuple[int, ...] = ()) -> FloatArray:
        rows = [getattr(grasp, name) for grasp in self.grasps]
        return np.array(rows, dtype=np.float64).reshape((len(rows), *shape))

    @cached_property
    def poses(self) -> FloatArray:
        """(N, 4, 4): the hand's base in the object's frame, X_OH, for each grasp."""
        return self._array("X_OH", (4, 4))

    @cached_property
    def world_poses(self) -> FloatArray:
        """(N, 4, 4): and in the world's frame, X_WH."""
        return self._array("X_WH", (4, 4))

    @cached_property
    def epsilon(self) -> FloatArray:
        """(N,): smallest disturbance that breaks each grasp."""
        return self._array("epsilon")

    @cached_property
    def volume(self) -> FloatArray:
        """(N,): volumes of their wrench hulls."""
        return self._array("volume")

    @cached_property
    def dofs(self) -> FloatArray:
        """(N, D): degrees of freedom of the closed hands [rad or m]."""
        return self._array("dofs", (len(self.scene.hand.dofs),))

    @cached_property
    def joints(self) -> FloatArray:
        """(N, J): joints of the closed hands [rad or m]."""
        return self._array("joints", (len(self.scene.hand.joints),))

    @cached_property
    def contacts(self) -> List[Contacts]:
        """The contacts of each grasp."""
        return [grasp.contacts for grasp in self.grasps]

    @cached_property
    def flat_contacts(self) -> Contacts:
        """All of them one after the other, M in all; `grasps` says whose each is."""
        return Contacts._joined(self.contacts)
