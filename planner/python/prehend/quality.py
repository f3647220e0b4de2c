"""How well contacts hold an object: contacts in, numbers out, without a scene or a hand.

Contacts are arrays: positions (N, 3) [m], normals (N, 3), unit and into the object, and friction, one
coefficient or (N,). Each function judges one grasp and returns a number, or many grasps at once, on all
processors and without the GIL, and returns an array (G,):

    epsilon(positions, normals, 0.5)                    # (N, 3): one grasp, a float
    epsilon(positions, normals, 0.5)                    # (G, N, 3): G grasps, an array
    epsilon([first, second], [normals_1, normals_2], 0.5)   # of different numbers of contacts
    epsilon(grasp.contacts), epsilon(result.contacts)   # of a plan

Wrenches are [force; torque * torque_scale], torques about torque_origin. With torque_scale = 1 / r, r
the object's largest distance from the origin, forces and torques weigh alike and numbers of objects of
different sizes compare; CompiledScene.torque_scale has it for a scene.

Source of the definitions: Ferrari and Canny, ICRA 1992; docs/reference/contacts-file.md has the rest.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._arrays import ArrayLike, FloatArray, as_floats
from ._calls import call_options
from ._core import (
    ContactModel,
    EpsilonOptions,
    EpsilonStatus,
    ForceOptions,
    ForceOutcome,
    NoiseOptions,
    SetHullOptions,
    WrenchSpaceOptions,
)
from ._errors import InputError
from ._names import show_in
from .results import Contacts

__all__ = [
    "ContactForces",
    "ContactModel",
    "EpsilonBracket",
    "EpsilonOptions",
    "EpsilonStatus",
    "ForceOptions",
    "ForceOutcome",
    "Interval",
    "NoiseOptions",
    "RobustEpsilon",
    "SetHullOptions",
    "Task",
    "WrenchSpaceOptions",
    "balancing_forces",
    "contact_wrenches",
    "epsilon",
    "epsilon_bracket",
    "force_closure",
    "grasp_matrix",
    "isotropy",
    "measure",
    "measures",
    "object_wrench_ratio",
    "robust_epsilon",
    "smallest_singular_value",
    "task_resistance",
    "volume",
    "wrench_resistance",
]

show_in(
    __name__, EpsilonOptions, ForceOptions, ForceOutcome, SetHullOptions, WrenchSpaceOptions
)

_MODELS = list(ContactModel)

#: A number for one grasp, an array (G,) for G grasps: the arguments decide which, in a way that types
#: cannot say.
Number = Any
#: Contacts of one grasp (N, 3) or of several: (G, N, 3), or a list of (N, 3).
ContactsLike = Union[ArrayLike, Contacts, Sequence[Contacts]]


class Interval(NamedTuple):
    """A number that is known to lie between two others; arrays (G,) for G grasps."""

    lower: Any
    upper: Any


class EpsilonBracket(NamedTuple):
    """lower <= epsilon <= upper; both 0 without force closure. Arrays for G grasps."""

    lower: Any
    upper: Any
    status: Any
    """EpsilonStatus: how the search ended."""
    weakest: Any
    """(6,) or (G, 6): the disturbance that is resisted least."""


class RobustEpsilon(NamedTuple):
    """Epsilon over samples of noise; arrays (G,) for G grasps."""

    mean: Any
    percentile_5: Any
    """The smallest value that at least 5 % of the samples do not exceed."""
    force_closure: Any
    """Part of the samples that have it."""


@dataclass(frozen=True, eq=False)
class ContactForces:
    """Forces that balance a wrench; in its unit of force."""

    outcome: ForceOutcome
    """impossible: proved; limit: rounding allows neither."""
    components: FloatArray = field(repr=False)
    """(N, 4): normal force, along the first and second tangent, torque about the normal."""
    forces: FloatArray = field(repr=False)
    """(N, 3): the force on the object, in the axes of the contacts."""
    largest_normal: float
    sum_of_normals: float
    residual: float
    """What is left over, relative to the wrench."""
    lowest: float
    """No forces have a smaller measure than this: proved."""
    gap: float
    """(measure - lowest) / measure."""
    separating: FloatArray = field(repr=False)
    """(6,): impossible: every contact's forces, and the wrench, have a power >= 0 with it."""


