"""Scores compared with what became of executed grasps (docs/reference/truth-file.md)."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from pathlib import Path as FilePath
from typing import Any, Dict, List, NamedTuple, Optional, Tuple, Union

import numpy as np

from . import _core
from ._arrays import FloatArray
from ._calls import ProgressCallback, call_options
from ._core import Grouping, ObjectPlace, Outcome
from ._errors import InputError
from ._names import show_in
from .files import write_whole
from .scenes import PathLike

__all__ = [
    "Calibration",
    "FrameCheck",
    "FrameSuspicion",
    "Grouping",
    "ObjectPlace",
    "ReliabilityBin",
    "ValidationPart",
    "ValidationReport",
    "ValidationScore",
    "compare_executions",
]

show_in(__name__, Grouping, ObjectPlace)

Interval = Tuple[float, float]


@dataclass(frozen=True)
class ReliabilityBin:
    """The executions whose predicted probability of success lies between two numbers."""

    lower: float
    upper: float
    count: int
    lifted: int
    predicted: Optional[float]
    """Mean of the predictions; None where there are none."""
    observed: Optional[float]
    """The share that lifted; None where there are none."""
    interval: Interval
    """Of the true share, 95 %."""


@dataclass(frozen=True, eq=False)
class Calibration:
    """Whether predicted probabilities are as large as the shares that succeed."""

    expected_error: float
    """Mean distance between prediction and share over the bins (expected calibration error)."""
    brier: float
    """Mean of (prediction - outcome)^2; 0 is best."""
    brier_of_base_rate: float
    """The same if each prediction were the share that lifted: who is above it knows nothing."""
    bins: List[ReliabilityBin] = field(repr=False)
    """Ten, from 0 to 1."""

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "Calibration":
        bins = [
            ReliabilityBin(
                one["from"],
                one["to"],
                one["count"],
                one["lifted"],
                one["predicted"],
                one["observed"],
                (one["interval"][0], one["interval"][1]),
            )
            for one in fields["bins"]
        ]
        return Calibration(
            fields["expected_error"], fields["brier"], fields["brier_of_base_rate"], bins
        )


def _interval(bounds: Optional[List[float]]) -> Optional[Interval]:
    return None if bounds is None else (bounds[0], bounds[1])


@dataclass(frozen=True, eq=False)
class ValidationScore:
    """How well one score tells grasps that lifted from those that failed."""

    name: str
    title: str
    """For people."""
    auc: Optional[float]
    """The probability that of a lifted and a failed grasp the lifted one has the larger score."""
    interval: Optional[Interval]
    """Of the AUC, 95 %; None where there is but one group to draw from."""
    over_epsilon: Optional[float]
    """AUC minus that of epsilon."""
    over_epsilon_interval: Optional[Interval]
    """Of that difference, in the same resamples."""
    calibration: Optional[Calibration]
    """Of a score that is a probability; else None."""
    roc: FloatArray = field(repr=False)
    """(K, 2): shares of the failed and of the lifted grasps with at least some score."""

    @staticmethod
    def _of(fields: Dict[str, Any]) -> "ValidationScore":
        calibration = fields.get("calibration")
        return ValidationScore(
            name=fields["name"],
            title=fields["title"],
            auc=fields["auc"],
            interval=_interval(fields["interval"]),
            over_epsilon=fields["over_epsilon"],
            over_epsilon_interval=_interval(fields["over_epsilon_interval"]),
            calibration=None if calibration is None else Calibration._of(calibration),
            roc=np.array(fields["roc"], dtype=float).reshape(-1, 2),
        )


class ValidationPart(NamedTuple):
    """The executions of one object or one session."""

    name: str
    lifted: int
    failed: int
    auc: Dict[str, Optional[float]]
    """By score; None where all ended the same way."""


class FrameSuspicion(NamedTuple):
    """A change of all poses after which many more of them make sense."""

    change: str
    question: str
    between: int
    """Grasps with the object between the fingers then."""


@dataclass(frozen=True, eq=False)
class FrameCheck:
    """Whether the poses are in the frames that they are said to be in, judged by surfaces alone."""

    grasps: int
    object: Dict[ObjectPlace, int]
    """Of how many grasps the object is where."""
    in_obstacles: int
    words: str
    """All of this as a sentence."""
    suspicion: Optional[FrameSuspicion]


@dataclass(frozen=True, eq=False)
class ValidationReport:
    """Scores of executed grasps, compared with what became of these. str() is the table."""

    lifted: int
    """Executions."""
    failed: int
    scores: Dict[str, ValidationScore]
    """By name, in the order of the table."""
    objects: List[ValidationPart]
    sessions: List[ValidationPart]
    outcomes: Dict[Outcome, int]
    """How the trials ended, one for each entry of the file."""
    frames: FrameCheck
    settings: Dict[str, Any]
    """seed, samples, resamples, level, groups."""
    groups_drawn: int
    """From how many groups resamples were drawn."""
    resamples_of_one_outcome: int
    """Resamples that were left out because all executions in them ended the same way."""
    json: str = field(repr=False)
    """The text of truth.json: the same as the program's, byte for byte."""
    html: str = field(repr=False)
    """The report as one page for a browser, which fetches nothing."""
    table: str = field(repr=False)
    """What the program prints."""

    def __str__(self) -> str:
        return self.table

    def save_json(self, file: PathLike) -> None:
        """Writes truth.json under this name."""
        write_whole(FilePath(file), self.json)

    def save_html(self, file: PathLike) -> None:
        """Writes the page under this name."""
        write_whole(FilePath(file), self.html)


