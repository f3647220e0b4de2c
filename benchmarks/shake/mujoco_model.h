// Models of MuJoCo that own themselves. Only for sources that know MuJoCo.
#pragma once

#include <memory>
#include <mujoco/mujoco.h>
#include <string>

#include "sim/base/pose.h"

namespace prehend::bench {

struct FreeMujoco {
  void operator()(mjModel* of) const { mj_deleteModel(of); }
  void operator()(mjData* of) const { mj_deleteData(of); }
};
using MujocoModel = std::unique_ptr<mjModel, FreeMujoco>;
using MujocoState = std::unique_ptr<mjData, FreeMujoco>;

// Of an MJCF file's text. MuJoCo's warnings are not printed: its state counts them. Throws
// InputError with MuJoCo's message for a model that it refuses.
MujocoModel load_mujoco(const std::string& mjcf);

// Of a position and a quaternion w x y z, as MuJoCo stores them.
Pose mujoco_pose(const mjtNum* position, const mjtNum* quaternion);

// Whether MuJoCo lost numbers, or left out contacts for want of room, since the state was made or
// reset.
bool mujoco_is_unstable(const mjData& state);

}  // namespace prehend::bench
