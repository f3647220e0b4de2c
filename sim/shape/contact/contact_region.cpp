#include "sim/shape/contact/contact_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

// Contact points on one flat region of contact have the same normal and lie in one plane. What the
// region can transmit is the set of wrenches of all distributions of force over it, which is
// spanned by the corners of its convex hull. Contacts are therefore grouped by normal, and each
// group is reduced to a point, the ends of a segment, or the corners of a convex polygon, with as
// few corners as the options permit.
namespace prehend {
namespace {

using Point2 = Eigen::Vector2d;

// Corners that stand out from the line between their neighbours by less than this part of the
// threshold are left out.
constexpr double kFlatCorner = 0.1;

// Twice the signed area of the triangle abc: positive where it turns counter-clockwise.
double turn(const Point2& a, const Point2& b, const Point2& c) {
  const Point2 ab = b - a;
  const Point2 ac = c - a;
  return ab.x() * ac.y() - ab.y() * ac.x();
}

// Counter-clockwise convex hull (Andrew's monotone chain): one pass over the points from left to
// right makes the lower side, a second one from right to left the upper side. A point stays while
// the chain turns left at it; points on a side are left out, as a turn of 0 is none. Changes the
// order of the points.
void find_hull(std::vector<RegionPoint>& points, std::vector<RegionPoint>& chain) {
  std::sort(points.begin(), points.end(), [](const RegionPoint& a, const RegionPoint& b) {
    return a.p.x() != b.p.x() ? a.p.x() < b.p.x() : a.p.y() < b.p.y();
  });
  chain.clear();
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = chain.size();
    for (const RegionPoint& point : points) {
      while (chain.size() >= start + 2 &&
             turn(chain[chain.size() - 2].p, chain.back().p, point.p) <= 0.0) {
        chain.pop_back();
      }
      chain.push_back(point);
    }
    chain.pop_back();  // it starts the other side
    std::reverse(points.begin(), points.end());
  }
}

// Leaves out corners that stand out by less than `width` from the line between their neighbours,
// the flattest first. This is a step after the hull, not a tolerance of the hull's own turn test:
// in a row of points that are on one line up to rounding, that test compares near neighbours only
// and could drop the corners at the ends of the row.
void drop_flat_corners(std::vector<RegionPoint>& polygon, double width) {
  while (polygon.size() > 3) {
    const std::size_t n = polygon.size();
    std::size_t flattest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
      const Point2& before = polygon[(i + n - 1) % n].p;
      const Point2& after = polygon[(i + 1) % n].p;
      const double height = turn(before, polygon[i].p, after) / (after - before).norm();
      if (height < least) {
        least = height;
        flattest = i;
      }
    }
    if (least >= width) return;
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(flattest));
  }
}

// Leaves out the corner whose triangle with its neighbours is smallest, again and again until
// `keep` are left: the polygon shrinks by the least area, and never grows.
void drop_least_corners(std::vector<RegionPoint>& polygon, std::size_t keep) {
  while (polygon.size() > keep) {
    const std::size_t n = polygon.size();
    std::size_t least = 0;
    double least_area = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
      const double area = turn(polygon[(i + n - 1) % n].p, polygon[i].p, polygon[(i + 1) % n].p);
      if (area < least_area) {
        least_area = area;
        least = i;
      }
    }
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

// Indices of two points about as far apart as any two of the group: the point farthest from the
// first one, and the point farthest from that. If the points are on a line, these are its ends. It
// takes linear time.
std::array<std::size_t, 2> ends(const std::vector<RegionPoint>& points) {
  const auto farthest_from = [&](const Point2& p) {
    std::size_t far = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if ((points[i].p - p).squaredNorm() > (points[far].p - p).squaredNorm()) far = i;
    }
    return far;
  };
  const std::size_t first = farthest_from(points.front().p);
  return {first, farthest_from(points[first].p)};
}

