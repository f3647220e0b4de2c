"""How results show themselves in a notebook: a table beside a picture, with nothing from outside."""

from __future__ import annotations

import base64
import html
from typing import TYPE_CHECKING, Iterable, List, Sequence

from . import _core

if TYPE_CHECKING:
    from .results import PlanResult, Trial

_SIZE = (480, 360)
_MOST_ROWS = 10
_CELL = "padding:2px 10px 2px 0;text-align:left;vertical-align:top"


def _row(cells: Iterable[str], tag: str = "td") -> str:
    inner = "".join(f'<{tag} style="{_CELL}">{html.escape(cell)}</{tag}>' for cell in cells)
    return f"<tr>{inner}</tr>"


def _table(rows: Sequence[str]) -> str:
    return f'<table style="border-collapse:collapse">{"".join(rows)}</table>'


def _picture(trial: Trial) -> str:
    png = _core.png_bytes(_core.grasp_picture(trial._in_core(), "", _SIZE, None))
    source = base64.b64encode(png).decode("ascii")
    return f'<img alt="The hand at the object" width="{_SIZE[0]}" src="data:image/png;base64,{source}">'


def _beside(*parts: str) -> str:
    style = "display:flex;flex-wrap:wrap;gap:16px;align-items:flex-start"
    return f'<div style="{style}">{"".join(f"<div>{part}</div>" for part in parts)}</div>'


def _numbers(values: Iterable[float], digits: int = 4) -> str:
    return " ".join(f"{value:.{digits}g}" for value in values)


def trial_html(trial: Trial) -> str:
    """A trial or a grasp: its numbers beside its picture."""
    rows = [
        ("outcome", str(trial.outcome)),
        ("what it means", trial.outcome.__doc__ or ""),
        ("epsilon", f"{trial.epsilon:.4g} to {trial.epsilon_upper:.4g}"),
    ]
    volume = getattr(trial, "volume", None)
    if volume is not None:
        rows.append(("volume", f"{volume:.3g}"))
    links = ", ".join(dict.fromkeys(trial.contacts.links))
    rows.append(("contacts", f"{len(trial.contacts)}" + (f": {links}" if links else "")))
    if trial.blocked_by:
        rows.append(("blocked", f"{trial.blocked_link} met {trial.blocked_by}"))
    rows.append(("preshape", trial.preshape or "none"))
    if getattr(trial, "rule", ""):
        rows.append(("proposed for", getattr(trial, "rule")))
    rows.append(("hand in the object's frame [m]", _numbers(trial.X_OH[:3, 3])))
    rows.append(("degrees of freedom [rad or m]", _numbers(trial.dofs)))
    return _beside(_picture(trial), _table([_row(row) for row in rows]))


def _grasp_rows(result: PlanResult) -> List[str]:
    rows = [_row(("", "epsilon", "volume", "contacts", "preshape", "proposed for"), "th")]
    for rank, grasp in enumerate(result.grasps[:_MOST_ROWS], 1):
        rows.append(
            _row(
                (
                    str(rank),
                    f"{grasp.epsilon:.4f}",
                    f"{grasp.volume:.3g}",
                    str(len(grasp.contacts)),
                    grasp.preshape or "none",
                    grasp.rule if grasp.stable else str(grasp.outcome),
                )
            )
        )
    more = len(result.grasps) - _MOST_ROWS
    return [*rows, _row(("", f"and {more} more"))] if more > 0 else rows


def _failure_rows(result: PlanResult) -> List[str]:
    rows = [_row(("why not", "candidates"), "th")]
    counts = sorted(result.outcomes.items(), key=lambda entry: -entry[1])
    rows += [_row((str(outcome), str(count))) for outcome, count in counts if count]
    return rows + [_row((str(one.hint), one.words)) for one in result.advice]


def plan_html(result: PlanResult) -> str:
    """A plan: its grasps, or why there are none, and the picture of the first."""
    tried = sum(result.outcomes.values())
    head = f"{result.scene.name}: {result.status}, {len(result)} grasps of {tried} candidates tried"
    title = f"<p><b>{html.escape(head)}</b></p>"
    if result.reason:
        title += f"<p>{html.escape(result.reason)}</p>"
    if not result.grasps:
        return title + _table(_failure_rows(result))
    return title + _beside(_picture(result.grasps[0]), _table(_grasp_rows(result)))