@dataclass(frozen=True, eq=False)
class Task:
    """Disturbances that a grasp has to resist; make one with the functions below."""

    kind: str
    numbers: FloatArray

    @staticmethod
    def wrenches(wrenches: ArrayLike) -> "Task":
        """Any of (W, 6) wrenches, and what lies between them."""
        return Task("wrenches", as_floats(wrenches, "wrenches", ("W", 6)))

    @staticmethod
    def ellipsoid(axes: ArrayLike) -> "Task":
        """All wrenches axes @ u with |u| <= 1; axes (6, 6), independent."""
        return Task("ellipsoid", as_floats(axes, "axes", (6, 6)))

    @staticmethod
    def gravity(direction: ArrayLike = (0.0, 0.0, -1.0), weight: float = 1.0) -> "Task":
        """The weight of the object, in units of the normal force (> 0), pulling along (3,)."""
        along = as_floats(direction, "direction", (3,))
        return Task("gravity", np.append(along, float(weight))[np.newaxis])


class _Sets(NamedTuple):
    core: "_core._ContactSets"
    grasps: int
    batch: bool


def _is_batch(positions: Any) -> bool:
    if isinstance(positions, Contacts):
        return False
    if isinstance(positions, (list, tuple)):
        return bool(positions) and (
            isinstance(positions[0], Contacts) or np.ndim(positions[0]) == 2
        )
    return np.ndim(positions) == 3


def _per_contact(value: Any, name: str, sizes: List[int], batch: bool) -> FloatArray:
    """(M,): one number for all contacts, for each contact of each grasp, or for each grasp's."""
    if np.ndim(value) == 0 and not isinstance(value, (list, tuple)):
        return np.full(sum(sizes), float(value))
    if not batch:
        return as_floats(value, name, (sizes[0],))
    if len(value) != len(sizes):
        raise InputError(f"must be one number or for {len(sizes)} grasps", field=name)
    rows = [
        np.full(size, float(row)) if np.ndim(row) == 0 else as_floats(row, f"{name}[{g}]", (size,))
        for g, (row, size) in enumerate(zip(value, sizes))
    ]
    return np.concatenate(rows) if rows else np.zeros(0)


def _models(model: Optional[str], torsion: FloatArray) -> List[int]:
    if model is None:
        return [2 if radius > 0.0 else 1 for radius in torsion]
    if model == ContactModel.suction:
        raise InputError("suction cups are contacts of a grasp", field="model", value=model)
    if model not in _MODELS:
        raise InputError(f"not one of {', '.join(_MODELS)}", field="model", value=model)
    return [_MODELS.index(ContactModel(model))] * len(torsion)


