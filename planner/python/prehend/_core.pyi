"""Types of the C++ half of prehend. What its fields mean, help() says: the docstrings are there."""

from typing import Any, Callable, Dict, List, Literal, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._names import NamedEnum

_Floats = npt.NDArray[np.float64]
_Integers = npt.NDArray[np.intc]
_Bytes = npt.NDArray[np.uint8]

__version__: str
most_detailed: int
fields_of_results: Dict[str, Tuple[str, ...]]

class Outcome(NamedEnum):
    stable = "stable"
    not_force_closure = "not_force_closure"
    no_contact = "no_contact"
    hand_blocked = "hand_blocked"
    approach_blocked = "approach_blocked"
    unreachable = "unreachable"
    arm_blocked = "arm_blocked"
    pushed_away = "pushed_away"
    toppled = "toppled"
    squeezed_out = "squeezed_out"
    dropped = "dropped"
    not_simulated = "not_simulated"
    no_path = "no_path"

class PlanStatus(NamedEnum):
    complete = "complete"
    out_of_time = "out_of_time"
    cancelled = "cancelled"
    object_too_large = "object_too_large"
    no_candidates = "no_candidates"

class PlanCount(NamedEnum):
    primitives_given = "primitives given"
    primitives = "primitives"
    candidates = "candidates"
    reach = "reach"
    obstacles = "obstacles"
    trials = "trials"
    refined = "refined"
    ranked = "ranked"
    paths = "paths"

class Stage(NamedEnum):
    load = "load"
    compile = "compile"
    primitives = "primitives"
    candidates = "candidates"
    trials = "trials"
    rank = "rank"
    refine = "refine"
    paths = "paths"
    volumes = "volumes"
    disturb = "disturb"
    shake = "shake"
    report = "report"
    picture = "picture"

class LiftEnd(NamedEnum):
    not_asked = "not_asked"
    complete = "complete"
    lift_unreachable = "lift_unreachable"
    lift_blocked = "lift_blocked"
    retreat_blocked = "retreat_blocked"

class Hint(NamedEnum):
    friction = "friction"
    soft_contacts = "soft_contacts"
    other_hand = "other_hand"
    tolerance = "tolerance"
    obstacle = "obstacle"
    arm = "arm"
    candidates = "candidates"
    path = "path"
    unit = "unit"

class Accuracy(NamedEnum):
    draft = "draft"
    standard = "standard"
    fine = "fine"

class Material(NamedEnum):
    glass = "glass"
    metal = "metal"
    plastic = "plastic"
    wood = "wood"
    rubber = "rubber"

class ContactModel(NamedEnum):
    frictionless = "frictionless"
    point = "point"
    soft_finger = "soft_finger"

class EpsilonStatus(NamedEnum):
    converged = "converged"
    no_force_closure = "no_force_closure"
    below_cutoff = "below_cutoff"
    limit = "limit"
    stalled = "stalled"

class ForceOutcome(NamedEnum):
    balanced = "balanced"
    impossible = "impossible"
    limit = "limit"

class StepOutcome(NamedEnum):
    moved = "moved"
    not_converged = "not_converged"
    blocked = "blocked"
    not_finite = "not_finite"

class ControlOutcome(NamedEnum):
    finished = "finished"
    stopped = "stopped"
    not_a_number = "not_a_number"
    wrong_size = "wrong_size"
    blocked = "blocked"
    not_finite = "not_finite"

class ObjectPlace(NamedEnum):
    between = "between"
    beside = "beside"
    inside = "inside"
    palm = "palm"

class Grouping(NamedEnum):
    object = "object"
    session = "session"
    both = "both"
    each = "each"

class Cancellation:
    def __init__(self) -> None: ...
    def request(self) -> None: ...
    @property
    def requested(self) -> bool: ...

class Progress:
    @property
    def stage(self) -> Stage: ...
    @property
    def done(self) -> int: ...
    @property
    def total(self) -> int: ...
    @property
    def stable(self) -> int: ...

