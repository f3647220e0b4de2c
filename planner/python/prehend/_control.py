"""Controllers: functions from the state of a robot to the efforts of its degrees of freedom."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, List, Mapping, NamedTuple, Optional, Union

from . import _core
from ._arrays import ArrayLike, FloatArray, as_finite, as_pose
from ._core import ControlOutcome
from ._errors import InputError
from ._steps import Path
from ._world import RobotOfWorld, World, WorldRobot, number_of_robot
from .robots import RobotLike, as_robot, joint_number

#: A controller of prehend, or any function of a ControlState that returns the efforts (D,).
ControllerLike = Union["_core.Controller", Callable[["_core.ControlState"], ArrayLike]]
#: Values (D,) to stay at, a Motion, or any function of the time that returns such values.
MotionLike = Union[ArrayLike, "_core.Motion", Callable[[float], ArrayLike]]


class PdGains(NamedTuple):
    """Gains of the degrees of freedom, >= 0."""

    stiffness: FloatArray
    """(D,) [N m/rad or N/m]."""
    damping: FloatArray
    """(D,) [N m s/rad or N s/m]."""


@dataclass(frozen=True)
class ControlledRun:
    """How a run ended. The world is as it was then."""

    outcome: ControlOutcome
    """finished: its time is over; stopped: by its watcher; not_a_number: a controller answered with
    an effort that is none; wrong_size: or with another number of them; blocked, not_finite: a step
    ended so."""
    time: float
    """That was run [s]."""
    steps: int
    """How many."""
    not_converged: int
    """Steps that ended so."""
    why: str
    """Of a run that a controller ended: what it answered, of which robot and when; else ""."""


def critically_damped(robot: WorldRobot, frequency: float) -> PdGains:
    """Gains with which each degree of freedom, the others held still, settles without overshoot at
    the frequency [Hz], for the inertia that it moves in the robot's posture."""
    return PdGains(*_core.critically_damped(robot._core, robot._index, frequency))


def stated_gains(robot: WorldRobot, frequency: float = 3.0) -> PdGains:
    """The gains that the robot's file states. A stiffness that it does not state is the one with which
    the degree of freedom settles at the frequency [Hz], a damping that it does not state the critical
    one, for the inertia that is moved in the robot's posture."""
    return PdGains(*_core.stated_gains(robot._core, robot._index, frequency))


def set_points(robot: RobotLike, preshape: str = "") -> FloatArray:
    """(D,): a posture that the robot's file names, a preshape of a hand; "": where it starts."""
    return _core.set_points(as_robot(robot), preshape)


def pd_drives(robot: WorldRobot, gains: PdGains, values: ArrayLike) -> List["_core.Drive"]:
    """Drives that hold the degrees of freedom at the values (D,), up to WorldRobot.max_efforts. Unlike
    a pd_controller, which is sampled, they are stable at any gain."""
    return _core.pd_drives(
        robot._core, robot._index, *_gains(robot, *gains), _values(robot, values, "values")
    )


def _values(robot: WorldRobot, values: ArrayLike, name: str) -> FloatArray:
    return as_finite(values, name, (len(robot.dofs),))


def _gains(robot: WorldRobot, stiffness: ArrayLike, damping: ArrayLike) -> "tuple[FloatArray, FloatArray]":
    return _values(robot, stiffness, "stiffness"), _values(robot, damping, "damping")


def _motion(robot: WorldRobot, motion: MotionLike) -> object:
    return motion if callable(motion) else _values(robot, motion, "motion")


def pd_controller(robot: WorldRobot, gains: PdGains, motion: MotionLike) -> "_core.Controller":
    """Feedback: stiffness (motion - position) + damping (rate of the motion - rate).

    It is sampled: at steps of h [s] it is stable for damping * h below twice the inertia that is
    moved. By itself it lags behind what gravity and inertia ask for; sum_of() adds
    gravity_compensation().

    Args:
        robot: that it is for.
        gains: (D,) each, >= 0: critically_damped(), stated_gains(), or any pair.
        motion: what it follows: values (D,) to stay at, or a function of the time [s].
    """
    return _core.pd_controller(
        robot._core, robot._index, *_gains(robot, *gains), _motion(robot, motion)
    )


