// A live session: one scene that is edited, a hand that is moved and closed in it, and the grasps
// that were planned from there. Everything can be undone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planner/live/arm_posture.h"
#include "planner/live/body_motion.h"
#include "planner/live/edited_scene.h"
#include "planner/live/grasp_in_hand.h"
#include "planner/live/grasp_score.h"
#include "planner/live/hand_posture.h"
#include "planner/live/moving_world.h"
#include "planner/live/open_folders.h"
#include "planner/live/plan_job.h"
#include "planner/live/scene_edits.h"
#include "planner/plan/object_primitives.h"
#include "sim/base/named_enum.h"

namespace prehend {

// What the user has switched on.
struct Switches {
  bool stop_at_contact = true;  // motions of the hand end where it touches
  bool soft_fingers = true;     // as TrialOptions::soft_fingers
};

// A hand that was put aside to be compared.
struct PinnedGrasp {
  std::string name;  // unique
  std::string hand;  // name of the robot
  HandPosture posture;
  double epsilon = 0.0;  // lower bound
};

// All that a session is at one moment. A value: heavy parts are shared and never change.
struct SessionState {
  EditedScenePtr world;
  HandPosture hand;
  Switches switches;
  JudgeOptions judge;
  std::optional<ArmPosture> arm;   // none where no platform carries the hand
  std::optional<Outcome> outcome;  // of the last auto-grasp, while the hand stays as it left it
  // Where the grasp in hand came from, as long as `outcome`; null where nobody knows.
  std::shared_ptr<const TriedGrasp> grasp;
  std::shared_ptr<const PlanResult> results;  // of the last plan in this world; null: none
  std::vector<PinnedGrasp> pins;
};

struct SessionOptions {
  OpenFolders folders = {};  // whose files commands may name
  int threads = 0;           // of plans; 0: one per processor
  // That the states on the stacks of undo and redo may take together, besides the present one and
  // what they share with it (StateMemory) [bytes].
  std::size_t undo_memory = std::size_t{512} << 20U;
};

// How many states undo() goes back, and no farther than SessionOptions::undo_memory. Each holds
// what it does not share with its neighbours: after an edit of the scene a compiled scene, which is
// about a megabyte for small objects and 360 bytes a triangle for large ones, else a few hundred
// bytes (of bodies that were moved, too).
inline constexpr std::size_t kMostUndo = 1000;

// A number that names a gesture, such as the dragging of one body: all motions of the same thing
// that follow each other with the same number are one step for undo(). Nothing: a step of its own.
using Gesture = std::optional<int>;

// How a path to the grasp in hand was found, and in which world.
struct PlannedPath {
  EditedScenePtr world;
  HandPosture hand;
  GraspPlayback playback;
};

enum class PathEnd { found, not_found, cancelled };
constexpr auto enum_names(PathEnd /*of*/) {
  return std::to_array<std::string_view>({"found", "not_found", "cancelled"});
}

// A refinement of the grasp in hand.
struct Refined {
  double before = 0.0;  // epsilon, lower bound
  double after = 0.0;   // the same where nothing better was found
  int trials = 0;       // that were made
};

// Not for several threads at once, but for the flags of plan_cancellation and path_cancellation.
// Every function that changes the session either succeeds or throws and leaves all as it was. It
// throws InputError for what is not there or does not fit, of the field that the protocol calls it
// by. The same calls give the same session, byte for byte, on any number of threads.
class Session {
 public:
  // Begins with a free hand (kDefaultHand) and no object.
  explicit Session(SessionOptions options = {});

  const SessionState& state() const { return state_; }
  const OpenFolders& folders() const { return options_.folders; }
  // Counts changes, undone ones as well.
  std::uint64_t revision() const { return revision_; }

  // Undo and redo of every change. False where there is nothing.
  bool undo();
  bool redo();
  std::size_t undo_count() const { return undo_.size(); }
  std::size_t redo_count() const { return redo_.size(); }

  // --- The world. While a plan or a path is looked for these are refused, and so are undo() and
  // redo().
  // A new scene; the hand stands at its start (start_posture).
  void set_scene(Scene scene);
  // From now on there is nothing to undo or redo.
  void forget_history();
  // Changes a copy of the scene. The hand stays where it is in the world, in its posture where it
  // is still the same hand. Results of a plan are forgotten, for they are about another world.
  void edit(const std::function<void(Scene&)>& change);

