#include "sim/shape/convex_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/shape/convex_hull.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/overhang.h"
#include "sim/shape/sphere_directions.h"
#include "sim/shape/surface_part.h"

namespace prehend {
namespace {

// Where a hull is looked at: a compromise of time and what may be overlooked.
constexpr int kSamples = 600;
// Volumes of candidate cuts are compared by the points that lie farthest along so many directions,
// of at most so many polygons.
constexpr int kDirections = 60;
constexpr std::size_t kFewCorners = 150;
constexpr std::size_t kComparedPolygons = 600;
// Planes across each axis, and overhanging points that propose planes.
constexpr int kPlanesPerAxis = 5;
constexpr std::size_t kProposers = 4;
// How much a cut in two unequal halves is held against it: cuts that save no volume by themselves
// are made in the middle.
constexpr double kBalance = 0.05;
// So many of the best cuts are compared by what the next cuts would save as well, which counts so
// much.
constexpr std::size_t kLookedAhead = 10;
constexpr double kAhead = 1.0;
// Between surfaces that do not touch, solid is looked for at so many places.
constexpr std::size_t kBetween = 8;
// More parts that do not touch each other than this are not taken one by one.
constexpr std::size_t kMostShells = 64;

struct Piece {
  SurfacePart part = {};  // empty: joined of others, not to be cut again
  TriangleMesh hull = {};
  std::vector<OverhangPoint> overhang = {};

  double depth() const { return overhang.empty() ? 0.0 : overhang.front().distance; }
};

// Directions that cover the sphere evenly, as many as are compared along.
std::vector<Vector3> compared_directions() {
  std::vector<Vector3> directions;
  for (int i = 0; i < kDirections; ++i) {
    directions.push_back(sphere_direction(i, kDirections));
  }
  for (int k = 0; k < 3; ++k) {
    directions.push_back(Vector3::Unit(k));
    directions.emplace_back(-Vector3::Unit(k));
  }
  return directions;
}

class PieceMaker {
 public:
  PieceMaker(const TriangleMesh& mesh, const ConvexPiecesOptions& options,
             const RunContext& context)
      : options_(options),
        context_(context),
        gauge_(mesh, context),
        directions_(compared_directions()),
        tolerance_(
            std::min(options.tolerance, options.relative_tolerance * bounds(mesh).diagonal())) {}

  ConvexPieces run();

 private:
  void start();
  Piece piece_of(SurfacePart part) const;
  TriangleMesh hull_of(std::vector<Vector3> points) const;
  double hull_volume(const std::vector<Vector3>& points) const;
  std::vector<CutPlane> proposed_cuts(const Piece& piece) const;
  std::optional<double> cost_of(const SurfacePart& part, const CutPlane& plane) const;
  double cost_after(const SurfacePart& part, const CutPlane& plane) const;
  std::optional<CutPlane> best_cut(const Piece& piece) const;
  bool is_held_together(const SurfacePart& a, const SurfacePart& b) const;
  std::vector<SurfacePart> pieces_in(const SurfacePart& part) const;
  bool divide_worst();
  void join();
  std::optional<Piece> joined(const Piece& a, const Piece& b) const;

  const ConvexPiecesOptions& options_;
  const RunContext& context_;
  OverhangGauge gauge_;
  std::vector<Vector3> directions_;
  double tolerance_;
  std::vector<Piece> pieces_;
};

// The hull, thickened where the points lie in a plane or on a line.
TriangleMesh PieceMaker::hull_of(std::vector<Vector3> points) const {
  TriangleMesh hull = convex_hull(points);
  if (!hull.empty()) return hull;
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      points.emplace_back(points[i] + options_.least_thickness * Vector3::Unit(k));
      points.emplace_back(points[i] - options_.least_thickness * Vector3::Unit(k));
    }
  }
  return convex_hull(points);
}

Piece PieceMaker::piece_of(SurfacePart part) const {
  Piece piece;
  piece.hull = hull_of(part.corners);
  if (!piece.hull.empty()) piece.overhang = gauge_.find(piece.hull, tolerance_, kSamples);
  piece.part = std::move(part);
  return piece;
}

// Where there are many points, of the hull of those that lie farthest along the directions: a
// little too small.
double PieceMaker::hull_volume(const std::vector<Vector3>& points) const {
  if (points.size() <= kFewCorners) {
    const TriangleMesh whole = convex_hull(points);
    return whole.empty() ? 0.0 : signed_volume(whole);
  }
  std::vector<Vector3> farthest;
  for (const Vector3& direction : directions_) {
    farthest.push_back(*std::max_element(
        points.begin(), points.end(),
        [&](const Vector3& p, const Vector3& q) { return p.dot(direction) < q.dot(direction); }));
  }
  const TriangleMesh hull = convex_hull(farthest);
  return hull.empty() ? 0.0 : signed_volume(hull);
}

