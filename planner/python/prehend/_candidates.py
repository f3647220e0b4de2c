"""Candidates as callers give them, checked against the hand that they are for."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence, Union

import numpy as np

from . import _core
from ._arrays import ArrayLike, FloatArray, as_finite, as_pose, as_poses
from ._errors import InputError
from ._steps import Candidate

#: Values outside the limits by less than this are rounding: they are brought inside [rad or m].
_LIMIT_TOLERANCE = 1e-6


def _preshape_number(hand: "_core.Robot", name: Optional[str]) -> int:
    names = [preshape[0] for preshape in hand._preshapes]
    if name is None and len(names) == 1:
        return 0
    if name not in names:
        raise InputError(
            f"not one of {', '.join(names)}" if name else f"say one of {', '.join(names)}, or dofs",
            field="preshape",
            value=name or "",
        )
    return names.index(name)


def _strategy_number(hand: "_core.Robot", name: Optional[str]) -> Optional[int]:
    if name is None:
        return None
    if name not in hand._strategies:
        known = ", ".join(hand._strategies)
        problem = f"not one of {known}" if known else "the hand has no strategies"
        raise InputError(problem, field="strategy", value=name)
    return hand._strategies.index(name)


def _inside_limits(hand: "_core.Robot", values: ArrayLike) -> FloatArray:
    dofs = as_finite(values, "dofs", (len(hand.dofs),))
    limits = hand.dof_limits
    for name, value, (lower, upper) in zip(hand.dofs, dofs, limits):
        if not lower - _LIMIT_TOLERANCE <= value <= upper + _LIMIT_TOLERANCE:
            raise InputError(
                f"{name} is outside its limits {lower:g} to {upper:g} rad or m",
                field="dofs",
                value=f"{value:g}",
            )
    return np.clip(dofs, limits[:, 0], limits[:, 1])


def candidate_fields(hand: "_core.Robot", candidate: Candidate) -> Dict[str, Any]:
    """What the planner takes. Raises InputError for what is not of this hand."""
    pose = as_pose(candidate.X_OH, "X_OH")
    approach = pose[:3, :3] @ hand._approach
    if candidate.approach is not None:
        approach = as_finite(candidate.approach, "approach", (3,))
        length = float(np.linalg.norm(approach))
        if abs(length - 1.0) > 1e-3:
            raise InputError("must be a unit vector", field="approach", value=f"length {length:g}")
    if not 0.0 <= candidate.approach_distance < np.inf:
        raise InputError(
            "must be at least 0",
            field="approach_distance",
            value=f"{candidate.approach_distance:g}",
        )
    by_name = candidate.dofs is None
    if not by_name and candidate.preshape is not None:
        raise InputError("not beside dofs", field="preshape", value=candidate.preshape)
    joints: ArrayLike = [] if candidate.joints is None else candidate.joints
    return {
        "X_OH": pose,
        "approach": approach,
        "approach_distance": float(candidate.approach_distance),
        "preshape": _preshape_number(hand, candidate.preshape) if by_name else None,
        "dofs": np.zeros(0) if candidate.dofs is None else _inside_limits(hand, candidate.dofs),
        "joints": as_finite(
            joints, "joints", (0 if candidate.joints is None else len(hand.joints),)
        ),
        "strategy": _strategy_number(hand, candidate.strategy),
    }


def as_candidates(
    hand: "_core.Robot",
    grasps: Union[ArrayLike, Sequence[Candidate]],
    preshape: Union[None, str, Sequence[str]],
    dofs: Optional[ArrayLike],
) -> List[Dict[str, Any]]:
    """Candidates, or poses (N, 4, 4) with one opening for all or one for each."""
    if isinstance(grasps, Candidate):
        grasps = [grasps]
    if isinstance(grasps, (list, tuple)) and grasps and isinstance(grasps[0], Candidate):
        if preshape is not None or dofs is not None:
            raise InputError("candidates have openings of their own", field="preshape, dofs")
        fields = []
        for i, candidate in enumerate(grasps):
            try:
                fields.append(candidate_fields(hand, candidate))
            except InputError as error:
                raise InputError(
                    error.problem, field=f"candidates[{i}].{error.field}", value=error.value
                ) from None
        return fields
    poses = as_poses(grasps, "poses")
    names: Sequence[Optional[str]]
    if preshape is None or isinstance(preshape, str):
        names = [preshape] * len(poses)
    else:
        names = list(preshape)
    if len(names) != len(poses):
        raise InputError(f"must be one or {len(poses)}", field="preshape", value=str(len(names)))
    openings: Sequence[Optional[FloatArray]] = [None] * len(poses)
    if dofs is not None:
        count = len(hand.dofs)
        one = np.ndim(dofs) == 1
        values = as_finite(dofs, "dofs", (count,) if one else (len(poses), count))
        openings = list(np.broadcast_to(values, (len(poses), count)))
    return [
        candidate_fields(hand, Candidate(pose, preshape=name, dofs=opening))
        for pose, name, opening in zip(poses, names, openings)
    ]
