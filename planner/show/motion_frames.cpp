#include "planner/show/motion_frames.h"

#include <algorithm>
#include <cstddef>

namespace prehend {
namespace {

// The motion is divided at the ends of its segments. Frames go to these ends first, since they show
// what each segment leads to, and then to the inside of the segments, where they are spaced evenly
// in time.

// A segment of the motion that takes time.
struct Stretch {
  std::string name;
  double from = 0.0;  // s
  double to = 0.0;
  int inner = 0;  // frames between its ends

  double seconds() const { return to - from; }
};

std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b,
                            double part) {
  std::vector<double> values;
  for (std::size_t i = 0; i < a.size(); ++i) values.push_back(a[i] + part * (b[i] - a[i]));
  return values;
}

Pose between(const Pose& a, const Pose& b, double part) {
  const Eigen::Quaterniond turned =
      Eigen::Quaterniond(a.linear()).slerp(part, Eigen::Quaterniond(b.linear()));
  return pose_from(turned.toRotationMatrix(),
                   a.translation() + part * (b.translation() - a.translation()));
}

// The motion at `time`, which lies in it: linear interpolation between the frames around it, with
// slerp for rotations.
MotionFrame frame_at(const GraspMotion& motion, double time) {
  const auto after =
      std::lower_bound(motion.frames.begin(), motion.frames.end(), time,
                       [](const MotionFrame& frame, double moment) { return frame.time < moment; });
  // Times at the ends come from the frames themselves, so this only guards against rounding.
  if (after == motion.frames.end()) return motion.frames.back();
  if (after == motion.frames.begin() || after->time == time) return *after;
  const MotionFrame& a = *(after - 1);
  const MotionFrame& b = *after;
  const double part = (time - a.time) / (b.time - a.time);
  return {time, between(a.X_OH, b.X_OH, part), between(a.joints, b.joints, part),
          between(a.arm_joints, b.arm_joints, part), between(a.X_OC, b.X_OC, part)};
}

std::vector<Stretch> stretches(const GraspMotion& motion) {
  std::vector<Stretch> all;
  for (const TrajectorySegment& segment : motion.segments) {
    const double from = motion.frames[static_cast<std::size_t>(segment.first)].time;
    const double to = motion.frames[static_cast<std::size_t>(segment.last)].time;
    if (to > from) all.push_back({segment.name, from, to});
  }
  return all;
}

// Distributes frames over the insides of the stretches. Each frame goes to a stretch that has none
// yet, the longest of these first, then to the one whose frames are farthest apart in time. A
// stretch with n inner frames is divided into n + 1 equal times.
void share(int frames, std::vector<Stretch>& all) {
  const auto shorter = [](const Stretch& a, const Stretch& b) {
    if ((a.inner == 0) != (b.inner == 0)) return b.inner == 0;
    return a.seconds() / (a.inner + 1) < b.seconds() / (b.inner + 1);
  };
  for (; frames > 0; --frames) ++std::max_element(all.begin(), all.end(), shorter)->inner;
}

// The start of a stretch and what is between its ends.
void append(const GraspMotion& motion, const Stretch& stretch, const std::string& name_of_start,
            std::vector<NamedFrame>& out) {
  out.push_back({frame_at(motion, stretch.from), name_of_start});
  for (int i = 1; i <= stretch.inner; ++i) {
    const double time = stretch.from + i * stretch.seconds() / (stretch.inner + 1);
    out.push_back({frame_at(motion, time), stretch.name});
  }
}

}  // namespace

std::vector<NamedFrame> named_frames(const GraspMotion& motion, int count) {
  std::vector<Stretch> all = stretches(motion);
  if (all.empty() || count <= 0) return {};
  // Neighbouring stretches share an end.
  const int ends = static_cast<int>(all.size()) + 1;
  share(std::max(0, count - ends), all);
  std::vector<NamedFrame> frames;
  for (std::size_t s = 0; s < all.size(); ++s) {
    append(motion, all[s], s == 0 ? all[s].name : all[s - 1].name + " > " + all[s].name, frames);
  }
  frames.push_back({motion.frames.back(), all.back().name});
  // Fewer frames than ends: `frames` has the ends only. The last one is always kept;
  // the others are picked evenly.
  if (count >= ends) return frames;
  std::vector<NamedFrame> few;
  for (int i = 1; i < count; ++i) {
    few.push_back(frames[static_cast<std::size_t>((i - 1) * (ends - 1) / (count - 1))]);
  }
  few.push_back(frames.back());
  return few;
}

}  // namespace prehend