// Planes across the axes; at points that overhang most, the plane of the wall below, and planes
// across it.
std::vector<CutPlane> PieceMaker::proposed_cuts(const Piece& piece) const {
  std::vector<CutPlane> cuts;
  const Bounds box = bounds(piece.hull);
  for (int k = 0; k < 3; ++k) {
    for (int i = 1; i <= kPlanesPerAxis; ++i) {
      const double at = box.lower[k] + box.size()[k] * i / (kPlanesPerAxis + 1);
      cuts.push_back({Vector3::Unit(k), at});
    }
  }
  const std::size_t step = std::max<std::size_t>(1, piece.overhang.size() / (2 * kProposers));
  for (std::size_t i = 0; i < kProposers && i * step < piece.overhang.size(); ++i) {
    const OverhangPoint& over = piece.overhang[i * step];
    const Vector3 normal = (over.position - over.nearest).normalized();
    cuts.push_back({normal, normal.dot(over.nearest)});
    for (int k = 0; k < 3; ++k) {
      const Vector3 across = normal.cross(Vector3::Unit(k));
      if (across.norm() < 0.1) continue;
      cuts.push_back({across.normalized(), across.normalized().dot(over.position)});
    }
  }
  return cuts;
}

// The volume of both sides' hulls, with what is held against unequal halves; nothing where next to
// nothing would be cut off.
std::optional<double> PieceMaker::cost_of(const SurfacePart& part, const CutPlane& plane) const {
  const auto sides = cut_points(part, plane, kComparedPolygons);
  for (const auto& side : sides) {
    double farthest = 0.0;
    for (const Vector3& p : side) farthest = std::max(farthest, std::abs(plane.height(p)));
    if (farthest < 0.1 * tolerance_) return std::nullopt;
  }
  const double below = hull_volume(sides[0]);
  const double above = hull_volume(sides[1]);
  return below + above + kBalance * std::abs(below - above);
}

// The cost that is left when each side is cut once more, in the middle across the axis where that
// saves most. Only this tells cuts of a ring apart: its halves have hulls as large as its own,
// their halves have not.
double PieceMaker::cost_after(const SurfacePart& part, const CutPlane& plane) const {
  double cost = 0.0;
  for (const SurfacePart& side : cut(part, plane)) {
    Bounds box;
    for (const Vector3& p : side.corners) {
      box.lower = box.lower.cwiseMin(p);
      box.upper = box.upper.cwiseMax(p);
    }
    double least = std::numeric_limits<double>::infinity();
    std::vector<Vector3> normals = {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
    for (int k = 0; k < 3; ++k) {
      normals.emplace_back(plane.normal.cross(Vector3::Unit(k)));
    }
    for (const Vector3& normal : normals) {
      if (normal.norm() < 0.1) continue;
      const Vector3 unit = normal.normalized();
      least = std::min(least, cost_of(side, {unit, unit.dot(box.center())}).value_or(least));
    }
    cost += least;
  }
  return cost;
}

std::optional<CutPlane> PieceMaker::best_cut(const Piece& piece) const {
  std::vector<std::pair<double, CutPlane>> cuts;
  for (const CutPlane& plane : proposed_cuts(piece)) {
    if (const auto cost = cost_of(piece.part, plane)) cuts.emplace_back(*cost, plane);
  }
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  if (cuts.size() > kLookedAhead) cuts.resize(kLookedAhead);
  std::optional<CutPlane> best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [cost, plane] : cuts) {
    const double ahead = cost + kAhead * cost_after(piece.part, plane);
    if (ahead < least) {
      least = ahead;
      best = plane;
    }
  }
  return best;
}

// Whether there is solid between two surfaces that do not touch: opposite faces of a body that was
// cut all around are of one piece.
bool PieceMaker::is_held_together(const SurfacePart& a, const SurfacePart& b) const {
  const std::size_t step = 1 + a.corners.size() / kBetween;
  for (std::size_t i = 0; i < a.corners.size(); i += step) {
    const Vector3& from = a.corners[i];
    const Vector3& to = *std::min_element(
        b.corners.begin(), b.corners.end(), [&](const Vector3& p, const Vector3& q) {
          return (p - from).squaredNorm() < (q - from).squaredNorm();
        });
    if (gauge_.contains(0.5 * (from + to))) return true;
  }
  return false;
}