class DecomposeOptions:
    _fields: Tuple[str, ...]
    tolerance: float
    coverage: float
    points: int
    max_primitives: int
    seed: int
    def __init__(
        self,
        *,
        tolerance: float = ...,
        coverage: float = ...,
        points: int = ...,
        max_primitives: int = ...,
        seed: int = ...,
    ) -> None: ...
    def __copy__(self) -> DecomposeOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> DecomposeOptions: ...

class CandidateOptions:
    _fields: Tuple[str, ...]
    duplicate_distance: float
    duplicate_angle: float
    start_clearance: float
    def __init__(
        self,
        *,
        duplicate_distance: float = ...,
        duplicate_angle: float = ...,
        start_clearance: float = ...,
    ) -> None: ...
    def __copy__(self) -> CandidateOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> CandidateOptions: ...

class ThinPartOptions:
    _fields: Tuple[str, ...]
    rim_width: float
    bar_width: float
    most_rims: int
    most_bars: int
    points: int
    seed: int
    def __init__(
        self,
        *,
        rim_width: float = ...,
        bar_width: float = ...,
        most_rims: int = ...,
        most_bars: int = ...,
        points: int = ...,
        seed: int = ...,
    ) -> None: ...
    def __copy__(self) -> ThinPartOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> ThinPartOptions: ...

class TreeModel:
    @property
    def name(self) -> str: ...
    @property
    def hands(self) -> List[str]: ...
    @property
    def any_hand(self) -> bool: ...
    @property
    def objects(self) -> int: ...
    @property
    def trials(self) -> int: ...

class LearnedOrder:
    _fields: Tuple[str, ...]
    model: Optional[TreeModel]
    choose_from: int
    variety: float
    unordered: float
    ordered_first: int
    unknown_hand_first: int
    def __init__(
        self,
        *,
        model: Optional[TreeModel] = ...,
        choose_from: int = ...,
        variety: float = ...,
        unordered: float = ...,
        ordered_first: int = ...,
        unknown_hand_first: int = ...,
    ) -> None: ...
    def __copy__(self) -> LearnedOrder: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> LearnedOrder: ...

class SearchOptions:
    _fields: Tuple[str, ...]
    trials: int
    most_blocked: int
    enough: int
    batch: int
    follow: float
    followed: int
    well_served: float
    solids_first: float
    curves_least: float
    patience: int
    patient_back_offs: int
    learned: Optional[LearnedOrder]
    def __init__(
        self,
        *,
        trials: int = ...,
        most_blocked: int = ...,
        enough: int = ...,
        batch: int = ...,
        follow: float = ...,
        followed: int = ...,
        well_served: float = ...,
        solids_first: float = ...,
        curves_least: float = ...,
        patience: int = ...,
        patient_back_offs: int = ...,
        learned: Optional[LearnedOrder] = ...,
    ) -> None: ...
    def __copy__(self) -> SearchOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> SearchOptions: ...

class ContactOptions:
    _fields: Tuple[str, ...]
    threshold: float
    evenness: float
    angular_tolerance: float
    max_region_corners: int
    same_place: float
    flat_corner: float
    weakest_patch: float
    def __init__(
        self,
        *,
        threshold: float = ...,
        evenness: float = ...,
        angular_tolerance: float = ...,
        max_region_corners: int = ...,
        same_place: float = ...,
        flat_corner: float = ...,
        weakest_patch: float = ...,
    ) -> None: ...
    def __copy__(self) -> ContactOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> ContactOptions: ...

class MotionCheckOptions:
    _fields: Tuple[str, ...]
    tightest: float
    gap_error: float
    def __init__(
        self,
        *,
        tightest: float = ...,
        gap_error: float = ...,
    ) -> None: ...
    def __copy__(self) -> MotionCheckOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> MotionCheckOptions: ...

class IkOptions:
    _fields: Tuple[str, ...]
    position_tolerance: float
    angle_tolerance: float
    max_iterations: int
    restarts: int
    max_solutions: int
    seed: int
    def __init__(
        self,
        *,
        position_tolerance: float = ...,
        angle_tolerance: float = ...,
        max_iterations: int = ...,
        restarts: int = ...,
        max_solutions: int = ...,
        seed: int = ...,
    ) -> None: ...
    def __copy__(self) -> IkOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> IkOptions: ...

