// Where things are in files of ACRONYM, and in the group that is ours (docs/reference/datasets.md).
#pragma once

#include <array>
#include <string>

namespace prehend::acronym {

inline const std::string kTransforms = "grasps/transforms";
inline const std::string kQualities = "grasps/qualities";
inline const std::string kOurQuality = "prehend";
inline const std::string kTheirQuality = "flex";
inline const std::string kHeld = "/object_in_gripper";
// Beside it; each with "_linear" or "_angular" behind it.
inline const std::string kClosing = "/object_motion_during_closing";
inline const std::string kShaking = "/object_motion_during_shaking";

inline const std::string kGripperType = "gripper/type";
inline const std::string kConfiguration = "gripper/configuration";

// Of the group that is ours. A reader of an earlier version must not read a later one.
inline constexpr int kFormat = 1;
inline const std::string kFormatNumber = "prehend/format";

}  // namespace prehend::acronym
