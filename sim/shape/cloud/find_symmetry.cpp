#include "sim/shape/cloud/find_symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/shape/cloud/fit_axis.h"
#include "sim/shape/cloud/image_score.h"

namespace prehend {
namespace {

constexpr int kAngles = 36;           // of mirrors, over half a turn
constexpr int kJudgingRotations = 9;  // of a turn, on which a revolution is judged
constexpr int kCompletingRotations = 16;
constexpr double kPointsApart = 0.005;
constexpr std::size_t kMostPoints = 350;
// What a symmetry must show: so much of the surface seen again, so little of it contradicted, not
// counting parts that it does not take in, which are not more than so much. A revolution states
// more than a mirror, and what it leaves out should still be round elsewhere.
constexpr double kLeastConfirmed = 0.15;
constexpr double kLeastRound = 0.28;
constexpr double kMostContradicted = 0.02;
constexpr double kMostUnround = 0.013;
constexpr double kMostApart = 0.2;
constexpr float kApart = 0.25F;  // contradiction of a point that is not taken in

// A vertical mirror: angle of its normal about z, offset from the middle.
using MirrorPlane = std::array<double, 2>;

Congruence mirror_at(const Vector3& middle, double angle, double offset) {
  const Vector3 normal(std::cos(angle), std::sin(angle), 0.0);
  Congruence image = Congruence::Identity();
  image.linear() = (Matrix3::Identity() - 2.0 * normal * normal.transpose()).cast<float>();
  image.translation() = (2.0 * (normal.dot(middle) + offset) * normal).cast<float>();
  return image;
}

std::vector<Congruence> rotations_about(const Vector3& direction, const Vector3& point, int count) {
  std::vector<Congruence> images;
  for (int k = 1; k < count; ++k) {
    const Matrix3 turn =
        Eigen::AngleAxisd(2.0 * std::numbers::pi * k / count, direction).toRotationMatrix();
    images.push_back(pose_from(turn, point - turn * point).cast<float>());
  }
  return images;
}

// A symmetry that is thought of, and its score.
struct Guess {
  Symmetry kind = Symmetry::none;
  std::vector<Congruence> images;
  ImageScore score;
};

Guess judged(Symmetry kind, std::vector<Congruence> images, const ImageScorer& scorer) {
  const ImageScore score = scorer.of(images);
  return {kind, std::move(images), score};
}

// Of axes that fit about equally well, as those of a ball, the one that shows most of what was not
// seen.
Guess best_revolution(const ImageScorer& scorer) {
  std::vector<AxisFit> axes = find_axes(scorer.points(), 3);
  axes.push_back(fit_axis(scorer.points(), Vector3::UnitZ()));
  Guess best;
  double best_value = -1e9;
  for (const AxisFit& axis : axes) {
    const Vector3 x = any_orthogonal(axis.direction);
    const Vector3 y = axis.direction.cross(x);
    // Turns of the axis about a point amid the surface, and moves of that point.
    Vector3 middle = Vector3::Zero();
    for (const SeenPoint& point : scorer.points()) middle += point.p_P;
    middle /= static_cast<double>(scorer.points().size());
    const Vector3 pivot = axis.point + axis.direction.dot(middle - axis.point) * axis.direction;
    using Change = std::array<double, 4>;
    const auto images_of = [&](const Change& c, int count) {
      const Vector3 direction = (axis.direction + c[0] * x + c[1] * y).normalized();
      return rotations_about(direction, pivot + c[2] * x + c[3] * y, count);
    };
    const auto score = [&](const Change& c) {
      return scorer.of(images_of(c, kJudgingRotations)).value();
    };
    const Change found = climb(Change{}, Change{0.08, 0.08, 0.006, 0.006}, 4, score);
    Guess guess = judged(Symmetry::revolution, images_of(found, kJudgingRotations), scorer);
    if (guess.score.confirmed < kLeastConfirmed) continue;
    const double unseen = 1.0 - guess.score.confirmed - guess.score.contradicted;
    const double value = std::min(unseen, 0.4) - 8.0 * guess.score.contradicted;
    if (value <= best_value) continue;
    best_value = value;
    guess.images = images_of(found, kCompletingRotations);
    best = std::move(guess);
  }
  return best;
}

// Scores of mirrors at all angles and offsets.
class MirrorTable {
 public:
  MirrorTable(const ImageScorer& scorer, const Vector3& middle, double reach)
      : count_(static_cast<int>(std::clamp(2.0 * reach / 0.005, 16.0, 80.0))), reach_(reach) {
    for (int a = 0; a < kAngles; ++a) {
      for (int o = 0; o <= count_; ++o) {
        value_.push_back(scorer.of(mirror_at(middle, angle(a), offset(o))).value());
      }
    }
  }

  static double angle(int a) { return std::numbers::pi * a / kAngles; }
  double offset(int o) const { return reach_ * (2.0 * o / count_ - 1.0); }
  double step() const { return 2.0 * reach_ / count_; }
  double value(int a, int o) const { return value_[index(a % kAngles * (count_ + 1) + o)]; }
  int count() const { return count_; }

  // Of an angle, the best offset. A mirror at the angle plus half a turn is the same with the
  // offset turned round.
  int best_offset(int a) const {
    int best = 0;
    for (int o = 1; o <= count_; ++o) best = value(a, o) > value(a, best) ? o : best;
    return best;
  }