def gravity_compensation() -> "_core.Controller":
    """The efforts that hold a robot where it is, against gravity and the springs of its joints."""
    return _core.gravity_compensation()


def computed_torque(
    robot: WorldRobot, motion: MotionLike, frequency: float = 3.0
) -> "_core.Controller":
    """The efforts that give the robot the accelerations of the motion and, where it has left it, those
    of a critically damped return at the frequency [Hz]. Friction in joints is not compensated."""
    return _core.computed_torque(robot._core, robot._index, _motion(robot, motion), frequency)


def wrist_impedance(
    robot: WorldRobot,
    X_WT: ArrayLike,
    *,
    joint: Union[None, int, str] = None,
    stiffness: float = 1000.0,
    turning_stiffness: float = 10.0,
    damping_ratio: float = 1.0,
) -> "_core.Controller":
    """Holds a frame of the robot at a pose in the world as springs would: a force F moves it by
    F / stiffness. Gravity is compensated.

    Args:
        robot: that it is for.
        X_WT: (4, 4), where the frame should be.
        joint: the frame after this one, by number or name; None: Robot.tip_joint.
        stiffness: the same along all axes, >= 0 [N/m].
        turning_stiffness: >= 0 [N m/rad].
        damping_ratio: >= 0; 1: it returns without overshoot.
    """
    return _core.wrist_impedance(
        robot._core,
        robot._index,
        joint_number(robot.robot, joint),
        as_pose(X_WT, "X_WT"),
        stiffness,
        turning_stiffness,
        damping_ratio,
    )


def sum_of(*controllers: ControllerLike) -> "_core.Controller":
    """A controller whose efforts are the sum of those of others, as feed-forward and feedback are."""
    return _core.sum_of(list(controllers))


def motion_along(robot: WorldRobot, path: Path, rest: Optional[ArrayLike] = None) -> "_core.Motion":
    """The motion of a robot along a path, whose joints are names of degrees of freedom; those that it
    does not name stay at `rest` (D,), without it where they are now. Before its first sample and after
    its last the motion stands still."""
    return _core.motion_along(
        robot._core,
        robot._index,
        path.joints,
        path.times,
        path.positions,
        path.velocities,
        robot.positions if rest is None else _values(robot, rest, "rest"),
    )


def run_controlled(
    world: World,
    controllers: Union[Mapping[RobotOfWorld, ControllerLike], ControllerLike],
    *,
    seconds: float = 1.0,
    step: float = 2.5e-3,
    stops: Optional[Callable[[float, World], bool]] = None,
    cancellation: Optional["_core.Cancellation"] = None,
) -> ControlledRun:
    """Asks each controller at the beginning of each step and moves the world on with its efforts, which
    are limited to those that the robot's joints state. Robots without a controller move as their
    drives say.

        def hold(state):
            return 40.0 * (goal - state.positions) - 8.0 * state.rates

        controller = dynamics.sum_of(dynamics.gravity_compensation(), hold)
        dynamics.run_controlled(world, {arm: controller})

    Functions are called in the thread that called, with the GIL; between them the world moves without
    it. An exception that one raises ends the run and is passed on.

    Args:
        world: is moved.
        controllers: by robot (a WorldRobot, its number or name), or one for the world's only robot.
        seconds: how long, >= 0.
        step: the longest, 1e-5 to 0.1 [s].
        stops: asked after each step with the time since the run began [s] and the world; the run ends
            where it says so.
        cancellation: to end it from another thread.

    Raises:
        InputError: for a world that cannot be stepped, and a controller whose answer is no row of
            numbers.
        Cancelled: once the cancellation is requested.
    """
    by_robot = controllers if isinstance(controllers, Mapping) else {_only_robot(world): controllers}
    numbered = {number_of_robot(world, robot): one for robot, one in by_robot.items()}
    asked = None if stops is None else (lambda now: stops(now, world))
    outcome, time, steps, not_converged, why = _core.run_controlled(
        world._core, list(numbered.items()), float(seconds), float(step), asked, cancellation
    )
    return ControlledRun(ControlOutcome(outcome), time, steps, not_converged, why)


def _only_robot(world: World) -> int:
    number_of_robot(world, 0)
    if len(world.robots) > 1:
        raise InputError(
            "must say which robot each is for", field="controllers", value=f"{len(world.robots)}"
        )
    return 0
