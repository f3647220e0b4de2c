#include "benchmarks/shake/mujoco_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "benchmarks/shake/mujoco_model.h"
#include "sim/base/input_error.h"

namespace prehend::bench {
namespace {

// The base is so heavy and so hard to turn that nothing it carries moves it [kg, kg m^2]. What is
// left of that is taken back in every step.
constexpr double kBaseMass = 1e4;
constexpr double kBaseInertia = 1e2;
// The steps in which the hand is opened at the start, parts of the way to the preshape.
constexpr double kOpeningStep = 1.0 / 400.0;

// Part of the motion against a gear that it takes away at once (solimp), at most 0.9999.
constexpr double kGearImpedance = 0.9999;

}  // namespace

struct MujocoWorld::Data {
  // The motion of the base between two poses, as velocities in the world.
  struct Twist {
    Vector3 linear = Vector3::Zero();
    Vector3 angular = Vector3::Zero();
  };

  static Twist twist_between(const Pose& from, const Pose& to, double time);

  enum class Drive { still, closing, opening };

  struct Lock {
    int joint = 0;
    double closing = 1.0;
    std::array<mjtNum, 2> range = {};  // of the joint as the model has it
  };

  MujocoModel model;
  MujocoState state;
  MujocoState kept;
  int base = -1;  // bodies
  int target = -1;
  int object = -1;
  int grasp_key = -1;
  int pregrasp_key = -1;
  Drive drive = Drive::still;
  std::vector<double> start_joints;  // qpos
  double start_opened = 0.0;
  std::vector<Lock> locks;
  std::vector<double> efforts;  // of each joint, the part of its largest
  std::vector<double> held;     // where each joint was when that became 0 [rad or m]
  Pose X_WH = Pose::Identity();
  Twist velocity;
  Pose kept_X_WH = Pose::Identity();
  Twist kept_velocity;
  Drive kept_drive = Drive::still;

