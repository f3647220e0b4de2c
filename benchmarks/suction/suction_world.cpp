#include "benchmarks/suction/suction_world.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "benchmarks/shake/mujoco_model.h"
#include "benchmarks/suction/lip_points.h"
#include "planner/show/exports/mjcf_geoms.h"
#include "sim/base/gravity.h"
#include "sim/base/index.h"
#include "sim/base/number_text.h"
#include "sim/base/xml/xml_text.h"

namespace prehend::bench {
namespace {

// A point weighs enough for its contacts to be much stiffer than its spring [kg].
constexpr double kPointMass = 5e-3;
// Adhesion acts as far as that, at which surfaces touch for the planner as well [m].
constexpr double kSuckedGap = 1e-4;

// As in exported models (mjcf.h), with which held objects neither creep nor sink in.
constexpr double kTimeStep = 1e-3;     // s
constexpr double kContactTime = 2e-3;  // s

constexpr double kSettleTime = 0.2;  // without weight [s]
constexpr double kGrowTime = 1.0;    // s
constexpr double kHoldTime = 2.0;    // s
// What comes to rest moves less in the last part of that time [s, m].
constexpr double kRestTime = 0.2;
constexpr double kRestWay = 1e-3;
// A point of a lip has come off when it is farther than kSuckedGap for so long [s].
constexpr double kLiftTime = 5e-3;
// What is so far away is lost [m].
constexpr double kFar = 0.5;

std::string point_name(std::size_t k) { return "lip_" + std::to_string(k); }

void write_point(XmlText& xml, const HangingCup& cup, const LipPoint& point, std::size_t k) {
  const double stiffness = cup.stiffness / kLipPoints;
  xml.open("body", {{"name", point_name(k)}, {"pos", vector_text(point.center_O)}});
  xml.element("inertial", {{"pos", "0.0 0.0 0.0"},
                           {"mass", number_text(kPointMass)},
                           {"diaginertia", "1e-6 1e-6 1e-6"}});
  xml.element("joint", {{"type", "slide"},
                        {"axis", vector_text(cup.axis_O)},
                        {"limited", "true"},
                        {"range", numbers_text({-cup.travel, cup.travel})},
                        {"stiffness", number_text(stiffness)},
                        {"damping", number_text(2.0 * std::sqrt(stiffness * kPointMass))}});
  xml.element("geom", {{"name", point_name(k)},
                       {"type", "sphere"},
                       {"size", number_text(kPointRadius)},
                       {"margin", number_text(kSuckedGap)},
                       {"gap", number_text(kSuckedGap)},
                       {"priority", "1"},
                       {"friction", numbers_text({cup.friction, 0.0, 0.0})}});
  xml.close();
}

// The frame of the world is that in which the object is at the start.
std::string mjcf_of(const HangingObject& object, const std::vector<LipPoint>& points) {
  XmlText xml;
  xml.open("mujoco", {{"model", "hanging object"}});
  xml.element("compiler", {{"angle", "radian"}, {"balanceinertia", "true"}});
  xml.open("option", {{"timestep", number_text(kTimeStep)},
                      {"gravity", "0.0 0.0 0.0"},
                      {"cone", "elliptic"},
                      {"impratio", "100"},
                      {"noslip_iterations", "20"}});
  xml.close();
  xml.element("size", {{"nconmax", "1000"}, {"njmax", "4000"}});
  xml.open("default");
  xml.element("geom", {{"solref", number_text(kContactTime) + " 1.0"}, {"condim", "3"}});
  xml.close();
  xml.open("asset");
  const std::vector<MjcfGeom> geoms = write_meshes(xml, "object", object.pieces);
  xml.close();
  xml.open("worldbody");
  for (std::size_t k = 0; k < points.size(); ++k) {
    write_point(xml, object.cups[index(points[k].cup)], points[k], k);
  }
  xml.open("body", {{"name", "object"}});
  xml.element("freejoint", {});
  const Matrix3& I = object.inertial.inertia;
  xml.element("inertial", {{"pos", vector_text(object.inertial.center_of_mass)},
                           {"mass", number_text(object.inertial.mass)},
                           {"fullinertia",
                            numbers_text({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)})}});
  write_geoms(xml, geoms, {}, "0.85 0.72 0.5 1.0");
  xml.close();
  xml.close();
  xml.open("actuator");
  for (std::size_t k = 0; k < points.size(); ++k) {
    xml.element("adhesion", {{"body", point_name(k)},
                             {"ctrlrange", "0.0 1.0"},
                             {"gain", number_text(object.cups[index(points[k].cup)].pull)}});
  }
  xml.close();
  xml.close();
  return xml.text();
}

class HangingRun {
 public:
  HangingRun(const HangingObject& object, LiftedLip lifted)
      : object_(object),
        points_(lip_points(object.cups, object.pieces)),
        model_(load_mujoco(mjcf_of(object, points_))),
        state_(mj_makeData(model_.get())),
        lifted_(lifted),
        body_(mj_name2id(model_.get(), mjOBJ_BODY, "object")),
        touched_(points_.size(), 0.0),
        lies_(points_.size(), false),
        sealed_(object.cups.size(), true) {
    mj_forward(model_.get(), state_.get());
  }

