"""What long calls share."""

from __future__ import annotations

from typing import Callable, Optional

from . import _core
from ._errors import InputError

ProgressCallback = Callable[["_core.Progress"], object]


def call_options(
    threads: int,
    progress: Optional[ProgressCallback],
    cancellation: Optional["_core.Cancellation"],
    budget: Optional[float] = None,
) -> "_core._CallOptions":
    """Raises InputError for fewer than no threads or no time at all."""
    if threads < 0:
        raise InputError("must be at least 0", field="threads", value=str(threads))
    if budget is not None and not budget > 0.0:
        raise InputError("must be above 0", field="budget", value=str(budget))
    seconds = float("inf") if budget is None else budget
    return _core._CallOptions(threads, progress, cancellation or _core.Cancellation(), seconds)
