#include "planner/plan/find_advice.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "planner/plan/run_trials.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/quality/wrench.h"
#include "sim/robot/files/robot_file.h"
#include "sim/trial/grasp_contacts.h"

namespace prehend {
namespace {

// Limits of the time that advice takes; they do not have to be exact to be useful.
constexpr int kMostTrials = 60;              // of one variant of the scene
constexpr std::size_t kMostJudgements = 60;  // of one coefficient of friction

// The tolerance of the primitives that is tried in place of a coarser one.
constexpr double kFineTolerance = 0.02;

// How many of the candidates that were tried hold.
struct Held {
  int held = 0;
  int tried = 0;

  std::string words() const {
    return std::to_string(held) + " of " + std::to_string(tried) + " candidates";
  }
};

int count_of(const PlanResult& result, Outcome outcome) { return result.outcomes[outcome]; }

// Makes the hints one after the other.
class Adviser {
 public:
  Adviser(const CompiledScene& scene, const PlanOptions& options, const PlanResult& result,
          const std::vector<Trial>& tried, const RunContext& context)
      : scene_(scene),
        options_(options),
        result_(result),
        tried_(tried),
        context_{context.threads, context.cancellation, {}} {}

  std::vector<Advice> run() {
    // Grasps that hold, and that the arm could reach, only lack a path.
    if (count_of(result_, Outcome::no_path) > 0) {
      advise_path();
    } else {
      advise_approach();
      advise_keep_out();
      advise_on_contacts();
      // Where the hand alone would hold the object, the arm is the reason, not the hand.
      const Held alone = without_arm();
      if (alone.held == 0) advise_hand();
      advise_tolerance();
      advise_obstacle();
      if (alone.held > 0) advise_arm(alone);
      if (advice_.empty() && lost_by_arm() < static_cast<int>(tried_.size())) advise_trials();
    }
    advise_unit();
    return std::move(advice_);
  }

 private:
  void add(Hint hint, std::string words) { advice_.push_back({hint, std::move(words)}); }

  // Trials of candidates for `primitives` in a variant of the scene.
  Held try_in(const CompiledScene& scene, const std::vector<Primitive>& primitives) const {
    return try_in(scene, primitives, options_.candidates);
  }

  Held try_in(const CompiledScene& scene, const std::vector<Primitive>& primitives,
              const CandidateOptions& proposing) const {
    const std::size_t count = index(std::min(options_.search.trials, kMostTrials));
    std::vector<Candidate> candidates;
    for (const ProposedGrasp& grasp :
         propose_grasps(scene, primitives, count, proposing, context_).grasps) {
      candidates.push_back(grasp.candidate);
    }
    Held held{0, static_cast<int>(candidates.size())};
    for (const auto& trial : run_trials(scene, candidates, options_.trial, context_)) {
      if (trial && trial->outcome == Outcome::stable) ++held.held;
    }
    context_.cancellation.check();
    return held;
  }

  // The same in a scene that has to be compiled first; nothing where that fails, for instance
  // because another hand is not one that a scene can use.
  Held try_variant(const std::function<void(Scene&)>& change) const {
    Scene scene = scene_.scene;
    try {
      change(scene);
      return try_in(compile(std::move(scene), context_), result_.primitives);
    } catch (const InputError&) {
      return {};
    }
  }

  void advise_approach() {
    const std::optional<ApproachLimit>& limit = options_.candidates.approach;
    if (!limit) return;
    CandidateOptions any = options_.candidates;
    any.approach.reset();
    const Held held = try_in(scene_, result_.primitives, any);
    const bool none = result_.tried.empty() && held.tried > 0;
    if (held.held == 0 && !none) return;
    add(Hint::approach,
        "another --approach than " + approach_text(*limit) +
            (none ? ", from which nothing is proposed: from all sides, " : ": from all sides, ") +
            held.words() + " hold");
  }

  void advise_keep_out() {
    if (scene_.keep_out.empty()) return;
    CompiledScene anywhere = scene_;
    anywhere.keep_out = {};
    const Held held = try_in(anywhere, result_.primitives);
    if (held.held == 0) return;
    add(Hint::keep_out,
        "fewer parts of the object to keep out of (--keep-out, \"keep_out\" in the "
        "scene file): without them, " +
            held.words() + " hold");
  }

  // Trials in which the hand touches the object but does not hold it, a few of them, evenly picked.
  std::vector<const Trial*> touching_without_force_closure() const {
    std::vector<const Trial*> all;
    for (const Trial& trial : tried_) {
      const bool touches = trial.outcome == Outcome::not_force_closure;
      if (touches && !trial.contacts.empty()) all.push_back(&trial);
    }
    std::vector<const Trial*> some;
    const std::size_t count = std::min(all.size(), kMostJudgements);
    for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
    return some;
  }