  int qpos_of(int body) const { return model->jnt_qposadr[model->body_jntadr[body]]; }
  int dof_of(int body) const { return model->jnt_dofadr[model->body_jntadr[body]]; }
  void find_bodies();
  int joint(const std::string& name) const;
  bool presses(int contact) const;
  void make_base_heavy() const;
  bool of_hand(int geom) const { return root_of(geom) == base; }
  int root_of(int geom) const { return model->body_rootid[model->geom_bodyid[geom]]; }
  bool hand_meets_object(const mjContact& contact) const;
  double overlap() const;
  void put_base(const Pose& pose, const Twist& twist) const;
  void put_joints(double opened) const;
  void drive_joints() const;
  void unlock() const;
  void follow_locked() const;
};

MujocoWorld::Data::Twist MujocoWorld::Data::twist_between(const Pose& from, const Pose& to,
                                                          double time) {
  const Eigen::AngleAxisd turn(Matrix3(to.linear() * from.linear().transpose()));
  return {(to.translation() - from.translation()) / time, turn.angle() / time * turn.axis()};
}

void MujocoWorld::Data::find_bodies() {
  for (int e = 0; e < model->neq; ++e) {
    if (model->eq_type[e] != mjEQ_WELD) continue;
    target = model->eq_obj1id[e];
    base = model->eq_obj2id[e];
    model->eq_active[e] = 0;  // the base is moved by itself
  }
  for (int j = 0; j < model->njnt; ++j) {
    if (model->jnt_type[j] == mjJNT_FREE && model->jnt_bodyid[j] != base) {
      object = model->jnt_bodyid[j];
    }
  }
  grasp_key = mj_name2id(model.get(), mjOBJ_KEY, "grasp");
  pregrasp_key = mj_name2id(model.get(), mjOBJ_KEY, "pregrasp");
  if (base < 0 || object < 0 || grasp_key < 0 || pregrasp_key < 0) {
    throw InputError({.problem = "no model of an exported grasp"});
  }
}

void MujocoWorld::Data::make_base_heavy() const {
  model->body_mass[base] = kBaseMass;
  for (int k = 0; k < 3; ++k) {
    model->body_inertia[3 * base + k] = kBaseInertia;
    model->body_ipos[3 * base + k] = 0.0;
  }
  const std::array<mjtNum, 4> unturned = {1.0, 0.0, 0.0, 0.0};
  std::copy(unturned.begin(), unturned.end(), model->body_iquat + 4 * base);
}

int MujocoWorld::Data::joint(const std::string& name) const {
  const int joint = mj_name2id(model.get(), mjOBJ_JOINT, name.c_str());
  if (joint < 0) throw InputError({.problem = "no joint of this name", .value = name});
  return joint;
}

bool MujocoWorld::Data::hand_meets_object(const mjContact& contact) const {
  const int a = root_of(contact.geom1);
  const int b = root_of(contact.geom2);
  return (a == base && b == object) || (a == object && b == base);
}

double MujocoWorld::Data::overlap() const {
  double deepest = 0.0;
  for (int c = 0; c < state->ncon; ++c) {
    const mjContact& contact = state->contact[c];
    if (hand_meets_object(contact)) deepest = std::max(deepest, -contact.dist);
  }
  return deepest;
}

void MujocoWorld::Data::put_base(const Pose& pose, const Twist& twist) const {
  mjtNum* qpos = state->qpos + qpos_of(base);
  mjtNum* qvel = state->qvel + dof_of(base);
  const Eigen::Quaterniond q = quaternion_of(pose);
  const Vector3 p = pose.translation();
  const std::array<double, 7> values = {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
  std::copy(values.begin(), values.end(), qpos);
  // MuJoCo has the angular velocity of free bodies in their own frames.
  const Vector3 own = pose.linear().transpose() * twist.angular;
  for (Eigen::Index k = 0; k < 3; ++k) {
    qvel[k] = twist.linear[k];
    qvel[3 + k] = own[k];
  }
}

// The joints a part of the way from the grasp to the preshape.
void MujocoWorld::Data::put_joints(double opened) const {
  const mjtNum* closed = model->key_qpos + grasp_key * model->nq;
  const mjtNum* open = model->key_qpos + pregrasp_key * model->nq;
  for (int j = 0; j < model->njnt; ++j) {
    if (model->jnt_type[j] == mjJNT_FREE) continue;
    const int q = model->jnt_qposadr[j];
    state->qpos[q] = closed[q] + opened * (open[q] - closed[q]);
    state->qvel[model->jnt_dofadr[j]] = 0.0;
  }
}

void MujocoWorld::Data::drive_joints() const {
  const mjtNum* closing = model->key_ctrl + grasp_key * model->nu;
  const mjtNum* opening = model->key_ctrl + pregrasp_key * model->nu;
  const mjtNum* open = model->key_qpos + pregrasp_key * model->nq;
  for (int a = 0; a < model->nu; ++a) {
    const bool motor = model->actuator_biastype[a] == mjBIAS_NONE;
    const double part = efforts[static_cast<std::size_t>(model->actuator_trnid[2 * a])];
    state->ctrl[a] = motor && drive == Drive::still ? 0.0 : (motor ? part : 1.0) * closing[a];
    if (!motor || drive != Drive::opening) continue;
    const int q = model->jnt_qposadr[model->actuator_trnid[2 * a]];
    const bool there = (open[q] - state->qpos[q]) * opening[a] <= 0.0;
    state->ctrl[a] = there ? 0.0 : opening[a];
  }
}

void MujocoWorld::Data::unlock() const {
  for (const Lock& lock : locks) {
    std::copy(lock.range.begin(), lock.range.end(), model->jnt_range + 2 * lock.joint);
  }
}

// The limits behind locked joints come after them.
void MujocoWorld::Data::follow_locked() const {
  if (drive != Drive::closing) return;
  for (const Lock& lock : locks) {
    const mjtNum q = state->qpos[model->jnt_qposadr[lock.joint]];
    mjtNum* range = model->jnt_range + 2 * lock.joint;
    if (lock.closing > 0.0) {
      range[0] = std::clamp(q, range[0], range[1]);
    } else {
      range[1] = std::clamp(q, range[0], range[1]);
    }
  }
}

MujocoWorld::MujocoWorld(const std::string& mjcf) : data_(std::make_unique<Data>()) {
  data_->model = load_mujoco(mjcf);
  data_->state = MujocoState(mj_makeData(data_->model.get()));
  data_->kept = MujocoState(mj_makeData(data_->model.get()));
  data_->find_bodies();
  data_->make_base_heavy();
  data_->efforts.assign(static_cast<std::size_t>(data_->model->njnt), 1.0);
  data_->held.assign(data_->efforts.size(), 0.0);
}

MujocoWorld::~MujocoWorld() = default;

void MujocoWorld::set_object_mass(double mass) {
  mjModel& model = *data_->model;
  const double factor = mass / model.body_mass[data_->object];
  model.body_mass[data_->object] = mass;
  for (int k = 0; k < 3; ++k) model.body_inertia[3 * data_->object + k] *= factor;
}

double MujocoWorld::object_mass() const { return data_->model->body_mass[data_->object]; }

void MujocoWorld::set_friction(double friction) {
  mjModel& model = *data_->model;
  for (int g = 0; g < model.ngeom; ++g) {
    if (!data_->of_hand(g)) continue;
    // A soft contact bears spin with a lever arm of its own.
    const double before = model.geom_friction[3 * g];
    if (before > 0.0) model.geom_friction[3 * g + 1] *= friction / before;
    model.geom_friction[3 * g] = friction;
  }
}

void MujocoWorld::set_torsion(double torsion) {
  mjModel& model = *data_->model;
  for (int g = 0; g < model.ngeom; ++g) {
    if (!data_->of_hand(g)) continue;
    model.geom_friction[3 * g + 1] = torsion;
    model.geom_condim[g] = torsion > 0.0 ? 4 : 3;
  }
}

void MujocoWorld::set_locks(const std::vector<JointLock>& locks) {
  const mjModel* model = data_->model.get();
  for (const JointLock& lock : locks) {
    const int joint = data_->joint(lock.joint);
    const mjtNum* range = model->jnt_range + 2 * joint;
    data_->locks.push_back({joint, lock.closing, {range[0], range[1]}});
    // A gear is stiffer than MuJoCo's limits are unless they are told so.
    data_->model->jnt_solimp[mjNIMP * joint] = kGearImpedance;
    data_->model->jnt_solimp[mjNIMP * joint + 1] = kGearImpedance;
  }
}

void MujocoWorld::start(const StartOptions& options) {
  mjModel* model = data_->model.get();
  mjData* state = data_->state.get();
  // By their mean inertia MuJoCo decides when forces are exact enough: the base must not count.
  const double mean_inertia = model->stat.meaninertia;
  mj_setConst(model, state);
  model->stat.meaninertia = mean_inertia;
  mj_resetDataKeyframe(model, state, data_->grasp_key);
  double opened = 0.0;
  double least = std::numeric_limits<double>::infinity();
  const int steps = static_cast<int>(std::ceil(options.most_opened / kOpeningStep));
  for (int k = 0; k <= steps && least > options.overlap && !options.open; ++k) {
    data_->put_joints(k * kOpeningStep);
    mj_fwdPosition(model, state);
    if (data_->overlap() < least) {
      least = data_->overlap();
      opened = k * kOpeningStep;
    }
  }
  if (options.open) opened = 1.0;
  data_->put_joints(opened);
  data_->start_opened = opened;
  data_->unlock();
  data_->start_joints.assign(state->qpos, state->qpos + model->nq);
  mj_forward(model, state);
  data_->X_WH = mujoco_pose(state->xpos + 3 * data_->base, state->xquat + 4 * data_->base);
  data_->velocity = {};
  data_->drive = Data::Drive::still;
}

void MujocoWorld::close() { data_->drive = Data::Drive::closing; }

void MujocoWorld::set_effort(const std::string& joint, double part) {
  const int at = data_->joint(joint);
  double& effort = data_->efforts[static_cast<std::size_t>(at)];
  if (part == 0.0 && effort > 0.0) {
    data_->held[static_cast<std::size_t>(at)] = data_->state->qpos[data_->model->jnt_qposadr[at]];
  }
  effort = part;
}

void MujocoWorld::open() {
  data_->drive = Data::Drive::opening;
  data_->unlock();
}

void MujocoWorld::set_gravity(const Vector3& gravity_W) {
  std::copy(gravity_W.begin(), gravity_W.end(), data_->model->opt.gravity);
}

void MujocoWorld::set_pull(const Vector3& force_W) {
  std::copy(force_W.begin(), force_W.end(), data_->state->xfrc_applied + 6 * data_->object);
}

double MujocoWorld::time_step() const { return data_->model->opt.timestep; }

void MujocoWorld::step_to(const Pose& X_WH) {
  mjModel* model = data_->model.get();
  mjData* state = data_->state.get();
  const double h = model->opt.timestep;
  const Data::Twist next = Data::twist_between(data_->X_WH, X_WH, h);
  data_->put_base(data_->X_WH, data_->velocity);
  for (int j = 0; j < model->njnt; ++j) {
    if (model->jnt_type[j] == mjJNT_FREE) continue;
    const auto q = static_cast<std::size_t>(model->jnt_qposadr[j]);
    const auto of = static_cast<std::size_t>(j);
    const bool still = data_->drive == Data::Drive::still;
    if (!still && data_->efforts[of] > 0.0) continue;
    state->qpos[q] = still ? data_->start_joints[q] : data_->held[of];
    state->qvel[model->jnt_dofadr[j]] = 0.0;
  }
  data_->drive_joints();
  // What gives the base its next velocity: contacts are found with that, not with a base that
  // falls.
  const Vector3 gravity(model->opt.gravity[0], model->opt.gravity[1], model->opt.gravity[2]);
  const Vector3 force = kBaseMass * ((next.linear - data_->velocity.linear) / h - gravity);
  const Vector3 torque = kBaseInertia * (next.angular - data_->velocity.angular) / h;
  std::copy(force.begin(), force.end(), state->xfrc_applied + 6 * data_->base);
  std::copy(torque.begin(), torque.end(), state->xfrc_applied + 6 * data_->base + 3);
  mj_step(model, state);
  data_->follow_locked();
  data_->X_WH = X_WH;
  data_->velocity = next;
}

Pose MujocoWorld::base() const { return data_->X_WH; }

Pose MujocoWorld::object() const {
  const mjtNum* qpos = data_->state->qpos + data_->qpos_of(data_->object);
  return mujoco_pose(qpos, qpos + 3);
}

Vector3 MujocoWorld::center_of_mass() const {
  const mjtNum* p = data_->model->body_ipos + 3 * data_->object;
  return object() * Vector3(p[0], p[1], p[2]);
}

// That of the body's origin, with the angular velocity as if it were at the farthest point.
double MujocoWorld::object_speed() const {
  const mjtNum* v = data_->state->qvel + data_->dof_of(data_->object);
  const Vector3 linear(v[0], v[1], v[2]);
  const Vector3 angular(v[3], v[4], v[5]);
  return linear.norm() + 0.1 * angular.norm();
}

bool MujocoWorld::Data::presses(int contact) const {
  std::array<mjtNum, 6> force{};
  mj_contactForce(model.get(), state.get(), contact, force.data());
  return force[0] > 0.0;
}

bool MujocoWorld::in_contact() const {
  const mjData* state = data_->state.get();
  for (int c = 0; c < state->ncon; ++c) {
    if (data_->hand_meets_object(state->contact[c]) && data_->presses(c)) return true;
  }
  return false;
}

bool MujocoWorld::presses(const std::string& link) const {
  const mjModel* model = data_->model.get();
  const mjData* state = data_->state.get();
  const int body = mj_name2id(model, mjOBJ_BODY, link.c_str());
  for (int c = 0; c < state->ncon; ++c) {
    const mjContact& contact = state->contact[c];
    const bool of_link =
        model->geom_bodyid[contact.geom1] == body || model->geom_bodyid[contact.geom2] == body;
    if (of_link && data_->hand_meets_object(contact) && data_->presses(c)) return true;
  }
  return false;
}

double MujocoWorld::joint_rate(const std::string& joint) const {
  return data_->state->qvel[data_->model->jnt_dofadr[data_->joint(joint)]];
}

double MujocoWorld::overlap() const { return data_->overlap(); }

double MujocoWorld::opened() const { return data_->start_opened; }

bool MujocoWorld::is_unstable() const { return mujoco_is_unstable(*data_->state); }

Pose MujocoWorld::body(const std::string& name) const {
  const int id = mj_name2id(data_->model.get(), mjOBJ_BODY, name.c_str());
  if (id < 0) throw InputError({.problem = "no body of this name", .value = name});
  return mujoco_pose(data_->state->xpos + 3 * id, data_->state->xquat + 4 * id);
}

void MujocoWorld::keep() {
  mj_copyData(data_->kept.get(), data_->model.get(), data_->state.get());
  data_->kept_X_WH = data_->X_WH;
  data_->kept_velocity = data_->velocity;
  data_->kept_drive = data_->drive;
}

void MujocoWorld::go_back() {
  mj_copyData(data_->state.get(), data_->model.get(), data_->kept.get());
  data_->X_WH = data_->kept_X_WH;
  data_->velocity = data_->kept_velocity;
  data_->drive = data_->kept_drive;
  data_->unlock();
  data_->follow_locked();
}

double drift_as_loaded(const std::string& mjcf, double seconds) {
  const MujocoModel model = load_mujoco(mjcf);
  const MujocoState state(mj_makeData(model.get()));
  mj_resetDataKeyframe(model.get(), state.get(), 0);
  const mjtNum* p = state->qpos + model->nq - 7;  // of the object, which is the last
  const Vector3 before(p[0], p[1], p[2]);
  while (state->time < seconds) mj_step(model.get(), state.get());
  return (Vector3(p[0], p[1], p[2]) - before).norm();
}

double joint_drift(const std::string& mjcf, const std::string& keyframe, double seconds) {
  const MujocoModel model = load_mujoco(mjcf);
  const MujocoState state(mj_makeData(model.get()));
  const int key = mj_name2id(model.get(), mjOBJ_KEY, keyframe.c_str());
  mj_resetDataKeyframe(model.get(), state.get(), key);
  while (state->time < seconds) mj_step(model.get(), state.get());
  double most = 0.0;
  for (int j = 0; j < model->njnt; ++j) {
    if (model->jnt_type[j] == mjJNT_FREE) continue;
    const int at = model->jnt_qposadr[j];
    const mjtNum start = model->key_qpos[key * model->nq + at];
    most = std::max(most, std::abs(state->qpos[at] - start));
  }
  return most;
}

}  // namespace prehend::bench
