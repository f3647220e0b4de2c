#include "planner/plan/plan_options.h"
#include "planner/plan/refine_grasps.h"
#include "planner/python/options_class.h"
#include "planner/results/json_settings.h"

namespace prehend::python {
namespace {

void bind_proposal_options(py::module_& core) {
  OptionsClass<DecomposeOptions>(core, "DecomposeOptions",
                                 "How a mesh is split into boxes, spheres and cylinders.")
      .number("tolerance", &DecomposeOptions::tolerance,
              "A surface point is explained when it lies within this fraction of the bounding-box "
              "diagonal of some primitive; in (0, 1].")
      .number("coverage", &DecomposeOptions::coverage,
              "Pieces are added until this fraction of the area is explained; in (0, 1].")
      .number("points", &DecomposeOptions::points,
              "So many points stand for the surface (>= 100); more take longer.")
      .number("max_primitives", &DecomposeOptions::max_primitives,
              "At most this many primitives (>= 1). Wins over coverage.")
      .number("seed", &DecomposeOptions::seed, kAtLeast0, "Of the sampled surface points.");
  OptionsClass<CandidateOptions>(core, "CandidateOptions", "Which grasps are proposed.")
      .number("duplicate_distance", &CandidateOptions::duplicate_distance,
              "Two candidates closer than this and duplicate_angle, with the same preshape, are "
              "one; half of both at each level of detail [m].")
      .number("duplicate_angle", &CandidateOptions::duplicate_angle,
              "See duplicate_distance [rad].")
      .number("start_clearance", &CandidateOptions::start_clearance,
              "Added to the way from the pre-grasp to the object [m].");
  OptionsClass<ThinPartOptions>(core, "ThinPartOptions",
                                "What counts as a rim or a bar, relative to the object's diagonal.")
      .number("rim_width", &ThinPartOptions::rim_width,
              "Thickest wall whose edge is a rim; in [0, 1], 0: no rims.")
      .number("bar_width", &ThinPartOptions::bar_width, "Widest bar; in [0, 1], 0: no bars.")
      .number("most_rims", &ThinPartOptions::most_rims, "So many, the longest (>= 0).")
      .number("most_bars", &ThinPartOptions::most_bars, "So many, the longest (>= 0).")
      .number("points", &ThinPartOptions::points,
              "So many points of the surface are looked at (>= 100).")
      .number("seed", &ThinPartOptions::seed, kAtLeast0, "Of these points.");
  OptionsClass<SearchOptions>(core, "SearchOptions",
                              "How many candidates are tried, and in which order.")
      .number("trials", &SearchOptions::trials,
              "Trials at most, without those whose hand is blocked on its way (>= 1).")
      .number("most_blocked", &SearchOptions::most_blocked,
              "Times `trials`: candidates at most whose hand is blocked on its way (>= 0).")
      .number("enough", &SearchOptions::enough,
              "Stable grasps after which the search ends; 0: after all trials (>= 0).")
      .number("batch", &SearchOptions::batch,
              "Candidates that are chosen together, from all trials before (>= 1).")
      .number("follow", &SearchOptions::follow,
              "The part of a batch that lies beside the best grasps so far, in 0 .. 1.")
      .number("followed", &SearchOptions::followed, "So many of the best grasps are followed.")
      .number("well_served", &SearchOptions::thin_parts_if_epsilon_below,
              "While no grasp has this epsilon, rims and bars are tried as well (>= 0).")
      .number("solids_first", &SearchOptions::thin_parts_after_fraction,
              "The part of the trials before those of rims and bars, in 0 .. 1.")
      .number("curves_least", &SearchOptions::thin_parts_min_fraction,
              "The part of the trials that rims and bars then get at least, in 0 .. 1.")
      .number("patience", &SearchOptions::trials_before_extra_back_offs,
              "After so many trials of which none has held, the hand backs off more (>= 0).")
      .number("patient_back_offs", &SearchOptions::extra_back_offs,
              "How often it backs off then, if a trial does not anyway (>= 0).")
      .field("learned", &SearchOptions::learned,
             "LearnedOrder: a model that orders the candidates. None: as they are proposed.");
}

void bind_contact_options(py::module_& core) {
  OptionsClass<ContactOptions>(core, "ContactOptions", "What counts as a contact.")
      .number("threshold", &ContactOptions::threshold, "Surfaces closer than this touch [m].")
      .number("evenness", &ContactOptions::evenness,
              "Points of a face contact this much farther than its nearest still count [m].")
      .number("angular_tolerance", &ContactOptions::angular_tolerance,
              "Sine of the angle within which normals count as one.")
      .number("max_region_corners", &ContactOptions::max_region_corners,
              "A region of contact keeps at most this many corners (>= 3).")
      .number("same_place", &ContactOptions::same_place,
              "Points with one normal nearer than this part of the threshold are one.")
      .number("flat_corner", &ContactOptions::flat_corner,
              "Corners of a region that stand out by less than this part of the threshold are left "
              "out.")
      .number("weakest_patch", &ContactOptions::weakest_patch,
              "Patches that bear less than this part of the strongest's force are left out.");
}

void bind_reach_options(py::module_& core) {
  OptionsClass<MotionCheckOptions>(core, "MotionCheckOptions",
                                   "How motions are proven free of collision.")
      .number("tightest", &MotionCheckOptions::tightest,
              "Stretches on which nothing moves more than this are not cut any further [m].")
      .number("gap_error", &MotionCheckOptions::gap_error,
              "Part by which a gap may be underestimated; in [0, 1).");
  OptionsClass<IkOptions>(core, "IkOptions", "Inverse kinematics.")
      .number("position_tolerance", &IkOptions::position_tolerance, "[m]")
      .number("angle_tolerance", &IkOptions::angle_tolerance, "[rad]")
      .number("max_iterations", &IkOptions::max_iterations, "From one start (>= 1).")
      .number("restarts", &IkOptions::restarts, "Random starts, after the given one.")
      .number("max_solutions", &IkOptions::max_solutions, "No more are looked for (>= 1).")
      .number("seed", &IkOptions::seed, kAtLeast0, "Of the random starts.");
  OptionsClass<ReachOptions>(core, "ReachOptions", "How an arm follows the hand's approach.")
      .field("kinematics", &ReachOptions::kinematics, "IkOptions.")
      .number("line_step", &ReachOptions::line_step,
              "The approach is followed in steps of this [m].")
      .number("largest_joint_step", &ReachOptions::largest_joint_step,
              "More change of a joint in one step is a jump to another branch [rad or m].")
      .field("motion", &ReachOptions::motion, "MotionCheckOptions.");
}

void bind_error_options(py::module_& core) {
  OptionsClass<OverlapOptions>(
      core, "GiveWayOptions",
      "Overlaps at the start that are resolved instead of ending the trial.")
      .number("object", &OverlapOptions::object, "Of hand and object, up to this [m].")
      .number("obstacle", &OverlapOptions::obstacle, "Of hand and obstacles [m].")
      .number("deepest", &OverlapOptions::deepest,
              "How deep an overlap that stays is measured; 0: it is not [m].");
  OptionsClass<UncertaintyOptions>(
      core, "UncertaintyOptions",
      "Standard deviations of what is not known when a grasp is carried out.")
      .number("samples", &UncertaintyOptions::samples, "Disturbed trials of a grasp (>= 1).")
      .number("across", &UncertaintyOptions::across,
              "Of the object, along each horizontal axis [m].")
      .number("along", &UncertaintyOptions::along, "Of the object, along gravity [m].")
      .number("angle", &UncertaintyOptions::angle, "Of the object, about each axis [rad].")
      .number("hand", &UncertaintyOptions::hand, "Of the hand, along each axis [m].")
      .number("hand_angle", &UncertaintyOptions::hand_angle, "Of the hand, about each axis [rad].")
      .number("friction", &UncertaintyOptions::friction,
              "Of the logarithm of each friction coefficient.")
      .number("center_of_mass", &UncertaintyOptions::center_of_mass,
              "Of the centre of mass, along each axis, as a part of the object's size.");
}

void bind_settle_options(py::module_& core) {
  OptionsClass<SettleOptions>(core, "SettleOptions",
                              "How an object settles between two self-centering fingers that do "
                              "not hold it.")
      .number("angle", &SettleOptions::angle, "Largest turn of a step [rad].")
      .number("slide", &SettleOptions::slide,
              "Farthest that the object moves between the fingers in a step [m].")
      .number("steps", &SettleOptions::steps,
              "Steps that are tried at most; 0: the object stays where it is.")
      .number("least_part", &SettleOptions::least_part,
              "A step that does not help is tried again at half its size, down to this part.")
      .number("loosen", &SettleOptions::loosen, "Fingers open by this before the object moves [m].")
      .number("least_gain", &SettleOptions::least_gain,
              "Settling goes on while the fingers come closer by more than this in a step [m].")
      .number("least_force", &SettleOptions::least_force,
              "Sum of the fingers' forces, as a part of one, below which they balance.")
      .number("least_arm", &SettleOptions::least_arm,
              "And distance between their lines of action [m].");
}

void bind_trial_options(py::module_& core) {
  OptionsClass<GapTrackerOptions>(core, "GapTrackerOptions",
                                  "How the gap between two moving bodies is asked for: all answers "
                                  "are proven bounds, looser ones cost less.")
      .number("near", &GapTrackerOptions::near, "Triangle pairs are listed within this gap [m].")
      .number("reach", &GapTrackerOptions::reach,
              "How far the list reaches, as a multiple of the gap (>= 1).")
      .number("least_reach", &GapTrackerOptions::least_reach, "And at least by so much [m].")
      .number("most_pairs", &GapTrackerOptions::most_pairs, "No list longer than this is kept.")
      .number("looseness", &GapTrackerOptions::relative_error,
              "Part by which a query may be off that only says how far to go; in [0, 1).");
  OptionsClass<DynamicGraspOptions>(core, "FormationOptions",
                                    "A hand that closes in time, on an object that gives way.")
      .field("dynamic", &DynamicGraspOptions::dynamic,
             "Whether it does; else the object stands still.")
      .number("gravity", &DynamicGraspOptions::gravity,
              "Where the scene has obstacles to stand on; else there is none [m/s^2].")
      .number("settle", &DynamicGraspOptions::settle,
              "Longest time in which the object comes to rest at first [s].")
      .number("close", &DynamicGraspOptions::close, "Longest time in which the hand closes [s].")
      .number("lift", &DynamicGraspOptions::lift,
              "The closed hand rises by this, where the object stands on something [m].")
      .number("lift_time", &DynamicGraspOptions::lift_time, "In this time [s].")
      .number("step", &DynamicGraspOptions::step, "Of the simulation [s].");
  OptionsClass<TrialOptions>(core, "TrialOptions",
                             "The one dial between speed and accuracy of a trial.")
      .field("contact", &TrialOptions::contact, "ContactOptions.")
      .number("contact_gap", &TrialOptions::contact_gap,
              "Motions end at this gap; below 0.9 contact.threshold [m].")
      .field("give_way", &TrialOptions::resolve_overlap, "GiveWayOptions.")
      .number("obstacle_clearance", &TrialOptions::obstacle_clearance,
              "A hand that an obstacle stops goes back by this and closes there [m].")
      .number("back_off_step", &TrialOptions::back_off_step,
              "When a grasp does not hold, the hand goes back by this and closes again [m].")
      .number("back_off_tries", &TrialOptions::back_off_tries, "How often it does.")
      .field("soft_fingers", &TrialOptions::soft_fingers,
             "Whether soft links bear on patches, with torque about the normal; if not, all "
             "contacts are hard points.")
      .field("settle", &TrialOptions::settle, "SettleOptions.")
      .number("cone_edges", &TrialOptions::cone_edges,
              "Edges of the pyramid that stands for a friction cone (>= 3).")
      .field("reach", &TrialOptions::reach, "ReachOptions, for scenes with an arm.")
      .number("max_gap_queries", &TrialOptions::max_gap_queries,
              "A pair of bodies is asked for its gap at most this often in one motion.")
      .field("gaps", &TrialOptions::gaps, "GapTrackerOptions.")
      .field("formation", &TrialOptions::formation, "FormationOptions.");
}

void bind_path_options(py::module_& core) {
  OptionsClass<TransferOptions>(core, "TransferOptions",
                                "How an arm's way to the pre-grasp is searched for.")
      .choice("planner", &TransferOptions::planner,
              {{"rrt_connect", PathPlanner::rrt_connect},
               {"roadmap", PathPlanner::roadmap},
               {"rrt_star", PathPlanner::rrt_star}},
              R"("rrt_connect", "roadmap" or "rrt_star".)")
      .number("max_iterations", &TransferOptions::max_iterations, "Of the planner.")
      .number("simplify_steps", &TransferOptions::simplify_steps, "Tries to cut a corner short.")
      .number("longest_edge", &TransferOptions::longest_edge,
              "Longest edge that a tree grows at once, as a motion of the arm [m].")
      .number("corner_deviation", &TransferOptions::corner_deviation,
              "How far the motion may pass from its corners, 0: it stops there [m].")
      .number("seed", &TransferOptions::seed, kAtLeast0, "Of the search.")
      .field("motion", &TransferOptions::motion, "MotionCheckOptions.");
  OptionsClass<TimePathOptions>(core, "TimePathOptions", "How a path is timed.")
      .number("sample_time", &TimePathOptions::sample_time,
              "Longest time between two samples [s].");
  OptionsClass<PathCheckOptions>(core, "PathCheckOptions",
                                 "How a finished path is looked at again.")
      .number("step", &PathCheckOptions::step,
              "Longest motion of any point of a link between two postures [m].");
  OptionsClass<LiftOptions>(core, "LiftOptions", "What comes after a grasp.")
      .number("height", &LiftOptions::height,
              "How far the object is lifted straight up, 0: not at all [m].")
      .field("retreat", &LiftOptions::retreat, "Whether the arm then goes back to its start.")
      .number("leave_within", &LiftOptions::leave_within,
              "Way within which what touches has to be apart [m].");
  OptionsClass<GraspPathOptions>(core, "GraspPathOptions", "The whole way of an arm to a grasp.")
      .field("reach", &GraspPathOptions::reach, "ReachOptions.")
      .field("transfer", &GraspPathOptions::transfer, "TransferOptions.")
      .field("timing", &GraspPathOptions::timing, "TimePathOptions.")
      .number("alternatives", &GraspPathOptions::alternatives,
              "Postures of the pre-grasp that are tried (>= 1).")
      .field("check", &GraspPathOptions::check, "PathCheckOptions: of the finished path.")
      .field("lift", &GraspPathOptions::lift, "LiftOptions.");
}

void bind_refine_options(py::module_& core) {
  OptionsClass<RefineOptions>(core, "RefineOptions",
                              "How the best grasps are improved by trials of grasps near them.")
      .choice("objective", &RefineOptions::objective,
              {{"epsilon", RefineObjective::epsilon}, {"robust", RefineObjective::robust}},
              R"(What is made larger: "epsilon", or "robust", its mean under random errors.)")
      .number("grasps", &RefineOptions::grasps,
              "So many of the grasps, the best ones, are refined (>= 1).")
      .number("trials", &RefineOptions::trials, "Most trials for all of them together.")
      .number("turn", &RefineOptions::turn,
              "First turn of the hand that is tried, about the middle of its contacts [rad].")
      .number("shift", &RefineOptions::shift, "First shift of the hand [m].")
      .number("spread", &RefineOptions::spread,
              "First change of the degrees of freedom that do not close; 0: none [rad or m].")
      .number("reach", &RefineOptions::reach,
              "No change is larger than the first one times this (>= 1).")
      .field("noise", &RefineOptions::noise, "NoiseOptions, for the objective \"robust\".");
}

}  // namespace

void bind_options(py::module_& core) {
  bind_proposal_options(core);
  bind_contact_options(core);
  bind_reach_options(core);
  bind_error_options(core);
  bind_settle_options(core);
  bind_trial_options(core);
  bind_path_options(core);
  bind_refine_options(core);
  OptionsClass<RankOptions>(core, "RankOptions", "Which grasps are returned.")
      .number("top", &RankOptions::top, "So many grasps (>= 1).")
      .choice("by", &RankOptions::by,
              {{"epsilon", RankBy::epsilon},
               {"probability", RankBy::probability},
               {"success", RankBy::success}},
              R"("epsilon", "probability" or "success"; the last two need PlanOptions.robustness.)")
      .number("pool", &RankOptions::pool,
              "Not by epsilon: so many times `top` grasps are tried with errors (>= 1).")
      .number("same_distance", &RankOptions::same_distance,
              "Grasps whose hands are closer than this and same_angle are one [m].")
      .number("same_angle", &RankOptions::same_angle, "See same_distance [rad].")
      .number("same_contact", &RankOptions::same_contact,
              "So are grasps whose contacts are all closer than this [m].");
  OptionsClass<PlanOptions>(core, "PlanOptions", "All that a plan depends on besides its scene.")
      .number("seed", &PlanOptions::seed,
              "Everything random in the plan derives from it; seeds further down are set from it.")
      .field("primitives", &PlanOptions::primitives, "DecomposeOptions.")
      .field("thin_parts", &PlanOptions::thin_parts, "ThinPartOptions.")
      .field("candidates", &PlanOptions::candidates, "CandidateOptions.")
      .field("search", &PlanOptions::search, "SearchOptions.")
      .field("trial", &PlanOptions::trial, "TrialOptions.")
      .field("refine", &PlanOptions::refine,
             "RefineOptions; at most a fifth of the trials of the search are made.")
      .field("rank", &PlanOptions::rank, "RankOptions.")
      .field("paths", &PlanOptions::paths,
             "GraspPathOptions: paths for the grasps that are returned, those without one are left "
             "out; needs an arm. None: no paths.")
      .field("robustness", &PlanOptions::robustness,
             "Whether the returned grasps are tried again with errors of pose, friction and centre "
             "of mass.")
      .field("uncertainty", &PlanOptions::uncertainty, "UncertaintyOptions: how large these are.")
      .field("volumes", &PlanOptions::volumes,
             "Whether the volume, epsilon_nearby and holding of the grasps are computed; else nan "
             "and None.")
      .number("sections", &PlanOptions::sections, kAtLeast0,
              "So many of the grasps get sections of their wrench space, for the report.");
  core.def("plan_options", &read_accuracy);
  OptionsClass<EvaluateOptions>(core, "EvaluateOptions", "All that an evaluation depends on.")
      .number("seed", &EvaluateOptions::seed, kAtLeast0, "As in PlanOptions.")
      .field("trial", &EvaluateOptions::trial, "TrialOptions.")
      .field("robustness", &EvaluateOptions::robustness, "As in PlanOptions.")
      .field("uncertainty", &EvaluateOptions::uncertainty, "As in PlanOptions.")
      .number("volumes", &EvaluateOptions::volumes, kAtLeast0,
              "So many of the grasps, the first ones, get a volume, which takes about 50 times as "
              "long as the trial itself; nan for the others.")
      .number("sections", &EvaluateOptions::sections, kAtLeast0,
              "As in PlanOptions, at most as many as volumes.");
}

}  // namespace prehend::python
