#include "sim/motion/crossings.h"

#include <algorithm>
#include <cmath>

#include "sim/motion/contact_search.h"

namespace prehend {
namespace {

// On the way of a fast step surfaces are looked at so often that nothing thicker than this goes
// through unseen [m], and not more often than this.
constexpr double kLook = 5e-4;
constexpr int kMostLooks = 64;

Pose relative(const PairMemory& pair, const Solids& solids) {
  return solids.at(pair.a).X_WS.inverse() * solids.at(pair.b).X_WS;
}

// How far points of b move at most between two poses, on its bounding ball.
double most_moved(const ProximityMesh& b, const Pose& from, const Pose& to) {
  const double turned = (to.linear() - from.linear()).norm();  // sqrt(2) times the chord
  return (to * b.ball_center() - from * b.ball_center()).norm() + turned * b.ball_radius();
}

Pose between(const Pose& from, const Pose& to, double part) {
  const Eigen::Quaterniond start(from.linear());
  const Eigen::Quaterniond end(to.linear());
  return pose_from(start.slerp(part, end).toRotationMatrix(),
                   (1.0 - part) * from.translation() + part * to.translation());
}

// Of a pair whose surfaces did not cross.
std::optional<Crossing> crossing_of(const PairMemory& pair, std::size_t place, const Solids& before,
                                    const Solids& after) {
  if (moved_since(pair, after) < pair.gap) return {};
  const ProximityMesh& a = after.at(pair.a).shape->mesh;
  const ProximityMesh& b = after.at(pair.b).shape->mesh;
  const Pose from = relative(pair, before);
  const Pose to = relative(pair, after);
  const int looks = static_cast<int>(
      std::clamp(std::ceil(most_moved(b, from, to) / kLook), 1.0, double(kMostLooks)));
  for (int look = 1; look <= looks; ++look) {
    const Pose at = look == looks ? to : between(from, to, double(look) / looks);
    if (surfaces_cross(a, b, at)) return Crossing{place, from, at};
  }
  return {};
}

Pose apart(const Pose& X_AB, const Vector3& normal_A, double distance) {
  Pose X = X_AB;
  X.translation() -= distance * normal_A;
  return X;
}

// Of a pair whose surfaces cross: they may by as much as they are apart at rest, along some normal
// of their contacts. Those that were deeper in each other from the start are on their way out.
std::optional<Crossing> deeper(const PairMemory& pair, std::size_t place, const Solids& before,
                               const Solids& after, const StepOptions& options) {
  const ProximityMesh& a = after.at(pair.a).shape->mesh;
  const ProximityMesh& b = after.at(pair.b).shape->mesh;
  const Pose to = relative(pair, after);
  std::vector<Vector3> normals(1, Vector3::Zero());
  for (const HeldContact& contact : pair.contacts) {
    normals.front() += contact.normal_A;
    normals.push_back(contact.normal_A);
  }
  const double sum = normals.front().norm();
  if (sum > 1e-6) {
    normals.front() /= sum;
  } else {
    normals.erase(normals.begin());
  }
  const double most = options.rest_gap;
  for (const Vector3& normal : normals) {
    if (!surfaces_cross(a, b, apart(to, normal, most))) return {};
  }
  if (normals.empty()) return {};
  const Crossing crossing{place, apart(relative(pair, before), normals.front(), most),
                          apart(to, normals.front(), most)};
  if (surfaces_cross(a, b, crossing.X_AB_from)) return {};
  return crossing;
}

}  // namespace

std::vector<Crossing> crossings_of(const ContactMemory& memory, const Solids& before,
                                   const Solids& after, const StepOptions& options) {
  std::vector<Crossing> crossings;
  for (std::size_t p = 0; p < memory.pairs.size(); ++p) {
    const PairMemory& pair = memory.pairs[p];
    if (pair.contacts.empty()) continue;
    const std::optional<Crossing> crossing = pair.crosses ? deeper(pair, p, before, after, options)
                                                          : crossing_of(pair, p, before, after);
    if (crossing) crossings.push_back(*crossing);
  }
  return crossings;
}

bool add_contacts(const Crossing& crossing, const Solids& before, PairMemory& pair) {
  constexpr int kMost = 4;  // at once
  const ProximityMesh& a = before.at(pair.a).shape->mesh;
  const ProximityMesh& b = before.at(pair.b).shape->mesh;
  std::vector<ClosePair> pairs;
  find_pairs_within(a, b, crossing.X_AB, 0.0, pairs);
  std::vector<std::pair<double, HeldContact>> found;
  for (const ClosePair& crossed : pairs) {
    const TriangleGap gap = triangle_gap(a, b, crossing.X_AB_from, crossed.pair);
    const Vector3 way = gap.p_A - crossing.X_AB_from * gap.p_B;
    if (!(gap.distance > 1e-9)) continue;
    found.push_back({gap.distance, {gap.p_A, gap.p_B, way / gap.distance}});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& p, const auto& q) { return p.first < q.first; });
  int added = 0;
  for (const auto& one : found) {
    if (!add_unknown(one.second, pair.contacts)) continue;
    if (++added == kMost) break;
  }
  return added > 0;
}

bool add_unknown(const HeldContact& contact, std::vector<HeldContact>& contacts) {
  constexpr double kSame = 0.05;  // of what makes contacts differ in a search
  const bool is_known =
      std::any_of(contacts.begin(), contacts.end(), [&](const HeldContact& known) {
        return difference(known, contact) < kSame * kContactsApart;
      });
  if (!is_known) contacts.push_back(contact);
  return !is_known;
}

}  // namespace prehend