// Adds the corners of one group of contacts with the same normal: of a point contact the nearest,
// of a line contact its ends, of an area the corners of its hull in the plane orthogonal to the
// normal.
void reduce_group(const std::vector<SurfaceContact>& contacts,
                  const std::vector<std::size_t>& group, const ContactOptions& options,
                  RegionWorkspace& workspace, std::vector<SurfaceContact>& reduced) {
  // Groups hold their contacts nearest first.
  const Vector3& nearest = contacts[group.front()].position;
  const bool is_a_point = std::all_of(group.begin(), group.end(), [&](std::size_t i) {
    return (contacts[i].position - nearest).norm() <= options.threshold;
  });
  if (is_a_point) {
    reduced.push_back(contacts[group.front()]);
    return;
  }
  if (group.size() == 2) {
    for (std::size_t i : group) reduced.push_back(contacts[i]);
    return;
  }
  const Vector3& normal = contacts[group.front()].normal;
  // Axes x, y, normal are right-handed, so that counter-clockwise in (x, y) is so about the normal.
  const Vector3 x = any_orthogonal(normal);
  const Vector3 y = normal.cross(x);
  std::vector<RegionPoint>& points = workspace.in_plane;
  points.clear();
  for (std::size_t i : group) {
    const Vector3& p = contacts[i].position;
    points.push_back({Point2(p.dot(x), p.dot(y)), i});
  }
  const std::array<std::size_t, 2> both_ends = ends(points);
  const std::size_t first = both_ends[0];
  const std::size_t last = both_ends[1];
  const Point2 along = points[last].p - points[first].p;
  const auto off_line = [&](const RegionPoint& c) {
    return std::abs(turn(points[first].p, points[last].p, c.p)) / along.norm();
  };
  const bool on_a_line = std::all_of(points.begin(), points.end(), [&](const RegionPoint& c) {
    return off_line(c) <= options.threshold;
  });
  if (on_a_line) {
    reduced.push_back(contacts[points[first].contact]);
    reduced.push_back(contacts[points[last].contact]);
    return;
  }
  std::vector<RegionPoint>& outline = workspace.outline;
  find_hull(points, outline);
  drop_flat_corners(outline, kFlatCorner * options.threshold);
  drop_least_corners(outline, static_cast<std::size_t>(options.max_region_corners));
  for (const RegionPoint& corner : outline) reduced.push_back(contacts[corner.contact]);
}

// contact_regions; `reduced` is replaced.
void find_regions(const std::vector<SurfaceContact>& contacts, const ContactOptions& options,
                  RegionWorkspace& workspace, std::vector<SurfaceContact>& reduced) {
  // Contacts come nearest first, and each is compared with the first of a group: its nearest
  // contact's normal decides, so that the normals of a group cannot drift from one to the next.
  auto& groups = workspace.groups;
  groups.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto same_normal = [&](const std::vector<std::size_t>& group) {
      const Vector3& n = contacts[group.front()].normal;
      return n.dot(contacts[i].normal) > 0.0 &&
             n.cross(contacts[i].normal).norm() <= options.angular_tolerance;
    };
    const auto found = std::find_if(groups.begin(), groups.end(), same_normal);
    if (found != groups.end()) {
      found->push_back(i);
    } else {
      groups.add().assign(1, i);
    }
  }
  reduced.clear();
  for (const auto& group : groups) reduce_group(contacts, group, options, workspace, reduced);
}

}  // namespace

std::vector<SurfaceContact> contact_regions(const std::vector<SurfaceContact>& contacts,
                                            const ContactOptions& options) {
  RegionWorkspace workspace;
  std::vector<SurfaceContact> reduced;
  find_regions(contacts, options, workspace, reduced);
  return reduced;
}

void find_contacts(const ProximityMesh& object, const ProximityMesh& link, const Pose& X_OL,
                   const ContactOptions& options, RegionWorkspace& workspace,
                   std::vector<SurfaceContact>& contacts) {
  find_contact_points(object, link, X_OL, options, workspace.contacts, workspace.points);
  find_regions(workspace.points, options, workspace, contacts);
}

}  // namespace prehend
