#include "sim/motion/contact_search.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "sim/base/index.h"
#include "sim/shape/contact/triangle_overlap.h"
#include "sim/shape/smooth_surface.h"

namespace prehend {
namespace {

// The contact of the smooth surfaces that the meshes stand for (smooth_surface.h), from one of the
// meshes. About it the gap is, u across the normal from there,
//
//   g + (t_a + t_b) . u + u . (C_a + C_b) u / 2
//
// with the tangential parts t of the outward normals and the curvatures C. It is least where these
// balance, as far as the surfaces curve towards each other, and that is where they touch: a
// cylinder rests on the line below its axis, whatever facets it has, and rolls. Across that, as at
// the rim of a tilted can, the normal stays what it is.
SurfaceContact smoothed(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                        const SurfaceContact& contact) {
  constexpr double kFlat = 1e-2;  // curvatures below this move nothing [1/m]
  const Vector3& n = contact.normal;
  const Vector3 on_b = X_AB.inverse() * (contact.position - contact.gap * n);
  SmoothPoint of_a = smooth_point(a, contact.triangles.a, contact.position, -n);
  SmoothPoint of_b = smooth_point(b, contact.triangles.b, on_b, X_AB.linear().transpose() * n);
  const bool is_even = of_a.curvature.isZero(0.0) && of_b.curvature.isZero(0.0);
  if (is_even || (of_a.is_sharp && of_b.is_sharp)) return contact;
  of_b.normal = X_AB.linear() * of_b.normal;
  of_b.curvature = X_AB.linear() * of_b.curvature * X_AB.linear().transpose();
  const auto tangential = [&](const Vector3& v) -> Vector3 { return v - n.dot(v) * n; };
  SurfaceContact result = contact;
  if (of_a.is_sharp || of_b.is_sharp) {
    // A corner or an edge on a surface.
    result.normal = of_a.is_sharp ? of_b.normal : Vector3(-of_a.normal);
    result.gap -= of_a.is_sharp ? of_b.height : of_a.height;
    return result;
  }
  const Vector3 t_a = tangential(of_a.normal);
  const Vector3 t = t_a + tangential(of_b.normal);
  const Matrix3 across = Matrix3::Identity() - n * n.transpose();
  const Matrix3 curvature = across * (of_a.curvature + of_b.curvature) * across;
  const Eigen::SelfAdjointEigenSolver<Matrix3> principal(curvature);
  Vector3 way = Vector3::Zero();
  Matrix3 balanced = Matrix3::Zero();  // projects on the directions along which they balance
  for (int k = 0; k < 3; ++k) {
    const double along = principal.eigenvalues()[k];
    const Vector3 axis = principal.eigenvectors().col(k);
    if (along <= kFlat) continue;
    way -= t.dot(axis) / along * axis;
    balanced += axis * axis.transpose();
  }
  const double reach = std::max(of_a.reach, of_b.reach);
  if (way.norm() > reach) way *= reach / way.norm();
  const double lower = t.dot(way) + 0.5 * way.dot(curvature * way);
  // What is farther from the meshes than they are from their surfaces is none of these.
  if (lower < -2.0 * kMostSag) return contact;
  const Vector3 turned = balanced * (t_a + of_a.curvature * way);
  const double height_a = -of_a.height + t_a.dot(way) + 0.5 * way.dot(of_a.curvature * way);
  result.position += way + height_a * n;
  result.normal = (n - tangential(turned)).normalized();
  result.gap += lower - of_a.height - of_b.height;
  return result;
}

HeldContact held(const SurfaceContact& contact, const Pose& X_BA) {
  // The normal of a surface contact points from b into a, and its position is on a.
  const Vector3 on_b = contact.position - contact.gap * contact.normal;
  return {.p_A = contact.position, .p_B = X_BA * on_b, .normal_A = contact.normal};
}

// Whether a rigid body keeps contact i open where it keeps the others open: their normals are
// alike, they surround it, and its gap is not smaller than the one between theirs. Such a contact
// would bear weight at random: a vertex inside of a face is one, and a disc that rests on it spins
// for ever. So forces act at the corners of a face, as in contact_region.h.
//
// It is not if some plane over the tangent plane lies below the gaps of all others and above that
// of i: all slopes of such planes are a convex polygon, cut out by one half-plane a contact.
bool is_implied(const std::vector<SurfaceContact>& found, const std::vector<bool>& left_out,
                std::size_t i) {
  constexpr double kAlike = 1e-3;    // normals [rad]
  constexpr double kLower = 1e-6;    // gaps that are smaller by less than this are not [m]
  constexpr double kSteepest = 0.1;  // with kLower: corners that stand out by 10 um count
  const Vector3 along = found[i].normal.unitOrthogonal();
  const Vector3 across = found[i].normal.cross(along);
  using Point2 = Eigen::Vector2d;
  std::vector<Point2> slopes = {{-kSteepest, -kSteepest},
                                {kSteepest, -kSteepest},
                                {kSteepest, kSteepest},
                                {-kSteepest, kSteepest}};
  std::vector<Point2> kept;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (k == i || left_out[k]) continue;
    if ((found[k].normal - found[i].normal).norm() > kAlike) continue;
    const Vector3 way = found[k].position - found[i].position;
    const Point2 d(way.dot(along), way.dot(across));
    const double most = found[k].gap - found[i].gap - kLower;
    kept.clear();
    for (std::size_t c = 0; c < slopes.size(); ++c) {
      const Point2& from = slopes[c];
      const Point2& to = slopes[(c + 1) % slopes.size()];
      const double inside = most - d.dot(from);
      const double inside_next = most - d.dot(to);
      if (inside >= 0.0) kept.push_back(from);
      if ((inside > 0.0 && inside_next < 0.0) || (inside < 0.0 && inside_next > 0.0)) {
        kept.push_back(from + inside / (inside - inside_next) * (to - from));
      }
    }
    if (kept.empty()) return true;
    slopes.swap(kept);
  }
  return false;
}

// The nearest contact first, then again and again the one that a body which tilts on those chosen
// meets first: far from them, and with little more of a gap than the nearest. On an even face that
// is the one farthest from all. Those that others imply are left out. `found` are sorted by gap,
// the chosen are at most kMost.
std::vector<HeldContact> spread(const std::vector<SurfaceContact>& found, const Pose& X_BA) {
  constexpr std::size_t kMost = 8;
  constexpr double kEven = 2e-5;  // gaps that differ by less count as equal [m]
  // Farther away, distance counts less: what stands on two places tilts about the line between
  // them, and meets next what is beside that line.
  constexpr double kFar = 5e-3;  // [m]
  std::vector<HeldContact> contacts;
  for (const SurfaceContact& contact : found) contacts.push_back(held(contact, X_BA));
  std::vector<HeldContact> chosen;
  if (contacts.empty()) return chosen;
  std::vector<double> distance(contacts.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> left_out(contacts.size(), false);
  std::size_t next = 0;
  while (chosen.size() < kMost) {
    const bool is_chosen = !is_implied(found, left_out, next);
    if (is_chosen) chosen.push_back(contacts[next]);
    left_out[next] = !is_chosen;
    if (chosen.empty()) {
      ++next;
      continue;
    }
    double best = 0.0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (left_out[i]) continue;
      if (is_chosen) distance[i] = std::min(distance[i], difference(contacts[i], chosen.back()));
      const double lever = distance[i] / (1.0 + distance[i] / kFar);
      const double reached = lever / (found[i].gap - found.front().gap + kEven);
      if (distance[i] < kContactsApart || reached <= best) continue;
      best = reached;
      next = i;
    }
    if (best == 0.0) break;
  }
  return chosen;
}

// Each old impulse goes to the new contact that differs least from where it acted, if any is near.
void take_over(const std::vector<HeldContact>& before, std::vector<HeldContact>& contacts) {
  constexpr double kNear = 5e-3;  // [m]
  for (const HeldContact& old : before) {
    HeldContact* nearest = nullptr;
    double least = kNear;
    for (HeldContact& contact : contacts) {
      const double d = difference(contact, old);
      if (d >= least) continue;
      least = d;
      nearest = &contact;
    }
    if (nearest == nullptr) continue;
    nearest->impulse += old.impulse;
    nearest->guess += old.guess;
    nearest->slides = nearest->slides || old.slides;
  }
}

}  // namespace