 private:
  int count_;
  double reach_;
  std::vector<double> value_;
};

Guess best_mirror(const ImageScorer& scorer, const MirrorTable& table, const Vector3& middle) {
  std::vector<int> angles(kAngles);
  for (int a = 0; a < kAngles; ++a) angles[index(a)] = a;
  std::stable_sort(angles.begin(), angles.end(), [&](int a, int b) {
    return table.value(a, table.best_offset(a)) > table.value(b, table.best_offset(b));
  });
  Guess best;
  for (std::size_t k = 0; k < 5; ++k) {
    const MirrorPlane start = {table.angle(angles[k]), table.offset(table.best_offset(angles[k]))};
    const auto score = [&](const MirrorPlane& m) {
      return scorer.of(mirror_at(middle, m[0], m[1])).value();
    };
    const MirrorPlane found = climb(start, MirrorPlane{0.04, 0.5 * table.step()}, 4, score);
    Guess guess = judged(Symmetry::mirror, {mirror_at(middle, found[0], found[1])}, scorer);
    if (best.images.empty() || guess.score.value() > best.score.value()) best = std::move(guess);
  }
  return best;
}

std::vector<Congruence> two_mirrors(const Vector3& middle, double angle, double first,
                                    double second) {
  const Congruence a = mirror_at(middle, angle, first);
  const Congruence b = mirror_at(middle, angle + 0.5 * std::numbers::pi, second);
  return {a, b, a * b};
}

Guess best_two_mirrors(const ImageScorer& scorer, const MirrorTable& table, const Vector3& middle) {
  struct Start {
    std::array<double, 3> parameters{};
    double value = 0.0;
  };
  std::vector<Start> starts;
  for (int a = 0; a < kAngles / 2; ++a) {
    const double first = table.offset(table.best_offset(a));
    const double second = table.offset(table.best_offset(a + kAngles / 2));
    const std::array<double, 3> parameters = {table.angle(a), first, second};
    starts.push_back(
        {parameters, scorer.of(two_mirrors(middle, table.angle(a), first, second)).value()});
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.value > b.value; });
  Guess best;
  for (std::size_t k = 0; k < 4; ++k) {
    using Change = std::array<double, 3>;
    const auto score = [&](const Change& c) {
      return scorer.of(two_mirrors(middle, c[0], c[1], c[2])).value();
    };
    const Change step = {0.04, 0.5 * table.step(), 0.5 * table.step()};
    const Change found = climb(starts[k].parameters, step, 4, score);
    Guess guess =
        judged(Symmetry::two_mirrors, two_mirrors(middle, found[0], found[1], found[2]), scorer);
    if (best.images.empty() || guess.score.value() > best.score.value()) best = std::move(guess);
  }
  return best;
}

// Whether the views allow it, leaving out parts that it does not take in.
bool accept(const Guess& guess, const std::vector<ObjectView>& views, const ImageScorer& scorer,
            const SymmetryOptions& options, double& apart) {
  const bool round = guess.kind == Symmetry::revolution;
  if (guess.images.empty()) return false;
  if (guess.score.confirmed < (round ? kLeastRound : kLeastConfirmed)) return false;
  const std::vector<float> against = contradictions(views, scorer.points(), guess.images, options);
  double rest = 0.0;
  std::size_t left_out = 0;
  for (const float c : against) {
    if (c > kApart) {
      ++left_out;
    } else {
      rest += static_cast<double>(c);
    }
  }
  const auto count = static_cast<double>(against.size());
  apart = static_cast<double>(left_out) / count;
  return apart <= kMostApart && rest <= (round ? kMostUnround : kMostContradicted) * count;
}

}  // namespace

std::vector<float> contradictions(const std::vector<ObjectView>& views,
                                  const std::vector<SeenPoint>& points,
                                  const std::vector<Congruence>& images,
                                  const SymmetryOptions& options) {
  const ImageScorer scorer(views, points, options);
  std::vector<float> mean(points.size(), 0.0F);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = points[i].p_P.cast<float>();
    for (const Congruence& image : images) mean[i] += scorer.contradiction(image * p);
    mean[i] /= static_cast<float>(std::max<std::size_t>(images.size(), 1));
  }
  return mean;
}

FoundSymmetry find_symmetry(const std::vector<ObjectView>& views,
                            const std::vector<SeenPoint>& points, const SymmetryOptions& options) {
  const std::vector<SeenPoint> spread = thinned_points(points, kPointsApart, kMostPoints);
  FoundSymmetry found;
  if (spread.size() < 12) return found;
  const ImageScorer scorer(views, spread, options);
  Bounds box;
  for (const SeenPoint& point : spread) {
    box.lower = box.lower.cwiseMin(point.p_P);
    box.upper = box.upper.cwiseMax(point.p_P);
  }
  const auto take = [&](const Guess& guess) {
    double apart = 0.0;
    if (!accept(guess, views, scorer, options, apart)) return false;
    found = {guess.kind, guess.images, guess.score.confirmed, apart};
    return true;
  };
  if (take(best_revolution(scorer))) return found;
  const Vector3 middle = box.center();
  const MirrorTable table(scorer, middle, 0.7 * box.size().head<2>().norm());
  if (take(best_two_mirrors(scorer, table, middle))) return found;
  take(best_mirror(scorer, table, middle));
  return found;
}

}  // namespace prehend
