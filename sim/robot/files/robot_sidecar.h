// What a file of another program cannot say about a robot: a small JSON file beside it
// (docs/reference/urdf-files.md).
#pragma once

#include <filesystem>
#include <optional>

#include "sim/base/json/json_field.h"
#include "sim/robot/files/joint_tree.h"
#include "sim/robot/files/package_folders.h"
#include "sim/robot/platform.h"

namespace prehend {

// NAME.prehend.json beside NAME.urdf. Its functions throw InputError that names its fields.
class RobotSidecar {
 public:
  // Parses the file; unknown fields are refused.
  explicit RobotSidecar(const std::filesystem::path& file);

  // Where the one of `robot_file` would be.
  static std::filesystem::path path_beside(const std::filesystem::path& robot_file);

  // `options` with the folders of packages and the SRDF file that it names, where `options` do not
  // have them.
  ForeignRobotOptions options(ForeignRobotOptions options) const;

  // Materials and pairs of links that are never checked for collision.
  void complete(JointTree& tree) const;

  // The link with which the hand begins; "" asks for no hand of its own: the file is one robot.
  // Empty: not said.
  std::optional<std::string> hand_root() const;

  // Motion of the degrees of freedom, springs, and the hand: that of the last robot.
  void complete(Platform& platform) const;

 private:
  JsonFile file_;
};

}  // namespace prehend