class ReachOptions:
    _fields: Tuple[str, ...]
    kinematics: IkOptions
    line_step: float
    largest_joint_step: float
    motion: MotionCheckOptions
    def __init__(
        self,
        *,
        kinematics: IkOptions = ...,
        line_step: float = ...,
        largest_joint_step: float = ...,
        motion: MotionCheckOptions = ...,
    ) -> None: ...
    def __copy__(self) -> ReachOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> ReachOptions: ...

class SettleOptions:
    _fields: Tuple[str, ...]
    angle: float
    slide: float
    steps: int
    least_part: float
    loosen: float
    least_gain: float
    least_force: float
    least_arm: float
    def __init__(
        self,
        *,
        angle: float = ...,
        slide: float = ...,
        steps: int = ...,
        least_part: float = ...,
        loosen: float = ...,
        least_gain: float = ...,
        least_force: float = ...,
        least_arm: float = ...,
    ) -> None: ...
    def __copy__(self) -> SettleOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> SettleOptions: ...

class GapTrackerOptions:
    _fields: Tuple[str, ...]
    near: float
    reach: float
    least_reach: float
    most_pairs: int
    looseness: float
    def __init__(
        self,
        *,
        near: float = ...,
        reach: float = ...,
        least_reach: float = ...,
        most_pairs: int = ...,
        looseness: float = ...,
    ) -> None: ...
    def __copy__(self) -> GapTrackerOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> GapTrackerOptions: ...

class FormationOptions:
    _fields: Tuple[str, ...]
    dynamic: bool
    gravity: float
    settle: float
    close: float
    lift: float
    lift_time: float
    step: float
    def __init__(
        self,
        *,
        dynamic: bool = ...,
        gravity: float = ...,
        settle: float = ...,
        close: float = ...,
        lift: float = ...,
        lift_time: float = ...,
        step: float = ...,
    ) -> None: ...
    def __copy__(self) -> FormationOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> FormationOptions: ...

class GiveWayOptions:
    _fields: Tuple[str, ...]
    object: float
    obstacle: float
    deepest: float
    def __init__(
        self,
        *,
        object: float = ...,
        obstacle: float = ...,
        deepest: float = ...,
    ) -> None: ...
    def __copy__(self) -> GiveWayOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> GiveWayOptions: ...

class UncertaintyOptions:
    _fields: Tuple[str, ...]
    samples: int
    across: float
    along: float
    angle: float
    hand: float
    hand_angle: float
    friction: float
    center_of_mass: float
    def __init__(
        self,
        *,
        samples: int = ...,
        across: float = ...,
        along: float = ...,
        angle: float = ...,
        hand: float = ...,
        hand_angle: float = ...,
        friction: float = ...,
        center_of_mass: float = ...,
    ) -> None: ...
    def __copy__(self) -> UncertaintyOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> UncertaintyOptions: ...

class TrialOptions:
    _fields: Tuple[str, ...]
    contact: ContactOptions
    contact_gap: float
    give_way: GiveWayOptions
    obstacle_clearance: float
    back_off_step: float
    back_off_tries: int
    soft_fingers: bool
    settle: SettleOptions
    cone_edges: int
    reach: ReachOptions
    max_gap_queries: int
    gaps: GapTrackerOptions
    formation: FormationOptions
    def __init__(
        self,
        *,
        contact: ContactOptions = ...,
        contact_gap: float = ...,
        give_way: GiveWayOptions = ...,
        obstacle_clearance: float = ...,
        back_off_step: float = ...,
        back_off_tries: int = ...,
        soft_fingers: bool = ...,
        settle: SettleOptions = ...,
        cone_edges: int = ...,
        reach: ReachOptions = ...,
        max_gap_queries: int = ...,
        gaps: GapTrackerOptions = ...,
        formation: FormationOptions = ...,
    ) -> None: ...
    def __copy__(self) -> TrialOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> TrialOptions: ...