def _frames(fields: Dict[str, Any]) -> FrameCheck:
    suspicion = fields.pop("suspicion")
    fields["object"] = {ObjectPlace(place): count for place, count in fields["object"].items()}
    return FrameCheck(
        **fields, suspicion=None if suspicion is None else FrameSuspicion(**suspicion)
    )


def _report(text: str, html: str, table: str) -> ValidationReport:
    fields = json.loads(text)
    return ValidationReport(
        lifted=fields["lifted"],
        failed=fields["failed"],
        scores={one["name"]: ValidationScore._of(one) for one in fields["scores"]},
        objects=[ValidationPart(**part) for part in fields["objects"]],
        sessions=[ValidationPart(**part) for part in fields["sessions"]],
        outcomes={Outcome(outcome): count for outcome, count in fields["outcomes"].items()},
        frames=_frames(fields["frames"]),
        settings=fields["settings"],
        groups_drawn=fields["groups_drawn"],
        resamples_of_one_outcome=fields["resamples_of_one_outcome"],
        json=text,
        html=html,
        table=table,
    )


def compare_executions(
    file: PathLike,
    options: Optional["_core.EvaluateOptions"] = None,
    *,
    volumes: bool = True,
    groups: Union[None, str, Grouping] = None,
    resamples: int = 2000,
    threads: int = 0,
    progress: Optional[ProgressCallback] = None,
    cancellation: Optional["_core.Cancellation"] = None,
) -> ValidationReport:
    """Compares what prehend says of executed grasps with what became of them.

    The same file, options and seed give the same report, to the byte, on any number of threads.

    Args:
        file: executed grasps (docs/reference/truth-file.md).
        options: how grasps are tried, and the seed; None: EvaluateOptions(). Its robustness, volumes
            and sections do not count: they follow from the scores.
        volumes: whether the volume is a score as well, which takes about half of the time.
        groups: what is drawn as a whole for the intervals.
            None: objects where there are several, else sessions where there are several, else each.
        resamples: from how many intervals are computed.
        threads, progress: as of plan().
        cancellation: ends the call once it is requested.

    Raises:
        InputError: for a file that cannot be used, with file, field and value.
        Cancelled: once the cancellation is requested.
    """
    if not 1 <= resamples <= 1_000_000:
        raise InputError("must be from 1 to 1000000", field="resamples", value=str(resamples))
    if groups == "":
        raise InputError("must be object, session, both or each", field="groups")
    texts = _core.compare_executions(
        os.fsencode(file),
        _core.EvaluateOptions() if options is None else options,
        volumes,
        str(groups or ""),
        resamples,
        call_options(threads, progress, cancellation),
    )
    return _report(*(text.decode("utf-8", "replace") for text in texts))
