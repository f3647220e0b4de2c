#include "benchmarks/shake/mujoco_model.h"

#include <array>
#include <cstring>

#include "sim/base/input_error.h"

namespace prehend::bench {
namespace {

void ignore_warning(const char* /*text*/) {}

}  // namespace

MujocoModel load_mujoco(const std::string& mjcf) {
  mju_user_warning = ignore_warning;
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const char* const name = "model.xml";
  mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(mjcf.size()));
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), name)], mjcf.data(), mjcf.size());
  std::array<char, 1000> error{};
  mjModel* model = mj_loadXML(name, files.get(), error.data(), static_cast<int>(error.size()));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw InputError({.problem = "MuJoCo: " + std::string(error.data())});
  return MujocoModel(model);
}

Pose mujoco_pose(const mjtNum* position, const mjtNum* quaternion) {
  const Eigen::Quaterniond rotation(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
  return pose_from(rotation.normalized().toRotationMatrix(),
                   {position[0], position[1], position[2]});
}

bool mujoco_is_unstable(const mjData& state) {
  for (const int warning :
       {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC, mjWARN_CONTACTFULL, mjWARN_CNSTRFULL}) {
    if (state.warning[warning].number > 0) return true;
  }
  return false;
}

}  // namespace prehend::bench