class TransferOptions:
    _fields: Tuple[str, ...]
    planner: Literal["rrt_connect", "roadmap", "rrt_star"]
    max_iterations: int
    simplify_steps: int
    longest_edge: float
    corner_deviation: float
    seed: int
    motion: MotionCheckOptions
    def __init__(
        self,
        *,
        planner: Literal["rrt_connect", "roadmap", "rrt_star"] = ...,
        max_iterations: int = ...,
        simplify_steps: int = ...,
        longest_edge: float = ...,
        corner_deviation: float = ...,
        seed: int = ...,
        motion: MotionCheckOptions = ...,
    ) -> None: ...
    def __copy__(self) -> TransferOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> TransferOptions: ...

class TimePathOptions:
    _fields: Tuple[str, ...]
    sample_time: float
    def __init__(
        self,
        *,
        sample_time: float = ...,
    ) -> None: ...
    def __copy__(self) -> TimePathOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> TimePathOptions: ...

class PathCheckOptions:
    _fields: Tuple[str, ...]
    step: float
    def __init__(
        self,
        *,
        step: float = ...,
    ) -> None: ...
    def __copy__(self) -> PathCheckOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> PathCheckOptions: ...

class LiftOptions:
    _fields: Tuple[str, ...]
    height: float
    retreat: bool
    leave_within: float
    def __init__(
        self,
        *,
        height: float = ...,
        retreat: bool = ...,
        leave_within: float = ...,
    ) -> None: ...
    def __copy__(self) -> LiftOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> LiftOptions: ...

class GraspPathOptions:
    _fields: Tuple[str, ...]
    reach: ReachOptions
    transfer: TransferOptions
    timing: TimePathOptions
    alternatives: int
    check: PathCheckOptions
    lift: LiftOptions
    def __init__(
        self,
        *,
        reach: ReachOptions = ...,
        transfer: TransferOptions = ...,
        timing: TimePathOptions = ...,
        alternatives: int = ...,
        check: PathCheckOptions = ...,
        lift: LiftOptions = ...,
    ) -> None: ...
    def __copy__(self) -> GraspPathOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> GraspPathOptions: ...

class RefineOptions:
    _fields: Tuple[str, ...]
    objective: Literal["epsilon", "robust"]
    grasps: int
    trials: int
    turn: float
    shift: float
    spread: float
    reach: float
    noise: NoiseOptions
    def __init__(
        self,
        *,
        objective: Literal["epsilon", "robust"] = ...,
        grasps: int = ...,
        trials: int = ...,
        turn: float = ...,
        shift: float = ...,
        spread: float = ...,
        reach: float = ...,
        noise: NoiseOptions = ...,
    ) -> None: ...
    def __copy__(self) -> RefineOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> RefineOptions: ...

class RankOptions:
    _fields: Tuple[str, ...]
    top: int
    by: str
    pool: float
    same_distance: float
    same_angle: float
    same_contact: float
    def __init__(
        self,
        *,
        top: int = ...,
        by: str = ...,
        pool: float = ...,
        same_distance: float = ...,
        same_angle: float = ...,
        same_contact: float = ...,
    ) -> None: ...
    def __copy__(self) -> RankOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> RankOptions: ...

class PlanOptions:
    _fields: Tuple[str, ...]
    seed: int
    primitives: DecomposeOptions
    thin_parts: ThinPartOptions
    candidates: CandidateOptions
    search: SearchOptions
    trial: TrialOptions
    refine: RefineOptions
    rank: RankOptions
    paths: Optional[GraspPathOptions]
    robustness: bool
    uncertainty: UncertaintyOptions
    volumes: bool
    sections: int
    def __init__(
        self,
        *,
        seed: int = ...,
        primitives: DecomposeOptions = ...,
        thin_parts: ThinPartOptions = ...,
        candidates: CandidateOptions = ...,
        search: SearchOptions = ...,
        trial: TrialOptions = ...,
        refine: RefineOptions = ...,
        rank: RankOptions = ...,
        paths: Optional[GraspPathOptions] = ...,
        robustness: bool = ...,
        uncertainty: UncertaintyOptions = ...,
        volumes: bool = ...,
        sections: int = ...,
    ) -> None: ...
    def __copy__(self) -> PlanOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> PlanOptions: ...