double difference(const HeldContact& a, const HeldContact& b) {
  return (a.p_A - b.p_A).norm() + kContactArm * (a.normal_A - b.normal_A).norm();
}

void stick_here(const Pose& X_AB, HeldContact& contact) {
  const double gap = contact.normal_A.dot(contact.p_A - X_AB * contact.p_B);
  contact.p_B = X_AB.inverse() * (contact.p_A - gap * contact.normal_A);
}

void search_contacts(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, double range,
                     ContactWorkspace& workspace, PairMemory& memory) {
  ContactOptions contact_options;
  contact_options.threshold = range;
  // Corners of a face that is not parallel are contacts as well: it may turn onto them in the step.
  contact_options.evenness = range;
  std::vector<SurfaceContact> found;
  find_contact_points(a, b, X_AB, contact_options, workspace, found);
  if (a.smooth().is_curved || b.smooth().is_curved) {
    for (SurfaceContact& contact : found) contact = smoothed(a, b, X_AB, contact);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const SurfaceContact& p, const SurfaceContact& q) { return p.gap < q.gap; });
  std::vector<HeldContact> chosen = spread(found, X_AB.inverse());
  take_over(memory.contacts, chosen);
  memory.contacts = std::move(chosen);
  memory.X_AB = X_AB;
  memory.at_least = range;
}

HeldContact nearest_contact(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                            const TrianglePair& pair) {
  const TriangleGap gap = triangle_gap(a, b, X_AB, pair);
  const Vector3 between = gap.p_A - X_AB * gap.p_B;
  return {.p_A = gap.p_A, .p_B = gap.p_B, .normal_A = between.normalized()};
}

std::optional<HeldContact> crossing_contact(const ProximityMesh& a, const ProximityMesh& b,
                                            const Pose& X_AB) {
  std::vector<ClosePair> pairs;
  find_pairs_within(a, b, X_AB, 0.0, pairs);
  Vector3 middle = Vector3::Zero();
  Vector3 normal = Vector3::Zero();
  for (const auto& [pair, distance, on_a, on_b] : pairs) {
    const Corners of_a = corners_of(a.mesh(), pair.a);
    const Corners of_b = moved(corners_of(b.mesh(), pair.b), X_AB);
    for (const Corners& corners : {of_a, of_b}) {
      middle += (corners[0] + corners[1] + corners[2]) / 6.0;
    }
    normal += unit_normal(of_b) - unit_normal(of_a);
  }
  if (pairs.empty() || !(normal.norm() > 1e-6 * static_cast<double>(pairs.size()))) return {};
  middle /= static_cast<double>(pairs.size());
  return HeldContact{
      .p_A = middle, .p_B = X_AB.inverse() * middle, .normal_A = normal.normalized()};
}

}  // namespace prehend
