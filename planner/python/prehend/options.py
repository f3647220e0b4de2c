"""What plans and their steps depend on, as objects whose fields are keywords of their constructors:

    prehend.PlanOptions(rank=options.RankOptions(top=3))

prehend.plan_options() makes those of an accuracy.
"""

from __future__ import annotations

from ._core import (
    Accuracy,
    CandidateOptions,
    ContactOptions,
    DecomposeOptions,
    EvaluateOptions,
    FormationOptions,
    GiveWayOptions,
    GraspPathOptions,
    IkOptions,
    LearnedOrder,
    LiftOptions,
    MotionCheckOptions,
    NoiseOptions,
    PathCheckOptions,
    PlanOptions,
    RankOptions,
    ReachOptions,
    RefineOptions,
    SearchOptions,
    SettleOptions,
    ThinPartOptions,
    TimePathOptions,
    TransferOptions,
    TrialOptions,
    UncertaintyOptions,
)
from ._names import show_in

__all__ = [
    "Accuracy",
    "CandidateOptions",
    "ContactOptions",
    "DecomposeOptions",
    "EvaluateOptions",
    "FormationOptions",
    "GiveWayOptions",
    "GraspPathOptions",
    "IkOptions",
    "LearnedOrder",
    "LiftOptions",
    "MotionCheckOptions",
    "NoiseOptions",
    "PathCheckOptions",
    "PlanOptions",
    "RankOptions",
    "ReachOptions",
    "RefineOptions",
    "SearchOptions",
    "SettleOptions",
    "ThinPartOptions",
    "TimePathOptions",
    "TransferOptions",
    "TrialOptions",
    "UncertaintyOptions",
]

show_in(
    __name__,
    Accuracy,
    CandidateOptions,
    ContactOptions,
    DecomposeOptions,
    FormationOptions,
    GiveWayOptions,
    GraspPathOptions,
    IkOptions,
    LearnedOrder,
    LiftOptions,
    MotionCheckOptions,
    NoiseOptions,
    PathCheckOptions,
    RankOptions,
    ReachOptions,
    RefineOptions,
    SearchOptions,
    SettleOptions,
    ThinPartOptions,
    TimePathOptions,
    TransferOptions,
    TrialOptions,
    UncertaintyOptions,
)