  HangingEnd run();

 private:
  void look_at_contacts();
  void pull();
  bool has_vacuum() const;
  Pose pose() const { return mujoco_pose(state_->xpos + 3 * body_, state_->xquat + 4 * body_); }

  const HangingObject& object_;
  std::vector<LipPoint> points_;
  MujocoModel model_;
  MujocoState state_;
  LiftedLip lifted_;
  int body_;
  std::vector<double> touched_;  // when each point did last [s]
  // Whether each point lies on the object before it weighs anything. Where the pieces reach out of
  // the object beside a point, it does not, and says nothing of the seal.
  std::vector<bool> lies_;
  std::vector<bool> sealed_;  // each cup
  bool came_off_ = false;     // some point
};

// Contacts are there from kSuckedGap on. Geoms of points have the numbers of the points, as they
// come first.
void HangingRun::look_at_contacts() {
  for (int c = 0; c < state_->ncon; ++c) {
    const mjContact& contact = state_->contact[c];
    const int point = std::min(contact.geom1, contact.geom2);
    if (point < static_cast<int>(points_.size())) touched_[index(point)] = state_->time;
  }
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const bool apart = state_->time - touched_[k] > kLiftTime;
    if (state_->time < kSettleTime) {
      lies_[k] = !apart;
    } else if (apart && lies_[k]) {
      came_off_ = true;
      if (lifted_ == LiftedLip::leaks) sealed_[index(points_[k].cup)] = false;
    }
  }
}

// Each cup's force is divided among the points that touch: what one actuator does whose body has
// all of them, with the contacts of the step before.
void HangingRun::pull() {
  std::vector<int> touching(object_.cups.size(), 0);
  const auto touches = [&](std::size_t k) { return state_->time - touched_[k] < 1.5 * kTimeStep; };
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (touches(k)) ++touching[index(points_[k].cup)];
  }
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const std::size_t cup = index(points_[k].cup);
    state_->ctrl[k] = sealed_[cup] && touches(k) ? 1.0 / touching[cup] : 0.0;
  }
}

bool HangingRun::has_vacuum() const {
  return std::any_of(state_->ctrl, state_->ctrl + model_->nu,
                     [](mjtNum value) { return value > 0.0; });
}

HangingEnd HangingRun::run() {
  const double end = kSettleTime + kGrowTime + kHoldTime;
  const double weight = object_.inertial.mass * kStandardGravity;
  const Vector3 axis = object_.cups.front().axis_O;
  const Vector3 start = object_.inertial.center_of_mass;
  Vector3 before_rest = start;
  HangingEnd result;
  result.linear_margin = linear_margin(object_, points_);
  for (const LipPoint& point : points_) {
    result.facing += point.facing / static_cast<double>(points_.size());
  }
  while (state_->time < end) {
    look_at_contacts();
    pull();
    const double part = std::clamp((state_->time - kSettleTime) / kGrowTime, 0.0, 1.0);
    const Vector3 force = part * weight * object_.down_O;
    std::copy(force.begin(), force.end(), state_->xfrc_applied + 6 * body_);
    mj_step(model_.get(), state_.get());
    const Vector3 center = pose() * start;
    result.moved = (center - start).norm();
    result.tilted =
        std::max(result.tilted, std::acos(std::clamp(axis.dot(pose().linear() * axis), -1.0, 1.0)));
    if (state_->time < end - kRestTime) before_rest = center;
    result.unstable = mujoco_is_unstable(*state_);
    result.held = has_vacuum() && (center - before_rest).norm() < kRestWay;
    if (result.unstable || !has_vacuum() || result.moved > kFar) break;
  }
  result.held = result.held && !result.unstable && result.moved <= kFar;
  result.lifted = came_off_ || !has_vacuum();
  return result;
}

}  // namespace

HangingEnd hang_in_mujoco(const HangingObject& object, LiftedLip lifted) {
  return HangingRun(object, lifted).run();
}

}  // namespace prehend::bench
