"""What the steps of a plan take and return: plain values with NumPy arrays that own their memory."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, List, NamedTuple, Optional

from ._arrays import FloatArray
from ._core import LiftEnd


class Segment(NamedTuple):
    """A named stretch of a path: samples first .. last, both included."""

    name: str
    """"preshape", "transfer", "approach", "close", "lift" or "retreat"."""
    first: int
    last: int


@dataclass(frozen=True, eq=False)
class Path:
    """A motion of named joints in time: between two samples, the cubic that their positions and
    velocities determine."""

    joints: List[str]
    """Names of the J joints."""
    times: FloatArray
    """(T,): from 0, increasing [s]."""
    positions: FloatArray = field(repr=False)
    """(T, J) [rad or m]."""
    velocities: FloatArray = field(repr=False)
    """(T, J) [rad/s or m/s]."""
    segments: List[Segment]
    """In order; neighbours share a sample."""
    lift: LiftEnd
    """Whether it goes on after the grasp, or why not."""

    @property
    def duration(self) -> float:
        """[s]."""
        return float(self.times[-1])

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "Path":
        segments = [Segment(*segment) for segment in fields.pop("segments")]
        lift = LiftEnd(fields.pop("lift"))
        return Path(**fields, segments=segments, lift=lift)


@dataclass(frozen=True, eq=False)
class ArmPath:
    """A path of an arm without a grasp, or why there is none."""

    end: str
    """"found", "unreachable", "beyond_limits", "goal_collides", "not_found" (the search ended after
    its iterations) or "refused" (by the second check); of a straight line also "line_jumps" (a
    singular posture) and "line_blocked" (something collides on the way)."""
    why: str
    """Which bodies meet, or which limit is passed; empty where there is nothing to say."""
    path: Optional[Path]
    """None where none was found."""
    relative_length: float
    """Of the way in the joints, over that of the straight line; 0 without a path."""


@dataclass(frozen=True, eq=False)
class Primitive:
    """A solid or a curve that stands for a piece of an object."""

    shape: str
    """"box", "sphere", "cylinder", "cone", "rim" or "bar"."""
    X_OP: FloatArray
    """(4, 4): its pose in the object's frame; the axis of a cylinder or cone is its z."""
    size: Optional[FloatArray] = None
    """(3,): of a box [m]."""
    radius: Optional[float] = None
    """Of a sphere or cylinder [m]."""
    height: Optional[float] = None
    """Of a cylinder or cone [m]."""
    radius_low: Optional[float] = None
    """Of a cone, at its lower end along z [m]."""
    radius_high: Optional[float] = None
    """Of a cone, at its upper end along z [m]."""
    points: Optional[FloatArray] = None
    """(n, 3): of a rim, along its edge; of a bar, along its middle [m]."""
    into: Optional[FloatArray] = None
    """(n, 3): of a rim, for each point the unit direction from the edge into the wall."""
    across: Optional[FloatArray] = None
    """(n, 3): of a rim, for each point the unit normal of the wall."""
    width: Optional[float] = None
    """Thickness of the wall of a rim, largest size of a bar across [m]."""
    depth: Optional[float] = None
    """How far the wall of a rim goes on behind its edge [m]."""
    closed: Optional[bool] = None
    """Of a rim or bar: whether the last point is followed by the first."""


class SurfaceDistances(NamedTuple):
    """Of distances of surface points from the primitive nearest to each [m]."""

    median: float
    percentile_95: float
    largest: float


@dataclass(frozen=True, eq=False)
class Decomposition:
    """The primitives that explain an object's surface."""

    primitives: List[Primitive]
    """The one that explains most area first."""
    share: FloatArray
    """For each, the fraction of the area that it explains."""
    explained: float
    """Fraction of the area within tolerance of some primitive."""
    tolerance: float
    """DecomposeOptions.tolerance as a length [m]."""
    distances: SurfaceDistances
    """Of the whole surface."""
    distances_of: List[SurfaceDistances] = field(repr=False)
    """For each primitive, of the surface that is nearest to it; 0 where there is none."""

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "Decomposition":
        fields["primitives"] = [Primitive(**primitive) for primitive in fields["primitives"]]
        fields["distances"] = SurfaceDistances(*fields["distances"])
        fields["distances_of"] = [SurfaceDistances(*one) for one in fields["distances_of"]]
        return Decomposition(**fields)


@dataclass(frozen=True, eq=False)
class Candidate:
    """Where a hand is tried: a pose, the way it comes, and how far its fingers are open.

    One of `preshape` and `dofs` says how the hand starts. Where both are None, the hand's only
    preshape is meant, if it has just one.
    """

    X_OH: FloatArray
    """(4, 4): the hand's base in the object's frame, where the approach ends if nothing is touched."""
    approach: Optional[FloatArray] = None
    """(3,): unit, object's frame: the way the hand moves. None: along the hand's own approach axis."""
    approach_distance: float = 0.0
    """From the pre-grasp to X_OH; 0: the hand is there [m]."""
    preshape: Optional[str] = None
    """Name of an opening of the hand."""
    dofs: Optional[FloatArray] = None
    """(D,): values of the hand's degrees of freedom [rad or m]."""
    joints: Optional[FloatArray] = None
    """(J,): of its joints, where they are not as the degrees of freedom say [rad or m]."""
    strategy: Optional[str] = None
    """Name of a strategy of the hand, by which it closes on an object that gives way.

    None: all at once.
    """


class ProposedGrasp(NamedTuple):
    """A candidate and where it came from."""

    candidate: Candidate
    primitive: int
    """Number of the primitive."""
    rule: str
    """"box faces", "cylinder side, thumb across", ..."""


@dataclass(frozen=True, eq=False)
class Proposals:
    """The candidates for an object and a hand."""

    grasps: List[ProposedGrasp]
    smallest_width: float
    """Smallest size that a rule wanted to close on; infinite without a rule [m]."""
    largest_opening: float
    """Largest size that a preshape takes [m]."""

    @property
    def candidates(self) -> List[Candidate]:
        """The candidates alone."""
        return [grasp.candidate for grasp in self.grasps]