def _sets(
    positions: Any,
    normals: Any,
    friction: Any,
    torsion: Any,
    model: Optional[str],
    torque_origin: ArrayLike,
    torque_scale: ArrayLike,
) -> _Sets:
    """The contacts of all grasps. Raises InputError that names the argument and its shape."""
    batch = _is_batch(positions)
    numbers: Optional[List[int]] = None
    if isinstance(positions, Contacts) or (
        batch and isinstance(positions, (list, tuple)) and isinstance(positions[0], Contacts)
    ):
        if normals is not None or friction is not None or torsion is not None:
            raise InputError("the contacts have their own", field="normals, friction, torsion")
        given = [positions] if isinstance(positions, Contacts) else list(positions)
        points = [contacts.positions for contacts in given]
        directions = [contacts.normals for contacts in given]
        sizes = [len(contacts) for contacts in given]
        mu = np.concatenate([contacts.friction for contacts in given])
        radius = np.concatenate([contacts.torsion for contacts in given])
        moment = np.concatenate([contacts.moment for contacts in given])
        vacuum = np.concatenate([contacts.vacuum for contacts in given])
        if model is None:
            numbers = [_MODELS.index(one) for contacts in given for one in contacts.models]
    else:
        if normals is None or friction is None:
            raise InputError("missing", field="normals" if normals is None else "friction")
        if batch:
            if len(normals) != len(positions):
                raise InputError(f"must be for {len(positions)} grasps", field="normals")
            points = [
                as_floats(one, f"positions[{g}]", ("N", 3)) for g, one in enumerate(positions)
            ]
            directions = [
                as_floats(one, f"normals[{g}]", (len(points[g]), 3))
                for g, one in enumerate(normals)
            ]
        else:
            points = [as_floats(positions, "positions", ("N", 3))]
            directions = [as_floats(normals, "normals", (len(points[0]), 3))]
        sizes = [len(one) for one in points]
        mu = _per_contact(friction, "friction", sizes, batch)
        radius = _per_contact(0.0 if torsion is None else torsion, "torsion", sizes, batch)
        moment = vacuum = np.zeros(len(radius))
    count = len(sizes)
    origins = as_floats(
        torque_origin, "torque_origin", (3,) if np.ndim(torque_origin) < 2 else (count, 3)
    )
    scales = as_floats(
        torque_scale, "torque_scale", () if np.ndim(torque_scale) == 0 else (count,)
    )
    core = _core._ContactSets(
        np.concatenate(points) if points else np.zeros((0, 3)),
        np.concatenate(directions) if directions else np.zeros((0, 3)),
        mu,
        radius,
        moment,
        vacuum,
        numbers if numbers is not None else _models(model, radius),
        [0, *np.cumsum(sizes, dtype=int).tolist()],
        np.ascontiguousarray(np.broadcast_to(origins, (count, 3))),
        np.ascontiguousarray(np.broadcast_to(scales, (count,))),
    )
    return _Sets(core, count, batch)


def _one_or_all(sets: _Sets, values: Any) -> Any:
    """An array as it is for a batch; its only entry, as a Python number, for one grasp."""
    if sets.batch:
        return values
    value = values[0]
    return value.item() if isinstance(value, np.generic) else value


def epsilon_bracket(
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    *,
    torsion: Optional[ArrayLike] = None,
    model: Optional[str] = None,
    torque_origin: ArrayLike = (0.0, 0.0, 0.0),
    torque_scale: ArrayLike = 1.0,
    space: Optional[WrenchSpaceOptions] = None,
    options: Optional[EpsilonOptions] = None,
    threads: int = 0,
) -> EpsilonBracket:
    """Bounds of epsilon: the largest ball around the origin in the set of wrenches that the contacts
    can exert with unit forces, which is the smallest disturbance that breaks the grasp.

    Args:
        positions: (N, 3), or (G, N, 3) or a list of (N, 3) for many grasps [m]; or Contacts, or a list
            of them, which have all that follows up to `model`.
        normals: as positions: unit, into the object.
        friction: coefficient(s) >= 0: one number, (N,), or for many grasps (G, N) or a list.
        torsion: soft fingers: largest torque about the normal over largest friction force [m].
        model: a ContactModel, for all contacts; None: soft fingers where there is torsion, else points.
        torque_origin: (3,) or (G, 3): torques are about this point [m].
        torque_scale: one number or (G,): torques are multiplied by it [1/m].
        space: the set; None: WrenchSpaceOptions().
        options: None: what suits the set.
        threads: for many grasps; 0: as many as there are processors.

    Raises:
        InputError: arrays of other shapes, numbers that are not finite, normals that are not unit,
            negative friction.
    """
    sets = _sets(positions, normals, friction, torsion, model, torque_origin, torque_scale)
    found = _core.quality_epsilon(
        sets.core, space or WrenchSpaceOptions(), options, call_options(threads, None, None)
    )
    return EpsilonBracket(
        _one_or_all(sets, found["lower"]),
        _one_or_all(sets, found["upper"]),
        _one_or_all(sets, [EpsilonStatus(status) for status in found["status"]]),
        _one_or_all(sets, found["weakest"]),
    )


def epsilon(
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    **options: Any,
) -> Number:
    """Epsilon, from below: epsilon_bracket().lower, with the same arguments."""
    return epsilon_bracket(positions, normals, friction, **options).lower


def measures() -> List[str]:
    """Names of all measures that measure() knows."""
    return _core.quality_measures()


