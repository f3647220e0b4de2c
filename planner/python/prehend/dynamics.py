"""Worlds of bodies and robots that move through time, and controllers of the robots (docs/reference/dynamics.md)."""

from __future__ import annotations

from ._control import (
    ControlledRun,
    ControllerLike,
    MotionLike,
    PdGains,
    computed_torque,
    critically_damped,
    gravity_compensation,
    motion_along,
    pd_controller,
    pd_drives,
    run_controlled,
    set_points,
    stated_gains,
    sum_of,
    wrist_impedance,
)
from ._core import Controller, ControlOutcome, ControlState, Drive, Motion, StepOutcome
from ._names import show_in
from ._world import StepResult, World, WorldBody, WorldContact, WorldRobot

__all__ = [
    "ControlOutcome",
    "ControlState",
    "ControlledRun",
    "Controller",
    "ControllerLike",
    "Drive",
    "Motion",
    "MotionLike",
    "PdGains",
    "StepOutcome",
    "StepResult",
    "World",
    "WorldBody",
    "WorldContact",
    "WorldRobot",
    "computed_torque",
    "critically_damped",
    "gravity_compensation",
    "motion_along",
    "pd_controller",
    "pd_drives",
    "run_controlled",
    "set_points",
    "stated_gains",
    "sum_of",
    "wrist_impedance",
]

show_in(
    __name__,
    ControlOutcome,
    ControlState,
    ControlledRun,
    Controller,
    Drive,
    Motion,
    PdGains,
    StepOutcome,
    StepResult,
    World,
    WorldBody,
    WorldContact,
    WorldRobot,
)