class EvaluateOptions:
    _fields: Tuple[str, ...]
    seed: int
    trial: TrialOptions
    robustness: bool
    uncertainty: UncertaintyOptions
    volumes: int
    sections: int
    def __init__(
        self,
        *,
        seed: int = ...,
        trial: TrialOptions = ...,
        robustness: bool = ...,
        uncertainty: UncertaintyOptions = ...,
        volumes: int = ...,
        sections: int = ...,
    ) -> None: ...
    def __copy__(self) -> EvaluateOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> EvaluateOptions: ...

class WrenchSpaceOptions:
    _fields: Tuple[str, ...]
    norm: Literal["l1", "linf"]
    cone: Literal["pyramid", "exact"]
    edges: int
    force: Literal["at_most", "exactly"]
    def __init__(
        self,
        *,
        norm: Literal["l1", "linf"] = ...,
        cone: Literal["pyramid", "exact"] = ...,
        edges: int = ...,
        force: Literal["at_most", "exactly"] = ...,
    ) -> None: ...
    def __copy__(self) -> WrenchSpaceOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> WrenchSpaceOptions: ...

class EpsilonOptions:
    _fields: Tuple[str, ...]
    relative_tolerance: float
    cutoff: float
    max_facets: int
    descent_steps: int
    def __init__(
        self,
        *,
        relative_tolerance: float = ...,
        cutoff: float = ...,
        max_facets: int = ...,
        descent_steps: int = ...,
    ) -> None: ...
    def __copy__(self) -> EpsilonOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> EpsilonOptions: ...

class SetHullOptions:
    _fields: Tuple[str, ...]
    relative_tolerance: float
    max_points: int
    def __init__(
        self,
        *,
        relative_tolerance: float = ...,
        max_points: int = ...,
    ) -> None: ...
    def __copy__(self) -> SetHullOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> SetHullOptions: ...

class NoiseOptions:
    _fields: Tuple[str, ...]
    pose_position: float
    pose_angle: float
    contact_position: float
    normal_angle: float
    friction: float
    samples: int
    seed: int
    def __init__(
        self,
        *,
        pose_position: float = ...,
        pose_angle: float = ...,
        contact_position: float = ...,
        normal_angle: float = ...,
        friction: float = ...,
        samples: int = ...,
        seed: int = ...,
    ) -> None: ...
    def __copy__(self) -> NoiseOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> NoiseOptions: ...

class ForceOptions:
    _fields: Tuple[str, ...]
    measure: Literal["largest_normal", "sum_of_normals"]
    cone: Literal["pyramid", "exact"]
    edges: int
    residual_tolerance: float
    gap_tolerance: float
    def __init__(
        self,
        *,
        measure: Literal["largest_normal", "sum_of_normals"] = ...,
        cone: Literal["pyramid", "exact"] = ...,
        edges: int = ...,
        residual_tolerance: float = ...,
        gap_tolerance: float = ...,
    ) -> None: ...
    def __copy__(self) -> ForceOptions: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> ForceOptions: ...

class Robot:
    @property
    def name(self) -> str: ...
    @property
    def is_hand(self) -> bool: ...
    @property
    def joints(self) -> List[str]: ...
    @property
    def dofs(self) -> List[str]: ...
    @property
    def links(self) -> List[str]: ...
    @property
    def dof_limits(self) -> _Floats: ...
    @property
    def initial(self) -> _Floats: ...
    @property
    def notes(self) -> List[str]: ...
    @property
    def tip_joint(self) -> int: ...
    @property
    def _preshapes(self) -> List[Tuple[str, _Floats, float, float]]: ...
    @property
    def _approach(self) -> _Floats: ...
    def _joint_values(self, dofs: _Floats, /) -> _Floats: ...
    def _link_poses(self, joints: _Floats, /) -> _Floats: ...
    def _joint_poses(self, joints: _Floats, /) -> _Floats: ...
    def _link_mesh(self, link: int, /) -> Tuple[_Floats, _Integers]: ...

class GraspableBody:
    @property
    def name(self) -> str: ...
    @property
    def vertices(self) -> _Floats: ...
    @property
    def faces(self) -> _Integers: ...
    @property
    def X_WO(self) -> _Floats: ...
    @property
    def material(self) -> str: ...
    @property
    def mass(self) -> float: ...
    @property
    def center_of_mass(self) -> _Floats: ...
    @property
    def mass_from(self) -> str: ...
    @property
    def inertia(self) -> _Floats: ...