  // Of `trials`, how many hold with other contacts in place of theirs.
  template <typename ContactsOf>
  Held judge(const std::vector<const Trial*>& trials, const ContactsOf& contacts_in) const {
    Held held{0, static_cast<int>(trials.size())};
    for (const Trial* trial : trials) {
      context_.cancellation.check();
      const std::vector<Contact> contacts = contacts_in(*trial);
      const EpsilonBracket epsilon =
          epsilon_l1(contact_wrenches(contacts, scene_.wrench_frame, options_.trial.cone_edges));
      if (epsilon.lower > 0.0) ++held.held;
    }
    return held;
  }

  void advise_on_contacts() {
    const std::vector<const Trial*> trials = touching_without_force_closure();
    if (trials.empty()) return;
    if (!advise_soft_contacts(trials)) advise_friction(trials);
  }

  bool advise_soft_contacts(const std::vector<const Trial*>& trials) {
    if (options_.trial.contacts != ContactKind::hard) return false;
    TrialOptions soft = options_.trial;
    soft.contacts = ContactKind::soft;
    const Held held = judge(trials, [&](const Trial& trial) {
      return contacts_of(grasp_contacts(scene_, trial.X_OH, trial.joints, soft));
    });
    if (held.held == 0) return false;
    add(Hint::soft_contacts, "--contacts soft: where rubber counts as a soft finger, " +
                                 held.words() + " that touch would hold");
    return true;
  }

  // What the link of a contact is made of there.
  std::string link_material(const Trial& trial, const GraspContact& contact) const {
    std::vector<Pose> X_HL;
    link_poses(scene_.scene.hand, trial.joints, X_HL);
    const Pose X_OL = trial.X_OH * X_HL[index(contact.link)];
    const CompiledLink& link = scene_.links[index(contact.link)];
    return surface_name(link.surface.at(X_OL.inverse() * contact.point.position));
  }

  void advise_friction(const std::vector<const Trial*>& trials) {
    // The contact with the least friction names the materials.
    const GraspContact* slippery = nullptr;
    const Trial* of = nullptr;
    for (const Trial* trial : trials) {
      for (const GraspContact& contact : trial->contacts) {
        if (slippery == nullptr || contact.point.friction < slippery->point.friction) {
          slippery = &contact;
          of = trial;
        }
      }
    }
    if (slippery == nullptr) return;
    for (const double friction : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0}) {
      if (friction <= slippery->point.friction) continue;
      const Held held = judge(trials, [&](const Trial& trial) {
        std::vector<Contact> contacts = contacts_of(trial.contacts);
        for (Contact& contact : contacts) contact.friction = std::max(contact.friction, friction);
        return contacts;
      });
      if (held.held == 0) continue;
      const std::string material = link_material(*of, *slippery);
      const std::string object = surface_name(scene_.object_surface.at(slippery->point.position));
      add(Hint::friction,
          formatted("friction: it is %.2g between %s (hand) and %s (object); with %.2g, ",
                    slippery->point.friction, material.c_str(), object.c_str(), friction) +
              held.words() + " that touch would hold. If the surfaces are rougher than assumed, " +
              R"(say so in the scene file: "material" of the object, or "friction")");
      return;
    }
  }

  // The first hand of the library with which half of the candidates hold, else the one with which
  // most do; each is tried at the places that this plan proposed.
  void advise_hand() {
    std::shared_ptr<const Robot> best;
    Held most;
    for (const std::shared_ptr<const Robot>& hand : other_hands()) {
      const Held held = try_variant([&](Scene& scene) { use_hand(scene, *hand); });
      if (held.held <= most.held) continue;
      most = held;
      best = hand;
      if (2 * held.held >= held.tried) break;
    }
    if (!best) return;
    const bool on_arm = scene_.arm.has_value();
    add(Hint::other_hand,
        "--hand " + best->name +
            formatted(", which opens to %.3g mm (%s: %.3g mm): ", 1000.0 * opening(*best),
                      scene_.scene.hand.name.c_str(), 1000.0 * result_.largest_opening) +
            most.words() + " hold" + (on_arm ? ", apart from what the arm can reach" : ""));
  }

  static double opening(const Robot& hand) {
    double widest = 0.0;
    for (const Preshape& preshape : hand.hand->preshapes) {
      widest = std::max(widest, preshape.max_width);
    }
    return widest;
  }

  // Hands of the library besides the scene's that open wide enough for the object, the one that
  // opens least first.
  std::vector<std::shared_ptr<const Robot>> other_hands() const {
    std::vector<std::shared_ptr<const Robot>> hands;
    try {
      for (const std::string& name : library_robot_names()) {
        context_.cancellation.check();
        if (name == scene_.scene.hand.name) continue;
        // A platform is no single robot.
        try {
          Robot robot = find_robot(name);
          // How wide a hand opens says nothing of one with suction cups.
          if (robot.hand && robot.hand->cups.empty() && opening(robot) >= result_.smallest_width) {
            hands.push_back(std::make_shared<const Robot>(std::move(robot)));
          }
        } catch (const InputError&) {
          continue;
        }
      }
    } catch (const InputError&) {
      // There is no library: prehend may be used without one.
    }
    std::stable_sort(hands.begin(), hands.end(),
                     [](const auto& a, const auto& b) { return opening(*a) < opening(*b); });
    return hands;
  }

