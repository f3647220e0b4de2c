#include "planner/show/report/grasp_detail.h"

#include <algorithm>
#include <stdexcept>

#include "sim/base/input_error.h"
#include "sim/quality/cup_balance.h"
#include "sim/quality/set_hull.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_space.h"

namespace prehend {
namespace {

// Corners of the polyhedron that approximates a smooth set: enough for a drawing.
constexpr int kMostPoints = 200;

// Polytope of the wrench space. With the L1 norm and pyramids the space is the convex hull of the
// wrenches of the pyramids' edges, which is exact; other spaces, those of many edges, and those on
// which qhull fails are approximated from inside by points on their surface.
PointHull space_hull(std::span<const Contact> contacts, const WrenchFrame& frame,
                     const WrenchSpaceOptions& space) {
  // Suction cups have too many columns.
  const bool is_hull_of_columns =
      space.norm == WrenchNorm::l1 && space.cone == FrictionCone::pyramid && !has_cup(contacts);
  if (is_hull_of_columns && space.edges <= kMostHullEdges) {
    try {
      return wrench_hull(contact_wrenches(contacts, frame, space.edges)).points;
    } catch (const InputError&) {
      throw;
    } catch (const std::runtime_error&) {
      // qhull failed.
    }
  }
  return set_hull(*wrench_space(contacts, frame, space), {.max_points = kMostPoints}).hull;
}

// Epsilon (lower bound) of the contacts that are kept.
double epsilon_where(std::span<const Contact> contacts, const WrenchFrame& frame,
                     const WrenchSpaceOptions& space, const std::vector<bool>& kept) {
  std::vector<Contact> some;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (kept[i]) some.push_back(contacts[i]);
  }
  return grasp_epsilon(some, frame, space).lower;
}

// Importance by leaving out: epsilon without each contact, and without all contacts of each link.
void add_shares(std::span<const Contact> contacts, std::span<const std::string> links,
                const WrenchFrame& frame, const WrenchSpaceOptions& space,
                const RunContext& context, GraspDetail& detail) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    context.cancellation.check();
    std::vector<bool> kept(contacts.size(), true);
    kept[i] = false;
    detail.epsilon_without.push_back(epsilon_where(contacts, frame, space, kept));
  }
  for (const std::string& link : links) {
    const bool known = std::any_of(detail.links.begin(), detail.links.end(),
                                   [&](const LinkShare& share) { return share.link == link; });
    if (known) continue;
    context.cancellation.check();
    std::vector<bool> kept(contacts.size());
    for (std::size_t i = 0; i < links.size(); ++i) kept[i] = links[i] != link;
    detail.links.push_back({link, epsilon_where(contacts, frame, space, kept)});
  }
}

}  // namespace

GraspDetail grasp_detail(std::span<const Contact> contacts, std::span<const std::string> links,
                         const WrenchFrame& frame, const WrenchSpaceOptions& space,
                         std::uint64_t seed, int samples, const RunContext& context) {
  GraspDetail detail;
  if (contacts.empty()) return detail;
  NoiseOptions noise;
  noise.seed = seed;
  noise.samples = samples;
  detail.robust = robust_epsilon(contacts, frame, space, noise, context);
  add_shares(contacts, links, frame, space, context, detail);
  return detail;
}

WrenchSections space_sections(std::span<const Contact> contacts, const WrenchFrame& frame,
                              const WrenchSpaceOptions& space) {
  if (contacts.empty()) return {};
  return wrench_sections(space_hull(contacts, frame, space));
}

}  // namespace prehend