class StaticBody:
    @property
    def name(self) -> str: ...
    @property
    def vertices(self) -> _Floats: ...
    @property
    def faces(self) -> _Integers: ...
    @property
    def X_WB(self) -> _Floats: ...
    @property
    def material(self) -> str: ...

class _Scene:
    @property
    def name(self) -> str: ...
    @property
    def object(self) -> GraspableBody: ...
    @property
    def hand(self) -> Robot: ...
    @property
    def notes(self) -> List[str]: ...
    @property
    def obstacles(self) -> List[StaticBody]: ...
    @property
    def platform(self) -> Optional[str]: ...
    def set_pose(self, X_WO: _Floats, /) -> None: ...
    def set_friction(
        self, a: str, b: str, friction: float, kinetic: Optional[float], /
    ) -> None: ...
    def friction(self, a: str, b: str, /) -> float: ...
    def set_mass(self, text: str, /) -> None: ...
    def mount(
        self, platform: bytes, hand: bytes, X_WB: _Floats, start: Dict[str, float], /
    ) -> None: ...
    def add_obstacle(
        self,
        name: str,
        vertices: _Floats,
        faces: _Integers,
        X_WB: _Floats,
        material: str,
        /,
    ) -> None: ...
    def save(self, file: bytes, /) -> None: ...
    def text(self) -> str: ...

class CompiledScene:
    @property
    def name(self) -> str: ...
    @property
    def hand(self) -> Robot: ...
    @property
    def object(self) -> GraspableBody: ...
    @property
    def robot(self) -> Optional[Robot]: ...
    @property
    def torque_origin(self) -> _Floats: ...
    @property
    def torque_scale(self) -> float: ...

class _CallOptions:
    def __init__(
        self,
        threads: int,
        progress: Optional[Callable[[Progress], object]],
        cancellation: Cancellation,
        budget: float,
        /,
    ) -> None: ...

class _Trial: ...

class _PlanResult:
    def fields(self) -> Dict[str, Any]: ...
    def grasp(self, grasp: int, /) -> Dict[str, Any]: ...

class _ContactSets:
    def __init__(
        self,
        positions: _Floats,
        normals: _Floats,
        friction: _Floats,
        torsion: _Floats,
        models: List[int],
        offsets: List[int],
        origins: _Floats,
        scales: _Floats,
        /,
    ) -> None: ...

class _MeasureOptions:
    def __init__(
        self,
        space: WrenchSpaceOptions,
        epsilon: Optional[EpsilonOptions],
        hull: SetHullOptions,
        noise: NoiseOptions,
        task: Tuple[str, _Floats],
        surface: _ContactSets,
        jacobian: Optional[_Floats],
        /,
    ) -> None: ...