  // Move the object or an obstacle straight there, turning evenly, as the hand below: with
  // stop_at_contact until it would touch the robot or another body. The hand stays where it is in
  // the world. Results of a plan are forgotten.
  BodyMotion move_object(const Pose& X_WO, Gesture gesture = {});
  BodyMotion move_obstacle(const std::string& name, const Pose& X_WB, Gesture gesture = {});

  void set_switches(const Switches& switches);
  // How quality() judges from now on. Throws InputError of the field "edges" outside of
  // kJudgedEdges, and of "fixed" for coordinates that are not three different ones.
  void set_judge(const JudgeOptions& judge);

  // --- The hand. With stop_at_contact and in a world that is ready it moves until it touches;
  // otherwise it goes all the way, through whatever is there.
  // An arm follows where it can (follow_hand).
  HandMotion move_hand(const Pose& X_OH, Gesture gesture = {});
  // Values beyond limits are taken as the limits; coupled joints follow.
  HandMotion set_dofs(const std::vector<double>& dofs, Gesture gesture = {});
  HandMotion take_preshape(const std::string& name);
  // Each degree of freedom that closes goes to its other limit.
  HandMotion open_hand();
  // Back against the approach direction of the hand by `distance` [m], >= 0.
  HandMotion back_off(double distance);
  // Along the approach direction until a link touches the object or an obstacle. Stays where it is
  // when nothing is within `distance` [m] (MotionEnd::arrived with a share of 0).
  HandMotion approach(double distance);
  // Closes the hand from where it is, as a trial of the candidate without an approach does
  // (run_hand_trial): the arm, where there is one, is not asked. A hand that overlaps something
  // stays as it is; the outcome says so.
  Trial auto_grasp();
  // Improves the grasp in hand by at most so many trials close to it (refine_grasps), on the
  // threads of plans. Nothing changes where none is better. Throws InputError for a hand that does
  // not hold the object, and of the field "trials" outside of kRefineTrials.
  Refined refine(int trials, std::uint64_t seed);
  static constexpr Range kRefineTrials{.lower = 2.0, .upper = 2000.0};

  // --- The arm. All throw InputError of the field "command" without one.
  std::vector<ArmBranch> branches() const;
  // Takes the hand with that posture of branches(); others are refused.
  void choose_branch(std::size_t branch);
  // One value for each degree of freedom in CompiledArm::dofs; beyond a limit they end at it. The
  // hand moves along, both as motions of the hand do. An arm that does not hold the hand takes it
  // to where it is itself.
  ArmMotion set_arm(const std::vector<double>& values, Gesture gesture = {});
  // The arm, for its names and limits; null without one, or where it was never ready.
  const CompiledArm* arm() const;
  // Throws InputError also of the field "scene" where the world is not ready.
  const CompiledArm& require_arm() const;

  // --- Queries.
  Pose X_WH() const { return state_.world->X_WO() * state_.hand.X_OH; }
  std::vector<GraspContact> contacts() const;
  GraspScore quality(bool sections = false) const;  // as judge_grasp_of with SessionState::judge
  // As forces_for.
  ContactForces forces(const Vector3& force_O, const Vector3& torque_O, bool joint_limits) const;
  // Of the hand and, where it holds the hand, of the arm.
  std::vector<Overlap> collisions() const;
  // Those of the object from which a plan makes its grasps, unless it has another seed. They are
  // looked for when the surface is another one than at the last call; the reference holds until the
  // next. Throws InputError of the field "scene" without an object.
  const ObjectPrimitives& primitives();