def measure(
    name: str,
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    *,
    torsion: Optional[ArrayLike] = None,
    model: Optional[str] = None,
    torque_origin: ArrayLike = (0.0, 0.0, 0.0),
    torque_scale: ArrayLike = 1.0,
    space: Optional[WrenchSpaceOptions] = None,
    options: Optional[EpsilonOptions] = None,
    hull: Optional[SetHullOptions] = None,
    noise: Optional[NoiseOptions] = None,
    task: Optional[Task] = None,
    surface: Optional[Tuple[ArrayLike, ArrayLike, ArrayLike]] = None,
    jacobian: Optional[ArrayLike] = None,
    threads: int = 0,
) -> Interval:
    """A measure by its name. Both ends are equal for what is computed directly.

    Args:
        name: of measures().
        positions, normals, friction, torsion, model, torque_origin, torque_scale, space, options,
            threads: as of epsilon_bracket().
        hull: of the volume; None: SetHullOptions().
        noise: of the robust measures; None: NoiseOptions().
        task: of task_resistance.
        surface: of object_wrench_ratio: (positions, normals, friction) of contacts all over the object.
        jacobian: of manipulability: (rows, J), velocities at the contacts for joint velocities.

    Raises:
        InputError: as epsilon_bracket(), for an unknown name, and where an argument is missing that
            the measure cannot do without.
    """
    sets = _sets(positions, normals, friction, torsion, model, torque_origin, torque_scale)
    over = (
        _sets(*surface, None, None, (0.0, 0.0, 0.0), 1.0)
        if surface is not None
        else _sets([], [], 0.0, None, None, (0.0, 0.0, 0.0), 1.0)
    )
    chosen = _core._MeasureOptions(
        space or WrenchSpaceOptions(),
        options,
        hull or SetHullOptions(),
        noise or NoiseOptions(),
        ("", np.zeros((0, 0))) if task is None else (task.kind, task.numbers),
        over.core,
        None if jacobian is None else as_floats(jacobian, "jacobian", ("rows", "J")),
    )
    lower, upper = _core.quality_measure(
        sets.core, name, chosen, call_options(threads, None, None)
    )
    return Interval(_one_or_all(sets, lower), _one_or_all(sets, upper))


def volume(
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    **options: Any,
) -> Number:
    """Volume of the set of wrenches, from below; arguments as of measure()."""
    return measure("volume", positions, normals, friction, **options).lower


def force_closure(
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    **options: Any,
) -> Any:
    """Whether the contacts can resist any disturbance, proved; a bool, or an array (G,) of them.
    Arguments as of epsilon_bracket()."""
    lower = epsilon_bracket(positions, normals, friction, **options).lower
    return lower > 0.0


def smallest_singular_value(
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    **options: Any,
) -> Number:
    """Of the grasp matrix (Li and Sastry 1988); arguments as of measure()."""
    name = "smallest_singular_value"
    return measure(name, positions, normals, friction, **options).lower


def isotropy(
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    **options: Any,
) -> Number:
    """Smallest over largest singular value of the grasp matrix, 0 to 1; arguments as of measure()."""
    return measure("isotropy", positions, normals, friction, **options).lower


def task_resistance(
    task: Task,
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    **options: Any,
) -> Interval:
    """The largest k such that k times every wrench of the task is resisted with unit forces."""
    return measure("task_resistance", positions, normals, friction, task=task, **options)


def object_wrench_ratio(
    surface: Tuple[ArrayLike, ArrayLike, ArrayLike],
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    **options: Any,
) -> Interval:
    """Resistance to a unit force anywhere on the object (Pollard 1994); `surface` as of measure()."""
    return measure("object_wrench_ratio", positions, normals, friction, surface=surface, **options)


def robust_epsilon(
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    *,
    torsion: Optional[ArrayLike] = None,
    model: Optional[str] = None,
    torque_origin: ArrayLike = (0.0, 0.0, 0.0),
    torque_scale: ArrayLike = 1.0,
    space: Optional[WrenchSpaceOptions] = None,
    noise: Optional[NoiseOptions] = None,
    threads: int = 0,
) -> RobustEpsilon:
    """How epsilon fares when contacts are not quite where they were thought to be (Weisz and Allen
    2012). Seeded; arguments as of epsilon_bracket(), noise: None: NoiseOptions()."""
    sets = _sets(positions, normals, friction, torsion, model, torque_origin, torque_scale)
    found = _core.quality_robust_epsilon(
        sets.core,
        space or WrenchSpaceOptions(),
        noise or NoiseOptions(),
        call_options(threads, None, None),
    )
    return RobustEpsilon(*(_one_or_all(sets, np.ascontiguousarray(found[:, c])) for c in range(3)))