def find_robot(name: bytes, /) -> Robot: ...
def find_platform(name: bytes, /) -> Robot: ...
def library_robot_names() -> List[str]: ...
def library_platform_names() -> List[str]: ...
def solve_near(robot: Robot, joints: List[int], X_JT: _Floats, X_BT: _Floats, start: _Floats, options: IkOptions, /) -> Optional[_Floats]: ...
def solve_all(robot: Robot, joints: List[int], X_JT: _Floats, X_BT: _Floats, start: _Floats, options: IkOptions, /) -> _Floats: ...
def load_scene(scene: bytes, hand: bytes, unit: str, repair: bool, /) -> _Scene: ...
def make_scene(vertices: _Floats, faces: _Integers, hand: bytes, name: str, material: str, mass: float, repair: bool, /) -> _Scene: ...
def compile_scene(scene: _Scene, /) -> CompiledScene: ...
def load_mesh(file: bytes, unit: str, /) -> Tuple[_Floats, _Integers]: ...
def library_scene_names() -> List[str]: ...
def read_tree_model(file: str, /) -> TreeModel: ...
def plan_options(accuracy: str, /) -> PlanOptions: ...
def plan(scene: CompiledScene, options: PlanOptions, call: _CallOptions, /) -> _PlanResult: ...
def evaluate(scene: CompiledScene, candidates: List[Dict[str, Any]], options: EvaluateOptions, call: _CallOptions, /) -> _PlanResult: ...
def run_trial(scene: CompiledScene, candidate: Dict[str, Any], options: TrialOptions, call: _CallOptions, /) -> Dict[str, Any]: ...
def decompose(vertices: _Floats, faces: _Integers, options: DecomposeOptions, call: _CallOptions, /) -> Dict[str, Any]: ...
def propose_grasps(scene: CompiledScene, primitives: List[Dict[str, Any]], count: int, options: CandidateOptions, call: _CallOptions, /) -> Dict[str, Any]: ...
def given_primitives(scene: CompiledScene, /) -> List[Dict[str, Any]]: ...
def plan_grasp_path(trial: _Trial, options: GraspPathOptions, call: _CallOptions, /) -> Optional[Dict[str, Any]]: ...
def grasps_json(plan: _PlanResult, /) -> bytes: ...
def timings_json(plan: _PlanResult, threads: int, /) -> str: ...
def remove_earlier_results(plan: _PlanResult, folder: str, written: List[str], /) -> None: ...
def report_html(plan: _PlanResult, call: _CallOptions, /) -> str: ...
def export_formats() -> List[str]: ...
def export_files(plan: _PlanResult, format: str, /) -> List[Tuple[str, bytes]]: ...
def grasp_picture(trial: _Trial, title: str, size: Tuple[int, int], direction: Optional[_Floats], /) -> _Bytes: ...
def arm_picture(trial: _Trial, title: str, size: Tuple[int, int], /) -> _Bytes: ...
def png_bytes(pixels: _Bytes, /) -> bytes: ...
def compare_executions(file: bytes, options: EvaluateOptions, volumes: bool, groups: str, resamples: int, call: _CallOptions, /) -> Tuple[bytes, bytes, bytes]: ...
def quality_epsilon(sets: _ContactSets, space: WrenchSpaceOptions, options: Optional[EpsilonOptions], call: _CallOptions, /) -> Dict[str, Any]: ...
def quality_measure(sets: _ContactSets, name: str, options: _MeasureOptions, call: _CallOptions, /) -> Tuple[_Floats, _Floats]: ...
def quality_robust_epsilon(sets: _ContactSets, space: WrenchSpaceOptions, noise: NoiseOptions, call: _CallOptions, /) -> _Floats: ...
def quality_balancing_forces(sets: _ContactSets, external: _Floats, options: ForceOptions, call: _CallOptions, /) -> List[Dict[str, Any]]: ...
def quality_wrench_resistance(sets: _ContactSets, external: _Floats, options: ForceOptions, call: _CallOptions, /) -> Tuple[_Floats, _Floats]: ...
def quality_grasp_matrix(sets: _ContactSets, grasp: int, /) -> _Floats: ...
def quality_contact_wrenches(sets: _ContactSets, grasp: int, edges: int, /) -> _Floats: ...
def quality_measures() -> List[str]: ...

class Drive:
    _fields: Tuple[str, ...]
    dof: int
    stiffness: float
    damping: float
    target: float
    target_rate: float
    holds_rate: bool
    max_effort: float
    def __init__(
        self,
        *,
        dof: int = ...,
        stiffness: float = ...,
        damping: float = ...,
        target: float = ...,
        target_rate: float = ...,
        holds_rate: bool = ...,
        max_effort: float = ...,
    ) -> None: ...
    def __copy__(self) -> Drive: ...
    def __deepcopy__(self, memo: Dict[Any, Any], /) -> Drive: ...