std::vector<SurfacePart> PieceMaker::pieces_in(const SurfacePart& part) const {
  std::vector<SurfacePart> found;
  for (SurfacePart& next : separate_parts(part)) {
    const auto holds = std::find_if(found.begin(), found.end(), [&](const SurfacePart& other) {
      return is_held_together(next, other);
    });
    if (holds == found.end()) {
      found.push_back(std::move(next));
      continue;
    }
    for (const std::size_t end : next.ends) holds->ends.push_back(end + holds->corners.size());
    holds->corners.insert(holds->corners.end(), next.corners.begin(), next.corners.end());
  }
  return found;
}

// Cuts the piece that overhangs most; false where none has to be cut or can be.
bool PieceMaker::divide_worst() {
  Piece* worst = nullptr;
  for (Piece& piece : pieces_) {
    if (piece.part.empty() || !(piece.depth() > tolerance_)) continue;
    if (worst == nullptr || piece.depth() > worst->depth()) worst = &piece;
  }
  if (worst == nullptr) return false;
  const std::optional<CutPlane> plane = best_cut(*worst);
  const SurfacePart part = std::exchange(worst->part, {});
  if (!plane) return true;
  std::vector<Piece> made;
  for (const SurfacePart& side : cut(part, *plane)) {
    for (SurfacePart& separate : pieces_in(side)) {
      Piece piece = piece_of(std::move(separate));
      if (!piece.hull.empty()) made.push_back(std::move(piece));
    }
  }
  *worst = std::move(made.back());
  made.pop_back();
  for (Piece& piece : made) pieces_.push_back(std::move(piece));
  return true;
}

std::optional<Piece> PieceMaker::joined(const Piece& a, const Piece& b) const {
  const Bounds box = bounds(a.hull);
  const Bounds other = bounds(b.hull);
  const Vector3 slack = Vector3::Constant(tolerance_);
  if (((box.lower - slack).array() > other.upper.array()).any() ||
      ((other.lower - slack).array() > box.upper.array()).any()) {
    return std::nullopt;
  }
  std::vector<Vector3> points = a.hull.vertices;
  points.insert(points.end(), b.hull.vertices.begin(), b.hull.vertices.end());
  Piece both{.hull = convex_hull(points)};
  const double allowed = std::max({tolerance_, a.depth(), b.depth()});
  if (both.hull.empty()) return std::nullopt;
  // Most hulls of two reach out so far that a few points tell.
  for (const int samples : {kSamples / 20, kSamples}) {
    if (!gauge_.find(both.hull, allowed, samples).empty()) return std::nullopt;
  }
  both.overhang = a.depth() > b.depth() ? a.overhang : b.overhang;
  return both;
}

void PieceMaker::join() {
  for (std::size_t a = 0; a < pieces_.size(); ++a) {
    for (std::size_t b = a + 1; b < pieces_.size();) {
      context_.cancellation.check();
      std::optional<Piece> both = joined(pieces_[a], pieces_[b]);
      if (!both) {
        ++b;
        continue;
      }
      pieces_[a] = std::move(*both);
      pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(b));
      b = a + 1;
    }
  }
}

void PieceMaker::start() {
  std::vector<SurfacePart> parts = separate_parts(surface_part(gauge_.solid()));
  if (parts.size() > kMostShells) parts = {surface_part(gauge_.solid())};
  for (SurfacePart& part : parts) {
    Piece piece = piece_of(std::move(part));
    if (!piece.hull.empty()) pieces_.push_back(std::move(piece));
  }
}

ConvexPieces PieceMaker::run() {
  start();
  // Joining leaves fewer in the end.
  const auto most = static_cast<std::size_t>(options_.most);
  while (pieces_.size() < most && divide_worst()) context_.cancellation.check();
  join();
  ConvexPieces result;
  for (Piece& piece : pieces_) {
    result.overhang = std::max(result.overhang, piece.depth());
    result.pieces.push_back(std::move(piece.hull));
  }
  return result;
}

}  // namespace

ConvexPieces convex_pieces(const TriangleMesh& mesh, const ConvexPiecesOptions& options,
                           const RunContext& context) {
  if (!(options.tolerance > 0.0 && options.relative_tolerance > 0.0 && options.most >= 1 &&
        options.least_thickness > 0.0)) {
    throw InputError({.problem = "options of convex pieces must be positive"});
  }
  require_valid_indices(mesh);
  return PieceMaker(mesh, options, context).run();
}

}  // namespace prehend