def _externals(sets: _Sets, external: ArrayLike) -> FloatArray:
    one = np.ndim(external) == 1
    rows = as_floats(external, "external", (6,) if one else (sets.grasps, 6))
    return np.ascontiguousarray(np.broadcast_to(rows, (sets.grasps, 6)))


def balancing_forces(
    external: ArrayLike,
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    *,
    torsion: Optional[ArrayLike] = None,
    model: Optional[str] = None,
    torque_origin: ArrayLike = (0.0, 0.0, 0.0),
    torque_scale: ArrayLike = 1.0,
    options: Optional[ForceOptions] = None,
    threads: int = 0,
) -> Any:
    """The smallest contact forces that add up to zero with an external wrench.

    Args:
        external: (6,), or (G, 6) for many grasps: [force; torque * torque_scale], in N for forces in N.
        options: None: ForceOptions(). The rest as of epsilon_bracket().

    Source: Boyd and Wegbreit 2007.
    """
    sets = _sets(positions, normals, friction, torsion, model, torque_origin, torque_scale)
    found = _core.quality_balancing_forces(
        sets.core,
        _externals(sets, external),
        options or ForceOptions(),
        call_options(threads, None, None),
    )
    forces = [
        ContactForces(ForceOutcome(fields.pop("outcome")), **fields) for fields in found
    ]
    return forces if sets.batch else forces[0]


def wrench_resistance(
    external: ArrayLike,
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    *,
    torsion: Optional[ArrayLike] = None,
    model: Optional[str] = None,
    torque_origin: ArrayLike = (0.0, 0.0, 0.0),
    torque_scale: ArrayLike = 1.0,
    options: Optional[ForceOptions] = None,
    threads: int = 0,
) -> Interval:
    """The largest k for which forces of measure at most 1 balance k times the external wrench;
    arguments as of balancing_forces()."""
    sets = _sets(positions, normals, friction, torsion, model, torque_origin, torque_scale)
    lower, upper = _core.quality_wrench_resistance(
        sets.core,
        _externals(sets, external),
        options or ForceOptions(),
        call_options(threads, None, None),
    )
    return Interval(_one_or_all(sets, lower), _one_or_all(sets, upper))


def grasp_matrix(
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    *,
    torsion: Optional[ArrayLike] = None,
    model: Optional[str] = None,
    torque_origin: ArrayLike = (0.0, 0.0, 0.0),
    torque_scale: ArrayLike = 1.0,
) -> FloatArray:
    """(6, k): the map from the contact forces of one grasp to its wrench; columns are 1 for a
    frictionless contact, 3 for a point, 4 for a soft finger. Arguments as of epsilon_bracket()."""
    sets = _sets(positions, normals, friction, torsion, model, torque_origin, torque_scale)
    if sets.batch:
        raise InputError("takes one grasp", field="positions")
    return _core.quality_grasp_matrix(sets.core, 0)


def contact_wrenches(
    positions: ContactsLike,
    normals: Optional[ArrayLike] = None,
    friction: Optional[ArrayLike] = None,
    *,
    edges: int = 8,
    torsion: Optional[ArrayLike] = None,
    model: Optional[str] = None,
    torque_origin: ArrayLike = (0.0, 0.0, 0.0),
    torque_scale: ArrayLike = 1.0,
) -> FloatArray:
    """(K, 6): the corners of the contacts' friction cones, as pyramids of so many edges (>= 3), as
    wrenches. Their hull is the L1 wrench space. Arguments as of epsilon_bracket(), for one grasp."""
    sets = _sets(positions, normals, friction, torsion, model, torque_origin, torque_scale)
    if sets.batch:
        raise InputError("takes one grasp", field="positions")
    return _core.quality_contact_wrenches(sets.core, 0, edges)

