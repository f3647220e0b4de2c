#include "planner/show/picture/animated_glb.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "planner/show/picture/glb_document.h"
#include "sim/base/input_error.h"
#include "sim/base/pose.h"

namespace prehend {
namespace {

using NodeJson = GlbDocument::Json;

void check_node(const std::vector<AnimatedNode>& nodes, std::size_t n, std::size_t moments) {
  const AnimatedNode& node = nodes[n];
  const auto require_count = [&](const char* field, std::size_t count, bool fits) {
    require(
        fits,
        {.field = field, .problem = "must be as many as times", .value = std::to_string(count)});
  };
  require_count("X_PN", node.X_PN.size(), node.X_PN.size() == 1 || node.X_PN.size() == moments);
  require_count("shown", node.shown.size(), node.shown.empty() || node.shown.size() == moments);
  require(node.parent >= -1 && node.parent < static_cast<int>(n),
          {.field = "parent",
           .problem = "must be a node that stands before it",
           .value = std::to_string(node.parent)});
  for (const Pose& X : node.X_PN) {
    require(X.matrix().allFinite(), {.field = "X_PN", .problem = "must be finite"});
  }
}

void check_times(const std::vector<double>& times) {
  require(!times.empty(), {.field = "times", .problem = "must not be empty"});
  float last = -1.0F;
  for (const double each : times) {
    const auto time = static_cast<float>(each);  // as the file has it
    require(std::isfinite(time) && time >= 0.0F && time > last,
            {.field = "times",
             .problem = "must increase from 0 or more",
             .value = std::to_string(each)});
    last = time;
  }
}

// Three numbers a moment, or none where they are all the same.
std::vector<float> translations(const AnimatedNode& node) {
  std::vector<float> numbers;
  bool moves = false;
  for (const Pose& X : node.X_PN) {
    for (const double x : X.translation()) numbers.push_back(static_cast<float>(x));
    moves = moves || X.translation() != node.X_PN.front().translation();
  }
  return moves ? numbers : std::vector<float>();
}

// Four numbers a moment, or none where they are all the same. Of the two quaternions of a rotation
// the one that is nearer to the last: programs turn the way that the numbers tell.
std::vector<float> rotations(const AnimatedNode& node) {
  std::vector<float> numbers;
  bool turns = false;
  Eigen::Quaterniond last = quaternion_of(node.X_PN.front());
  for (const Pose& X : node.X_PN) {
    Eigen::Quaterniond q = quaternion_of(X).normalized();
    if (q.dot(last) < 0.0) q.coeffs() *= -1.0;
    for (const double x : q.coeffs()) numbers.push_back(static_cast<float>(x));
    turns = turns || X.linear() != node.X_PN.front().linear();
    last = q;
  }
  return turns ? numbers : std::vector<float>();
}

// Three numbers a moment, 0 where it is hidden, or none where that is always the same.
std::vector<float> scales(const AnimatedNode& node) {
  std::vector<float> numbers;
  const bool changes = std::adjacent_find(node.shown.begin(), node.shown.end(),
                                          std::not_equal_to<>()) != node.shown.end();
  if (!changes) return numbers;
  for (const bool shown : node.shown) numbers.insert(numbers.end(), 3, shown ? 1.0F : 0.0F);
  return numbers;
}

// Gathers the samplers and channels.
class AnimationLists {
 public:
  AnimationLists(GlbDocument& document, const std::vector<double>& times)
      : document_(document), times_(times.begin(), times.end()) {}

  void add(GlbIndex node, const char* path, std::size_t size, const std::vector<float>& numbers,
           const char* interpolation) {
    if (numbers.empty()) return;
    if (!input_) input_ = document_.add_keys(times_, 1);
    samplers_.push_back({{"input", *input_},
                         {"output", document_.add_keys(numbers, size)},
                         {"interpolation", interpolation}});
    channels_.push_back(
        {{"sampler", samplers_.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  }

  void finish(const std::string& name) {
    document_.set_animation(name, std::move(samplers_), std::move(channels_));
  }

 private:
  GlbDocument& document_;
  std::vector<float> times_;
  std::optional<GlbIndex> input_;
  NodeJson samplers_ = NodeJson::array();
  NodeJson channels_ = NodeJson::array();
};

NodeJson node_json(GlbDocument& document, const AnimatedNode& node) {
  NodeJson json = GlbDocument::placed(node.name, node.X_PN.back());
  if (!node.shown.empty() && !node.shown.back()) json["scale"] = {0.0, 0.0, 0.0};
  const int mesh = document.mesh_of(node.mesh, node.color);
  if (mesh >= 0) json["mesh"] = mesh;
  return json;
}

}  // namespace

std::string animated_glb(const std::vector<AnimatedNode>& nodes, const std::vector<double>& times,
                         const std::string& name, const nlohmann::ordered_json& extras,
                         double crease_angle) {
  check_times(times);
  GlbDocument document(crease_angle);
  AnimationLists lists(document, times);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const AnimatedNode& node = nodes[n];
    try {
      check_node(nodes, n, times.size());
      const GlbIndex number = document.add_node(node_json(document, node));
      if (node.parent >= 0) document.put_below(static_cast<GlbIndex>(node.parent), number);
      lists.add(number, "translation", 3, translations(node), "LINEAR");
      lists.add(number, "rotation", 4, rotations(node), "LINEAR");
      lists.add(number, "scale", 3, scales(node), "STEP");
    } catch (const InputError& error) {
      throw error.under("nodes[" + std::to_string(n) + "]");
    }
  }
  lists.finish(name);
  return document.bytes(name, extras);
}

}  // namespace prehend
