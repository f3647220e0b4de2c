"""What callers pass as arrays, as arrays of the right type and shape.

Any object that NumPy understands will do: other number types, slices, Fortran order, lists. What has
another shape is refused with the argument's name and the shape it has.
"""

from __future__ import annotations

from typing import Any, Sequence, Union

import numpy as np
import numpy.typing as npt

from ._errors import InputError

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.intc]
#: Whatever numpy.asarray() makes an array of numbers of.
ArrayLike = Union[npt.ArrayLike, Sequence[Any]]

#: How far a rotation may be from orthonormal. Single precision is below 1e-6.
_ROTATION_TOLERANCE = 1e-5


def _described(shape: Sequence[Union[int, str]]) -> str:
    return "(" + ", ".join(str(size) for size in shape) + ("," if len(shape) == 1 else "") + ")"


def _fits(array: npt.NDArray[Any], shape: Sequence[Union[int, str]]) -> bool:
    return array.ndim == len(shape) and all(
        isinstance(wanted, str) or wanted == got for wanted, got in zip(shape, array.shape)
    )


def as_floats(value: ArrayLike, name: str, shape: Sequence[Union[int, str]]) -> FloatArray:
    """`value` as doubles in C order. A letter in `shape` stands for any size."""
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InputError(f"not an array of numbers: {error}", field=name) from None
    no_row = isinstance(shape[0], str) or shape[0] == 0 if shape else False
    if array.size == 0 and array.ndim == 1 and len(shape) > 1 and no_row:
        # An empty list has no second dimension to be wrong about.
        array = array.reshape([0 if isinstance(size, str) else size for size in shape])
    if not _fits(array, shape):
        raise InputError(
            f"must have the shape {_described(shape)}, not {_described(array.shape)}", field=name
        )
    return np.ascontiguousarray(array)


def as_faces(value: ArrayLike, vertices: int) -> IntArray:
    """Faces (F, 3): whole numbers, each that of one of so many vertices."""
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise InputError(f"not an array of numbers: {error}", field="faces") from None
    if not _fits(array, ("F", 3)):
        raise InputError(
            f"must have the shape (F, 3), not {_described(array.shape)}", field="faces"
        )
    if not np.issubdtype(array.dtype, np.integer):
        raise InputError("must be whole numbers", field="faces", value=str(array.dtype))
    if array.size and (array.min() < 0 or array.max() >= vertices):
        worst = array.min() if array.min() < 0 else array.max()
        raise InputError(
            f"refers to a vertex that is not there, of {vertices}", field="faces", value=str(worst)
        )
    return np.ascontiguousarray(array, dtype=np.intc)


def as_pose(value: ArrayLike, name: str) -> FloatArray:
    """A rigid pose (4, 4)."""
    pose: FloatArray = as_poses(as_floats(value, name, (4, 4))[np.newaxis], name)[0]
    return pose.copy()


def as_poses(value: ArrayLike, name: str) -> FloatArray:
    """Rigid poses (N, 4, 4); what rounding left of their rotations is put right."""
    poses = as_floats(value, name, ("N", 4, 4))
    for i, pose in enumerate(poses):
        at = f"{name}[{i}]" if len(poses) > 1 else name
        if not np.all(np.isfinite(pose)):
            raise InputError("a number is not finite", field=at)
        rotation = pose[:3, :3]
        error = float(np.max(np.abs(rotation @ rotation.T - np.eye(3))))
        if error > _ROTATION_TOLERANCE or np.linalg.det(rotation) < 0.0:
            raise InputError("not a rigid pose: its upper left 3 x 3 is no rotation", field=at)
        if np.max(np.abs(pose[3] - (0.0, 0.0, 0.0, 1.0))) > _ROTATION_TOLERANCE:
            raise InputError("not a rigid pose: its last row is not 0 0 0 1", field=at)
        if error > 1e-12:
            # Doubles are left to the bit; only coarser numbers are brought to the nearest rotation.
            u, _, vt = np.linalg.svd(rotation)
            poses = poses.copy()
            poses[i, :3, :3] = u @ vt
    return poses


def as_finite(value: ArrayLike, name: str, shape: Sequence[Union[int, str]]) -> FloatArray:
    """As as_floats, and every number finite."""
    array = as_floats(value, name, shape)
    if not np.all(np.isfinite(array)):
        raise InputError("a number is not finite", field=name)
    return array
