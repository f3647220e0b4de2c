"""What can be written of a plan: JSON, a report, exports, pictures."""

from __future__ import annotations

import os
from pathlib import Path as FilePath
from typing import Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import ArrayLike, as_finite
from ._calls import ProgressCallback, call_options
from ._errors import InputError
from .results import Grasp, PlanResult, Trial
from .scenes import PathLike

__all__ = [
    "arm_picture",
    "export_files",
    "export_formats",
    "grasp_picture",
    "grasps_json",
    "png_bytes",
    "report_html",
    "timings_json",
    "write_grasps",
]

ByteArray = npt.NDArray[np.uint8]


def grasps_json(result: PlanResult) -> str:
    """The text of grasps.json (docs/reference/grasps-file.md): the same as the program's, byte for byte.

    Of a scene that was made in code the file can name no scene; Scene.save() gives it one.
    """
    return _core.grasps_json(result._in_core()).decode("utf-8")


def timings_json(result: PlanResult, threads: int = 0) -> str:
    """The text of timings.json: what each stage took [s], on so many threads."""
    return _core.timings_json(result._in_core(), threads)


def report_html(
    result: PlanResult,
    *,
    threads: int = 0,
    cancellation: Optional["_core.Cancellation"] = None,
) -> str:
    """The report as one page for a browser, which fetches nothing (docs/reference/report.md).

    Wrench spaces are shown for the grasps that were planned with PlanOptions.sections.
    """
    return _core.report_html(result._in_core(), call_options(threads, None, cancellation))


def export_formats() -> List[str]:
    """Formats of export_files()."""
    return _core.export_formats()


def export_files(result: PlanResult, format: str) -> Dict[str, bytes]:
    """Files for other programs by name (docs/reference/exports.md).

    Raises:
        InputError: that lists the formats for another one.
    """
    return dict(_core.export_files(result._in_core(), format))


def _title(grasp: Trial, rank: Optional[int]) -> str:
    parts = [] if rank is None else [f"rank {rank}"]
    parts.append(f"epsilon {grasp.epsilon:.4f}")
    if isinstance(grasp, Grasp):
        parts.append(f"volume {grasp.volume:.3g}")
    return "   ".join([*parts, f"{len(grasp.contacts)} contacts"])


def _checked_size(size: Tuple[int, int]) -> Tuple[int, int]:
    width, height = size
    if not (1 <= width <= 16384 and 1 <= height <= 16384):
        raise InputError("must be from 1 to 16384 pixels", field="size", value=str(size))
    return width, height


def grasp_picture(
    grasp: Trial,
    *,
    size: Tuple[int, int] = (900, 700),
    direction: Optional[ArrayLike] = None,
    title: Optional[str] = None,
) -> ByteArray:
    """A picture of a grasp as pixels (height, width, 3), 8-bit sRGB, top row first.

    Args:
        grasp: from a PlanResult or run_trial().
        size: width and height in pixels.
        direction: (3,): from the object to the eye, in the world's frame, of any length above 0.
            None: the side from which most is seen of the contacts.
        title: text in the lower left corner; None: the grasp's numbers.
    """
    eye = None if direction is None else as_finite(direction, "direction", (3,))
    if eye is not None and not np.any(eye):
        raise InputError("must not be zero", field="direction")
    text = _title(grasp, None) if title is None else title
    return _core.grasp_picture(grasp._in_core(), text, _checked_size(size), eye)


def arm_picture(
    grasp: Trial, *, size: Tuple[int, int] = (900, 700), title: Optional[str] = None
) -> ByteArray:
    """A picture of the arm that holds the grasp; as grasp_picture().

    Raises:
        InputError: no arm holds it.
    """
    text = _title(grasp, None) if title is None else title
    return _core.arm_picture(grasp._in_core(), text, _checked_size(size))


def png_bytes(picture: npt.ArrayLike) -> bytes:
    """A picture (height, width, 3) of 8-bit numbers as the bytes of a PNG file."""
    pixels = np.asarray(picture)
    if pixels.ndim != 3 or pixels.shape[2] != 3 or pixels.dtype != np.uint8:
        raise InputError(
            "must have the shape (height, width, 3) and the type uint8",
            field="picture",
            value=f"{pixels.shape}, {pixels.dtype}",
        )
    return _core.png_bytes(pixels)


def write_whole(file: FilePath, content: Union[str, bytes]) -> None:
    """Beside it first, then renamed: a file is there whole or not at all."""
    data = content.encode("utf-8") if isinstance(content, str) else content
    part = file.with_name(f"{file.name}.part{os.getpid()}")
    try:
        part.write_bytes(data)
        os.replace(part, file)
    except OSError:
        part.unlink(missing_ok=True)
        raise


def write_grasps(
    result: PlanResult,
    folder: PathLike,
    *,
    report: bool = True,
    picture: Optional[bool] = None,
    exports: Sequence[str] = (),
    threads: int = 0,
    progress: Optional[ProgressCallback] = None,
) -> List[str]:
    """Writes what the program writes of a plan.

    That is grasps.json, timings.json, with `report` report.html, with `picture` best.png (and
    best_arm.png), and the files of the formats in `exports`. Everything is made before anything is
    written. What an earlier result left in the folder is removed (docs/reference/exports.md).

    Args:
        folder: made where it is missing.
        picture: None stands for the value of `report`.
        exports: see export_formats().

    Returns:
        The names of the files.
    """
    files: Dict[str, Union[str, bytes]] = {"grasps.json": grasps_json(result)}
    for format in exports:
        files.update(export_files(result, format))
    if report:
        files["report.html"] = _core.report_html(
            result._in_core(), call_options(threads, progress, None)
        )
    if result.grasps and (report if picture is None else picture):
        best = result.grasps[0]
        title = _title(best, 1)
        files["best.png"] = png_bytes(grasp_picture(best, title=title))
        if best.arm_dofs is not None:
            files["best_arm.png"] = png_bytes(arm_picture(best, title=title))
    files["timings.json"] = timings_json(result)
    target = FilePath(folder)
    target.mkdir(parents=True, exist_ok=True)
    for name, content in files.items():
        write_whole(target / name, content)
    _core.remove_earlier_results(result._in_core(), os.fsdecode(target), list(files))
    return list(files)