  // --- Plans and paths. One at a time, either of them.
  void start_plan(const PlanOptions& options, const PlanListener& listener = {});
  bool is_planning() const { return job_ != nullptr; }
  // A flag that ends the running plan early, from any thread; nothing where none runs.
  std::optional<Cancellation> plan_cancellation() const;
  // Waits for the running plan and keeps its results. Those of a plan that was cut short depend on
  // when that was: they are kept as a file of grasps has them, and returned as its text, so that
  // keep_results with that text gives the same session. Empty for a complete plan.
  std::string finish_plan();
  // Ends the running plan, if any, and keeps the results that a file of grasps has instead.
  void keep_results(const std::string& grasps_file);
  // How the robot comes to the grasp in hand (play_grasp). Throws InputError for a hand that does
  // not hold the object.
  void start_path(std::uint64_t seed, bool lift, const PlanListener& listener = {});
  bool is_finding_path() const { return path_job_ != nullptr; }
  std::optional<Cancellation> path_cancellation() const;
  // Waits for the search and keeps what it has found. What play_grasp refuses is a problem of the
  // playback.
  PathEnd finish_path();
  // Ends the search as one that was cancelled, whatever it has found.
  void give_up_path();
  // The last that was found or not. Throws InputError of the field "command" where there is none or
  // the hand or the scene have changed since it was started.
  const PlannedPath& path() const;
  // That of a result, counted from 0. Throws InputError of the field "grasp" where it has none.
  PlannedPath path_of(std::size_t result) const;

  // The hand as in a result, counted from 0.
  void go_to(std::size_t result);
  // The results as files of a format (export_files), or grasps.json.
  std::string grasps_text() const;

  void pin(const std::string& name);
  void unpin(const std::string& name);
  // The hand as it was pinned, through whatever is there. Throws for a pin of another hand.
  void go_to_pin(const std::string& name);

  // --- Time. The scene and the hand in motion from where they are (moving_world.h). While time
  // runs the state stays what it was at the start; what would change its scene or hand is refused,
  // and so are undo() and redo(). The others throw where time does not run.
  void start_time(const TimeOptions& options);
  bool is_moving() const { return time_ != nullptr; }
  const MovingWorld& time() const;
  MovingWorld& moving();
  // Back to the start, with its drives.
  void reset_time();
  // `keep`: the object's pose and the hand's posture become the session's, one step of undo.
  void stop_time(bool keep);

 private:
  // A state on the stacks: of a world that is another one with bodies elsewhere, only that one and
  // the places.
  struct KeptState {
    SessionState state;
    std::optional<BodyPlaces> places;
  };
  // A gesture that goes on, and what it moves.
  struct Dragged {
    int number = 0;
    std::string what;
    bool operator==(const Dragged&) const = default;
  };

  static KeptState kept(SessionState state);
  static SessionState restored(KeptState kept);
  void limit_undo();
  void push(SessionState next, const std::optional<Dragged>& dragged = {});
  // No plan and no time.
  void require_no_plan() const;
  void require_no_running_plan() const;
  void require_still() const;
  // The same, for a change that would be this one.
  void require_still(const SessionState& next) const;
  HandMotion go(const HandPosture& to, const std::optional<Dragged>& dragged = {});
  HandMotion go_to_dofs(std::vector<double> dofs, const std::optional<Dragged>& dragged = {});
  // Throws InputError for a pose that is too far away (kCoordinate).
  static void require_place(const Pose& X);
  BodyMotion move_body(BodyId body, const Pose& X_WB, const std::optional<Dragged>& dragged);
  void settle_arm(SessionState& next) const;
  void hold_arm(SessionState& next, const DofValues& dofs) const;
  TriedGrasp grasp_in_hand() const;
  const ScoredGrasp& result_at(std::size_t result) const;
  TrialOptions trial_options() const;
  Trial as_trial() const;
  PlanResult as_read(const std::string& text) const;

  struct Time {
    MovingWorld start;
    MovingWorld now;
  };

  struct FoundPrimitives {
    std::string surface;  // SurfaceIds::object; empty: of a scene that states its primitives
    ObjectPrimitives primitives;
  };

  SessionOptions options_;
  SessionState state_;
  std::vector<KeptState> undo_;
  std::vector<KeptState> redo_;
  std::optional<Dragged> dragged_;  // by the last change
  std::uint64_t revision_ = 0;
  std::unique_ptr<PlanJob> job_;
  std::unique_ptr<PlannedPath> path_;                // of the last search, from its start on
  std::unique_ptr<PathJob> path_job_;                // that is to give its playback
  std::unique_ptr<Time> time_;                       // null: nothing moves
  std::optional<FoundPrimitives> found_primitives_;  // by the last call of primitives()
};

}  // namespace prehend