  // The hand flies free: what it could hold is asked first.
  static void use_hand(Scene& scene, const Robot& hand) {
    scene.carrier.reset();
    scene.hand = hand;
    scene.hand_source = hand.name;
    scene.link_surfaces.clear();
  }

  void advise_tolerance() {
    const bool given = !scene_.scene.primitives.empty();
    if (given || options_.primitives.tolerance <= kFineTolerance) return;
    DecomposeOptions fine = options_.primitives;
    fine.tolerance = kFineTolerance;
    std::vector<Primitive> primitives =
        decompose(scene_.scene.object.mesh, fine, context_).primitives;
    for (Primitive& part :
         find_thin_parts(scene_.object().mesh, primitives, options_.thin_parts, context_)) {
      primitives.push_back(std::move(part));
    }
    const Held held = try_in(scene_, primitives);
    if (held.held == 0) return;
    add(Hint::tolerance,
        formatted("--primitive-tolerance %.2g: the object is taken as %zu primitives instead of "
                  "%zu, and ",
                  1000.0 * kFineTolerance * bounds(scene_.scene.object.mesh).diagonal(),
                  primitives.size(), result_.primitives.size()) +
            held.words() + " hold");
  }

  // The obstacle that ended the most trials.
  std::optional<std::string> worst_obstacle() const {
    std::map<std::string, int> counts;
    for (const CollisionCount& blocker : result_.blockers) counts[blocker.by] += blocker.count;
    std::optional<std::string> worst;
    int most = 0;
    for (const PlacedBody& obstacle : scene_.obstacles()) {
      const auto found = counts.find(obstacle.name);
      if (found == counts.end() || found->second <= most) continue;
      most = found->second;
      worst = obstacle.name;
    }
    return worst;
  }

  void advise_obstacle() {
    const std::optional<std::string> worst = worst_obstacle();
    if (!worst) return;
    const Held held = try_variant([&](Scene& scene) {
      std::erase_if(scene.obstacles, [&](const StaticBody& body) { return body.name == *worst; });
    });
    if (held.held == 0) return;
    add(Hint::obstacle, "the obstacle " + *worst + " is in the way: without it, " + held.words() +
                            " hold. Move the object (\"pose\") or the obstacle in the scene file, "
                            "so that fingers fit between them");
  }

  int lost_by_arm() const {
    return count_of(result_, Outcome::unreachable) + count_of(result_, Outcome::arm_blocked);
  }

  // Nothing where no arm is to blame.
  Held without_arm() const {
    if (!scene_.arm || lost_by_arm() == 0) return {};
    return try_variant([](Scene& scene) { scene.carrier.reset(); });
  }

  void advise_arm(const Held& alone) {
    const bool far =
        count_of(result_, Outcome::unreachable) >= count_of(result_, Outcome::arm_blocked);
    const Vector3 way = scene_.scene.object.X_WO.translation() - scene_.arm->X_WB.translation();
    const std::string why = far ? "does not reach it there" : "collides with something there";
    add(Hint::arm,
        "the arm " + why + ": the hand alone holds " + alone.words() +
            formatted(". The object is %.2f m from the robot's base; move one of them in "
                      "the scene file (\"pose\")",
                      way.norm()));
  }

  // The sequence of candidates goes on where the trials ended.
  void advise_trials() {
    constexpr int kTimes = 4;
    const int made = static_cast<int>(tried_.size());
    if (made < options_.search.trials) return;
    add(Hint::candidates, "--trials " + std::to_string(kTimes * made) +
                              ": finer candidates than these " + std::to_string(made) +
                              " were not tried");
  }

  void advise_path() {
    const int held = count_of(result_, Outcome::no_path);
    add(Hint::path,
        formatted("%d %s, but no path from the robot's start was found: another --seed, another "
                  "\"start\" of the robot in the scene file; without --path the grasps are listed",
                  held, held == 1 ? "grasp holds" : "grasps hold"));
  }

  void advise_unit() {
    const std::string hint = unit_hint(scene_.scene.object);
    if (!hint.empty()) {
      add(Hint::unit,
          "--unit: the size of the object is not that of things that hands hold" + hint);
    }
  }

  const CompiledScene& scene_;
  const PlanOptions& options_;
  const PlanResult& result_;
  const std::vector<Trial>& tried_;
  const RunContext context_;
  std::vector<Advice> advice_;
};

}  // namespace

std::vector<Advice> find_advice(const CompiledScene& scene, const PlanOptions& options,
                                const PlanResult& result, const std::vector<Trial>& tried,
                                const RunContext& context) {
  return Adviser(scene, options, result, tried, context).run();
}

}  // namespace prehend
