"""Robots by name, where their frames are, and what brings them there."""

from __future__ import annotations

import os
from typing import List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._arrays import ArrayLike, FloatArray, as_finite, as_pose
from ._core import IkOptions, Robot
from ._errors import InputError
from ._names import show_in
from .scenes import Mesh, PathLike

__all__ = [
    "IkOptions",
    "IkTarget",
    "Robot",
    "find_platform",
    "find_robot",
    "joint_poses",
    "joint_values",
    "library_platform_names",
    "library_robot_names",
    "link_mesh",
    "link_poses",
    "preshapes",
    "solve_all",
    "solve_near",
]

show_in(__name__, Robot)

#: A Robot, or the name of one.
RobotLike = Union[str, "_core.Robot"]


class IkTarget(NamedTuple):
    """A frame fixed to a robot, and where it should be."""

    X_BT: ArrayLike
    """(4, 4): where it should be, in the robot's base frame."""
    joint: Union[None, int, str] = None
    """It is fixed to the frame after this joint, by number or name; None: Robot.tip_joint."""
    X_JT: Optional[ArrayLike] = None
    """(4, 4): there; None: at that frame."""


def find_robot(name_or_file: PathLike) -> "_core.Robot":
    """A robot of the library by name ("barrett"), or a robot file.

    Raises:
        InputError: that lists the names when it is neither.
    """
    return _core.find_robot(os.fsencode(name_or_file))


def find_platform(name_or_file: PathLike) -> "_core.Robot":
    """Robots on robots, as the one robot that they are together: its joints are called ROBOT/NAME.

    Raises:
        InputError: that lists the names when it is neither of the library nor a file.
    """
    return _core.find_platform(os.fsencode(name_or_file))


def library_robot_names() -> List[str]:
    """Names of the robots that come with prehend."""
    return _core.library_robot_names()


def library_platform_names() -> List[str]:
    """Names of the platforms, robots on robots, that come with prehend."""
    return _core.library_platform_names()


def as_robot(robot: RobotLike) -> "_core.Robot":
    """A robot as it is; a name looked up among robots and platforms."""
    if not isinstance(robot, str):
        return robot
    return find_platform(robot) if robot in library_platform_names() else find_robot(robot)


def link_mesh(robot: "_core.Robot", link: str) -> Mesh:
    """The mesh of a robot's link, in the link's frame [m]."""
    if link not in robot.links:
        raise InputError(f"not one of {', '.join(robot.links)}", field="link", value=link)
    return Mesh(*robot._link_mesh(robot.links.index(link)))


def joint_values(robot: RobotLike, dofs: ArrayLike) -> FloatArray:
    """(J,): the values of all joints for (D,) degrees of freedom [rad or m]."""
    body = as_robot(robot)
    return body._joint_values(as_finite(dofs, "dofs", (len(body.dofs),)))


def joint_poses(robot: RobotLike, joints: ArrayLike) -> FloatArray:
    """(J, 4, 4): the frame after each joint in the robot's base frame, for (J,) joint values."""
    body = as_robot(robot)
    return body._joint_poses(as_finite(joints, "joints", (len(body.joints),)))


def link_poses(robot: RobotLike, joints: ArrayLike) -> FloatArray:
    """(L, 4, 4): each link in the robot's base frame, for (J,) joint values [rad or m]."""
    body = as_robot(robot)
    return body._link_poses(as_finite(joints, "joints", (len(body.joints),)))


def preshapes(hand: RobotLike) -> List[str]:
    """Names of the openings of a hand from which grasps start."""
    return [preshape[0] for preshape in as_robot(hand)._preshapes]


def joint_number(robot: "_core.Robot", joint: Union[None, int, str]) -> int:
    if joint is None:
        joint = robot.tip_joint
    if isinstance(joint, str):
        if joint not in robot.joints:
            raise InputError(f"not one of {', '.join(robot.joints)}", field="joint", value=joint)
        return robot.joints.index(joint)
    if not 0 <= joint < len(robot.joints):
        raise InputError(f"must be below {len(robot.joints)}", field="joint", value=str(joint))
    return int(joint)


_Arguments = Tuple[
    "_core.Robot", List[int], FloatArray, FloatArray, FloatArray, "_core.IkOptions"
]


def _arguments(
    robot: RobotLike,
    target: Union[ArrayLike, IkTarget, Sequence[IkTarget]],
    start: Optional[ArrayLike],
    options: Optional["_core.IkOptions"],
) -> _Arguments:
    body = as_robot(robot)
    targets: Sequence[IkTarget]
    if isinstance(target, IkTarget):
        targets = [target]
    elif isinstance(target, (list, tuple)) and target and isinstance(target[0], IkTarget):
        targets = target
    else:
        targets = [IkTarget(target)]
    numbers = [joint_number(body, one.joint) for one in targets]
    in_joint = [np.eye(4) if one.X_JT is None else as_pose(one.X_JT, "X_JT") for one in targets]
    in_base = [as_pose(one.X_BT, "X_BT") for one in targets]
    first = body.initial if start is None else as_finite(start, "start", (len(body.dofs),))
    chosen = _core.IkOptions() if options is None else options
    return body, numbers, np.array(in_joint), np.array(in_base), first, chosen


def solve_near(
    robot: RobotLike,
    target: Union[ArrayLike, IkTarget, Sequence[IkTarget]],
    start: Optional[ArrayLike] = None,
    options: Optional["_core.IkOptions"] = None,
) -> Optional[FloatArray]:
    """Inverse kinematics from one start, inside the limits.

    Args:
        robot: a Robot or the name of one, or of a platform.
        target: (4, 4), where the robot's tip should be in its base frame; or IkTargets, all to be
            met at once.
        start: (D,): where to start from; None: Robot.initial [rad or m].
        options: None: IkOptions().

    Returns:
        (D,): degrees of freedom [rad or m]; None where the search does not arrive.
    """
    return _core.solve_near(*_arguments(robot, target, start, options))


def solve_all(
    robot: RobotLike,
    target: Union[ArrayLike, IkTarget, Sequence[IkTarget]],
    start: Optional[ArrayLike] = None,
    options: Optional["_core.IkOptions"] = None,
) -> FloatArray:
    """Different solutions of inverse kinematics, (S, D), the one nearest to `start` first.

    All branches where a closed form is known, else found from random starts, which are seeded.
    Arguments as of solve_near().
    """
    return _core.solve_all(*_arguments(robot, target, start, options))