class _World:
    def __init__(self) -> None: ...
    def copy(self) -> _World: ...
    def gravity(self) -> _Floats: ...
    def set_gravity(self, gravity: _Floats, /) -> None: ...
    def set_friction(
        self, a: str, b: str, friction: float, kinetic: Optional[float], /
    ) -> None: ...
    def energy(self) -> float: ...
    def contacts(
        self,
    ) -> List[Tuple[str, str, _Floats, _Floats, _Floats, float, float]]: ...
    def step(self, longest: float, /) -> Tuple[str, float, int, float]: ...
    def add_robot(
        self, robot: Robot, name: str, X_WB: _Floats, dofs: _Floats, /
    ) -> int: ...
    def robots(self) -> int: ...
    def robot_name(self, robot: int, /) -> str: ...
    def robot(self, robot: int, /) -> Robot: ...
    def positions(self, robot: int, /) -> _Floats: ...
    def set_positions(self, robot: int, dofs: _Floats, /) -> None: ...
    def rates(self, robot: int, /) -> _Floats: ...
    def set_rates(self, robot: int, rates: _Floats, /) -> None: ...
    def joints(self, robot: int, /) -> _Floats: ...
    def base(self, robot: int, /) -> _Floats: ...
    def set_base(self, robot: int, X_WB: _Floats, /) -> None: ...
    def efforts(self, robot: int, /) -> _Floats: ...
    def set_efforts(self, robot: int, efforts: _Floats, /) -> None: ...
    def max_efforts(self, robot: int, /) -> _Floats: ...
    def drives(self, robot: int, /) -> List[Drive]: ...
    def set_drives(self, robot: int, drives: List[Drive], /) -> None: ...
    def add_body(
        self,
        name: str,
        vertices: _Floats,
        faces: _Integers,
        X_WB: _Floats,
        material: str,
        mass: Optional[float],
        restitution: float,
        /,
    ) -> int: ...
    def add_bodies(self, scene: _Scene, /) -> None: ...
    def bodies(self) -> int: ...
    def body_name(self, body: int, /) -> str: ...
    def body_mass(self, body: int, /) -> Optional[float]: ...
    def body_pose(self, body: int, /) -> _Floats: ...
    def set_body_pose(self, body: int, X_WB: _Floats, /) -> None: ...
    def body_velocity(self, body: int, /) -> Tuple[_Floats, _Floats]: ...
    def set_body_velocity(
        self, body: int, linear: _Floats, angular: _Floats, /
    ) -> None: ...
    def body_force(self, body: int, /) -> _Floats: ...
    def set_body_force(self, body: int, force_W: _Floats, /) -> None: ...

class ControlState:
    @property
    def time(self) -> float: ...
    @property
    def step(self) -> float: ...
    @property
    def positions(self) -> _Floats: ...
    @property
    def rates(self) -> _Floats: ...
    @property
    def joints(self) -> _Floats: ...
    @property
    def X_WB(self) -> _Floats: ...
    @property
    def gravity(self) -> _Floats: ...

class Controller:
    def __call__(self, state: ControlState, /) -> _Floats: ...

class Motion:
    def __call__(self, time: float, /) -> _Floats: ...

def control_state(
    world: _World, robot: int, time: float, step: float, /
) -> ControlState: ...
def critically_damped(
    world: _World, robot: int, frequency: float, /
) -> Tuple[_Floats, _Floats]: ...
def stated_gains(
    world: _World, robot: int, frequency: float, /
) -> Tuple[_Floats, _Floats]: ...
def set_points(robot: Robot, preshape: str, /) -> _Floats: ...
def pd_drives(
    world: _World,
    robot: int,
    stiffness: _Floats,
    damping: _Floats,
    values: _Floats,
    /,
) -> List[Drive]: ...
def pd_controller(
    world: _World,
    robot: int,
    stiffness: _Floats,
    damping: _Floats,
    motion: object,
    /,
) -> Controller: ...
def gravity_compensation() -> Controller: ...
def computed_torque(
    world: _World, robot: int, motion: object, frequency: float, /
) -> Controller: ...
def wrist_impedance(
    world: _World,
    robot: int,
    joint: int,
    X_WT: _Floats,
    stiffness: float,
    turning_stiffness: float,
    damping_ratio: float,
    /,
) -> Controller: ...
def sum_of(controllers: List[Any], /) -> Controller: ...
def motion_along(
    world: _World,
    robot: int,
    joints: List[str],
    times: _Floats,
    positions: _Floats,
    velocities: _Floats,
    rest: _Floats,
    /,
) -> Motion: ...
def run_controlled(
    world: _World,
    controllers: List[Tuple[int, Any]],
    seconds: float,
    step: float,
    stops: Optional[Callable[[float], bool]],
    cancellation: Optional[Cancellation],
    /,
) -> Tuple[str, float, int, int, str]: ...
