#include "sim/robot/move_robot.h"

namespace prehend {

std::optional<DofValues> move_robot(const AssembledPlatform& platform, int part, const Pose& X_BR,
                                    const DofValues& now, const IkOptions& options) {
  const PlatformPart& moved = platform.parts[static_cast<std::size_t>(part)];
  if (moved.joint < 0) return std::nullopt;
  const auto found = solve_all(platform.robot, {{moved.joint, moved.X_JR, X_BR}}, now, options);
  if (found.empty()) return std::nullopt;
  return found.front();
}

}  // namespace prehend
