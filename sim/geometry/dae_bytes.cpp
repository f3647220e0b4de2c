// Checks of COLLADA files.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/geometry/input_error.h"
#include "sim/geometry/mesh_bytes.h"
#include "sim/geometry/text_scan.h"

namespace prehend {
namespace {

struct Tag {
  std::string_view name;
  std::string_view attributes;
  bool opens = true;
  bool closes = false;
};

// Tags of an XML text one by one; comments, declarations and CDATA are passed over.
class Tags {
 public:
  explicit Tags(std::string_view text) : text_(text) {}

  // The text after the last tag, up to the next.
  std::string_view content() const { return text_.substr(at_, text_.find('<', at_) - at_); }

  std::optional<Tag> next() {
    while (true) {
      at_ = text_.find('<', at_);
      if (at_ == text_.npos) return std::nullopt;
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("<!--")) {
        pass("-->");
      } else if (rest.starts_with("<![CDATA[")) {
        pass("]]>");
      } else if (rest.starts_with("<?") || rest.starts_with("<!")) {
        pass(">");
      } else {
        return read_tag();
      }
    }
  }

 private:
  void pass(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    if (found == text_.npos) throw InputError("the XML ends inside a comment or declaration");
    at_ = found + end.size();
  }

  Tag read_tag() {
    const std::size_t end = text_.find('>', at_);
    if (end == text_.npos) throw InputError("the XML ends inside a tag");
    std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    Tag tag;
    if (inside.starts_with('/')) {
      inside.remove_prefix(1);
      tag.opens = false;
      tag.closes = true;
    }
    if (inside.ends_with('/')) {
      inside.remove_suffix(1);
      tag.closes = true;
    }
    const std::size_t length = std::min(inside.find_first_of(" \t\r\n"), inside.size());
    tag.name = inside.substr(0, length);
    tag.attributes = inside.substr(length);
    return tag;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

std::string attribute(std::string_view attributes, const std::string& name) {
  for (const char quote : {'"', '\''}) {
    const std::string start = " " + name + "=" + quote;
    const std::size_t found = attributes.find(start);
    if (found == attributes.npos) continue;
    const std::size_t first = found + start.size();
    const std::size_t last = attributes.find(quote, first);
    if (last != attributes.npos) return std::string(attributes.substr(first, last - first));
  }
  return {};
}

// Nodes by what they contain: nodes inside them and nodes they refer to.
using NodeGraph = std::map<std::string, std::vector<std::string>>;

// How many nodes `name` stands for once every reference is followed; cycles are refused.
double expanded(const NodeGraph& graph, const std::string& name,
                std::map<std::string, double>& known) {
  constexpr double kOpen = -1.0;
  const auto [place, fresh] = known.try_emplace(name, kOpen);
  if (!fresh) {
    if (place->second == kOpen) throw InputError("node " + quoted(name) + " contains itself");
    return place->second;
  }
  double total = 1.0;
  const auto node = graph.find(name);
  if (node != graph.end()) {
    for (const std::string& part : node->second) total += expanded(graph, part, known);
  }
  known[name] = total;
  return total;
}

void check_nodes(const NodeGraph& graph) {
  constexpr double kMostNodes = 1e5;
  std::map<std::string, double> known;
  for (const auto& [name, parts] : graph) {
    if (expanded(graph, name, known) > kMostNodes) {
      throw InputError("node " + quoted(name) + " stands for more than 100000 nodes");
    }
  }
}

// Follows the tags: nesting, counts, units, indices and the graph of nodes.
class DaeCheck {
 public:
  explicit DaeCheck(std::string_view bytes) : size_(bytes.size()), tags_(bytes) {}

  void run() {
    while (const std::optional<Tag> tag = tags_.next()) {
      if (tag->opens) open(*tag);
      if (tag->closes) close(*tag);
    }
    if (!open_.empty()) throw InputError("the XML ends inside element " + quoted(open_.back()));
    check_nodes(graph_);
  }

 private:
  void open(const Tag& tag) {
    constexpr std::size_t kDeepest = 200;
    check_numbers(tag);
    if (tag.name == "instance_node") {
      std::string target = attribute(tag.attributes, "url");
      if (target.starts_with('#')) target.erase(0, 1);
      graph_[nodes_.back()].push_back(target);
    }
    if (tag.name == "node") {
      std::string id = attribute(tag.attributes, "id");
      if (id.empty()) id = "node " + std::to_string(++unnamed_);
      if (graph_.contains(id)) throw InputError("two nodes have the id " + quoted(id));
      graph_[id];
      graph_[nodes_.back()].push_back(id);
      nodes_.push_back(id);
    }
    open_.emplace_back(tag.name);
    if (open_.size() > kDeepest) throw InputError("elements are nested deeper than 200");
  }

  void check_numbers(const Tag& tag) const {
    const std::string count = attribute(tag.attributes, "count");
    const std::optional<long long> value = integer_in(count);
    if (!count.empty() && (!value || *value < 0 || *value > static_cast<long long>(size_))) {
      throw InputError("element " + quoted(tag.name) + " has the count " + quoted(count));
    }
    const std::string metres = attribute(tag.attributes, "meter");
    if (tag.name == "unit" && !metres.empty()) {
      const std::optional<double> unit = number_in(metres);
      if (!unit || !(*unit > 0.0) || !std::isfinite(*unit)) {
        throw InputError("unit: meter must be positive (" + quoted(metres) + ")");
      }
    }
    if (tag.name == "p" && tags_.content().find('-') != std::string_view::npos) {
      throw InputError("element 'p' has a negative index");
    }
  }

  void close(const Tag& tag) {
    if (open_.empty() || open_.back() != tag.name) {
      throw InputError("the XML closes " + quoted(tag.name) + " where it is not open");
    }
    if (tag.name == "node") nodes_.pop_back();
    open_.pop_back();
  }

  std::size_t size_;
  Tags tags_;
  NodeGraph graph_;
  std::vector<std::string> nodes_{""};  // open nodes, the file first
  std::vector<std::string> open_;       // open elements
  int unnamed_ = 0;
};

}  // namespace

void check_dae(std::string_view bytes) {
  need_text(bytes);
  DaeCheck(bytes).run();
}

}  // namespace prehend
