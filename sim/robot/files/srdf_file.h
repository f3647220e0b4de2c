// Reads SRDF, which stands beside URDF and says what belongs together
// (docs/reference/urdf-files.md).
#pragma once

#include <optional>

#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/joint_tree.h"

namespace prehend {

// Adds what the file says to `tree`: pairs of links that are never checked for collision, and where
// joints start (the states "open" of the hand and "ready", "home" or "default" of the rest, the
// first that there is). Returns the link with which the hand begins, where there is one end
// effector. What names links or joints that `tree` does not have is left out, with a note. Throws
// InputError for another outermost element than <robot>, groups that contain each other in a
// circle, and what XmlElement refuses. Source: http://wiki.ros.org/srdf/review
std::optional<int> read_srdf(const XmlFile& file, JointTree& tree);

}  // namespace prehend
