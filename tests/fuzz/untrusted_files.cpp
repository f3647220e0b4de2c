#include "tests/fuzz/untrusted_files.h"

#include <algorithm>
#include <array>

#include "sim/base/input_error.h"

namespace prehend::fuzz {
namespace {

constexpr std::array<FileKind, 30> kKinds{{
    {"stl", Grammar::bytes, read_mesh_file},
    {"ply", Grammar::bytes, read_mesh_file},
    {"obj", Grammar::bytes, read_mesh_file},
    {"off", Grammar::bytes, read_mesh_file},
    {"dae", Grammar::bytes, read_mesh_file},
    {"iv", Grammar::bytes, read_mesh_file},
    {"wrl", Grammar::bytes, read_mesh_file},
    {"gltf", Grammar::json, read_mesh_file},
    {"glb", Grammar::glb, read_mesh_file},
    {"robot", Grammar::json, read_robot_file},
    {"platform", Grammar::json, read_platform_file},
    {"graspit_robot", Grammar::bytes, read_graspit_robot_file},
    {"graspit_world", Grammar::bytes, read_graspit_world_file},
    {"urdf", Grammar::bytes, read_urdf_file},
    {"mjcf", Grammar::bytes, read_mjcf_file},
    {"xacro", Grammar::bytes, read_xacro_file},
    {"sdf", Grammar::bytes, read_sdf_file},
    {"openrave", Grammar::bytes, read_openrave_file},
    {"scene", Grammar::json, read_scene_file},
    {"moveit", Grammar::bytes, read_moveit_file},
    {"grasps", Grammar::json, read_grasps_file},
    {"contacts", Grammar::json, read_contacts_file},
    {"truth", Grammar::json, read_executed_grasps_file},
    {"graspgen", Grammar::json, read_graspgen_file},
    {"acronym", Grammar::bytes, read_acronym_file},
    {"pcd", Grammar::bytes, read_pcd_file},
    {"ply_cloud", Grammar::bytes, read_ply_cloud_file},
    {"depth_png", Grammar::bytes, read_depth_png_file},
    {"views", Grammar::json, read_views_file},
    {"session", Grammar::messages, read_session_messages},
}};

// A message is one line that can be printed to a terminal.
void check_message(const std::string& message) {
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 127; };
  promised(!message.empty(), "a message says something");
  promised(std::none_of(message.begin(), message.end(), is_control),
           "a message has no control characters");
}

}  // namespace

std::span<const FileKind> file_kinds() { return kKinds; }

const FileKind& file_kind(std::string_view name) {
  const auto found = std::find_if(kKinds.begin(), kKinds.end(),
                                  [&](const FileKind& kind) { return kind.name == name; });
  promised(found != kKinds.end(), "there is a reader of this name");
  return *found;
}

std::string refusal(const FileKind& kind, const std::string& bytes) {
  try {
    kind.read(kind.name, bytes);
    return {};
  } catch (const InputError& error) {
    check_message(error.what());
    promised(!error.file().empty(), "a message names the file");
    return error.what();
  }
}

std::string pretended_path(std::string_view name, std::string_view extension) {
  return PREHEND_CORPUS_DIR "/" + std::string(name) + "/input." + std::string(extension);
}

void promised(bool kept, const char* promise) {
  if (!kept) throw BrokenPromise(promise);
}

}  // namespace prehend::fuzz
