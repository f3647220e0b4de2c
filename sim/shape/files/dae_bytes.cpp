// Validation of COLLADA files (XML). A minimal scanner goes through the tags once and checks
// nesting, counts, units, lists of numbers, accessors and the graph of nodes. It does not replace
// assimp's parser; it only rejects what that parser cannot handle.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/shape/files/mesh_bytes.h"
#include "sim/shape/files/text_scan.h"

namespace prehend {
namespace {

// <name attributes>: opens; </name>: closes; <name attributes/>: both.
struct Tag {
  std::string_view name;
  std::string_view attributes;
  bool opens = true;
  bool closes = false;
};

// Iterates over the tags of an XML text; skips comments, declarations and CDATA.
class Tags {
 public:
  explicit Tags(std::string_view text) : text_(text) {}

  // The text after the last tag, up to the next.
  std::string_view content() const { return text_.substr(at_, text_.find('<', at_) - at_); }

  // Whether a comment or CDATA came between the last two tags.
  bool interrupted() const { return interrupted_; }

  std::optional<Tag> next() {
    interrupted_ = false;
    while (true) {
      at_ = text_.find('<', at_);
      if (at_ == text_.npos) return std::nullopt;
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("<!--")) {
        pass("-->");
        interrupted_ = true;
      } else if (rest.starts_with("<![CDATA[")) {
        pass("]]>");
        interrupted_ = true;
      } else if (rest.starts_with("<?") || rest.starts_with("<!")) {
        pass(">");
      } else {
        return read_tag();
      }
    }
  }

 private:
  // Moves behind the next `end`.
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
  bool interrupted_ = false;
};

// The value of an attribute; none when the tag has no such attribute. Attributes are NAME="VALUE"
// or NAME='VALUE', in any order, with blanks allowed around the equals sign.
std::optional<std::string> attribute(std::string_view text, std::string_view name) {
  constexpr std::string_view kBlank = " \t\r\n";
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
    const std::size_t equals = text.find('=');
    if (equals == text.npos) return std::nullopt;
    std::string_view found = text.substr(0, equals);
    found = found.substr(0, found.find_first_of(kBlank));
    text.remove_prefix(equals + 1);
    text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
    const std::size_t end = text.empty() ? text.npos : text.find(text.front(), 1);
    if (end == text.npos) return std::nullopt;
    if (found == name) return std::string(text.substr(1, end - 1));
    text.remove_prefix(end + 1);
  }
}

// For each node its child nodes and the nodes it refers to (instance_node), by id.
using NodeGraph = std::map<std::string, std::vector<std::string>>;

// Number of nodes that `name` expands to when all references are followed. References nested in
// references multiply, so that a small file can expand to billions of nodes. Computed by
// depth-first search with memory; a node met again while it is still open contains itself.
double expanded(const NodeGraph& graph, const std::string& name,
                std::map<std::string, double>& known) {
  constexpr double kOpen = -1.0;
  const auto [place, fresh] = known.try_emplace(name, kOpen);
  if (!fresh) {
    if (place->second == kOpen) throw InputError("node " + in_quotes(name) + " contains itself");
    return place->second;
  }
  // A double: it cannot overflow like an integer.
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
      throw InputError("node " + in_quotes(name) + " stands for more than 100000 nodes");
    }
  }
}

// Checks the tags in order; open elements and open nodes are kept on stacks.
class DaeCheck {
 public:
  explicit DaeCheck(std::string_view bytes) : size_(bytes.size()), tags_(bytes) {}

  void run() {
    while (const std::optional<Tag> tag = tags_.next()) {
      if (tag->opens) open(*tag);
      if (tag->closes) close(*tag);
    }
    if (!open_.empty()) throw InputError("the XML ends inside element " + in_quotes(open_.back()));
    check_accessors();
    check_nodes(graph_);
  }

 private:
  // A view of an array: `count` groups of `stride` values from `offset` on.
  struct Accessor {
    std::string source;
    long long end = 0;  // values reached in the source
    long long stride = 0;
    long long params = 0;
  };

  // What an element of polygons promises and has.
  struct Lists {
    long long count = 0;
    long long stride = 1;    // indices of a corner, one for each offset of its inputs
    long long lists = 0;     // number of elements p
    long long indices = 0;   // in all of them
    long long polygons = 0;  // entries of vcount
    long long corners = 0;   // their sum
  };

  void open(const Tag& tag) {
    // assimp parses nested elements recursively; the limit protects its stack.
    constexpr std::size_t kDeepest = 200;
    if (is_other_surface(tag.name)) {
      throw InputError("element " + in_quotes(tag.name) +
                       " is not supported: only polygons and strips are");
    }
    check_unit(tag);
    check_list(tag);
    if (has_count(tag.name)) count_of(tag, "count", std::nullopt);
    if (is_primitive(tag.name)) lists_ = {.count = count_of(tag, "count", std::nullopt)};
    if (tag.name == "input") {
      lists_.stride = std::max(lists_.stride, count_of(tag, "offset", 0) + 1);
    }
    if (tag.name == "accessor") {
      const long long stride = count_of(tag, "stride", 1);
      // In doubles, in which the product of two counts cannot overflow.
      const double end =
          static_cast<double>(count_of(tag, "offset", 0)) +
          static_cast<double>(stride) * static_cast<double>(count_of(tag, "count", std::nullopt));
      if (end > static_cast<double>(size_)) throw InputError("an accessor reaches beyond the file");
      Accessor& accessor = accessors_.emplace_back();
      accessor.source = reference(tag, "source");
      accessor.end = static_cast<long long>(end);
      accessor.stride = stride;
    }
    if (tag.name == "param" && !accessors_.empty()) ++accessors_.back().params;
    if (tag.name == "instance_node") graph_[nodes_.back()].push_back(reference(tag, "url"));
    if (tag.name == "node") {
      const std::string id =
          attribute(tag.attributes, "id").value_or("node " + std::to_string(++unnamed_));
      if (graph_.contains(id)) throw InputError("two nodes have the id " + in_quotes(id));
      graph_[id];
      graph_[nodes_.back()].push_back(id);
      nodes_.push_back(id);
    }
    open_.emplace_back(tag.name);
    if (open_.size() > kDeepest) throw InputError("elements are nested deeper than 200");
  }

  void close(const Tag& tag) {
    if (open_.empty() || open_.back() != tag.name) {
      throw InputError("the XML closes " + in_quotes(tag.name) + " where it is not open");
    }
    if (tags_.interrupted() && (is_index_list(tag.name) || is_number_list(tag.name))) {
      throw InputError("a comment inside element " + in_quotes(tag.name));
    }
    if (tag.name == "node") nodes_.pop_back();
    if (is_primitive(tag.name)) check_lists(tag.name);
    open_.pop_back();
  }

  // Parts of a surface that assimp leaves out without a word, polygons with holes and curves, and
  // fans, which it takes for polygons: those that are not flat would be cut into other triangles.
  static bool is_other_surface(std::string_view name) {
    return name == "ph" || name == "spline" || name == "brep" || name == "trifans";
  }

  // Lists of polygons. Points and lines are no surface.
  static bool is_primitive(std::string_view name) {
    return name == "triangles" || name == "polylist" || name == "polygons" || name == "tristrips" ||
           name == "trifans";
  }

  static bool has_count(std::string_view name) {
    return name.ends_with("_array") || name == "triangles" || name == "polylist" ||
           name == "polygons" || name == "lines" || name == "tristrips" || name == "trifans" ||
           name == "linestrips";
  }

  static bool is_index_list(std::string_view name) {
    return name == "p" || name == "vcount" || name == "v" || name == "h";
  }

  static bool is_number_list(std::string_view name) {
    return name == "float_array" || name == "matrix" || name == "translate" || name == "rotate" ||
           name == "scale" || name == "lookat" || name == "skew";
  }

  // A count or offset attribute, `otherwise` where it is missing. No entry takes less than a byte,
  // so a count beyond the size of the file is wrong.
  long long count_of(const Tag& tag, std::string_view name,
                     std::optional<long long> otherwise) const {
    const std::optional<std::string> text = attribute(tag.attributes, name);
    const std::optional<long long> value = text ? integer_in(*text) : otherwise;
    if (!value || *value < 0 || *value > static_cast<long long>(size_)) {
      throw InputError("element " + in_quotes(tag.name) + " has the " + std::string(name) + " " +
                       in_quotes(text.value_or("")));
    }
    return *value;
  }

  // assimp aborts the program where an element has more lists of polygons than its count says.
  void check_lists(std::string_view name) const {
    const bool one_list = name == "triangles" || name == "polylist";
    bool fits = lists_.indices % lists_.stride == 0;
    if (name == "triangles") fits = lists_.indices == 3 * lists_.count * lists_.stride;
    if (name == "polylist") {
      fits = lists_.polygons == lists_.count && lists_.indices == lists_.corners * lists_.stride;
    }
    if (one_list ? lists_.lists > 1 : lists_.lists != lists_.count) fits = false;
    if (!fits) {
      throw InputError("element " + in_quotes(name) + " has an index count that does not fit its " +
                       std::to_string(lists_.count) + " polygons");
    }
  }

  // The id in an attribute "#id".
  static std::string reference(const Tag& tag, std::string_view name) {
    std::string target = attribute(tag.attributes, name).value_or("");
    if (target.starts_with('#')) target.erase(0, 1);
    return target;
  }

  void check_unit(const Tag& tag) const {
    if (tag.name != "unit") return;
    const std::optional<std::string> metres = attribute(tag.attributes, "meter");
    const std::optional<double> unit = metres ? number_in(*metres) : 1.0;
    if (!unit || !(*unit > 0.0) || !std::isfinite(*unit)) {
      throw InputError({.field = "unit",
                        .problem = "meter must be positive",
                        .value = in_quotes(metres.value_or(""))});
    }
  }

  // assimp loops forever on a list with a word that it cannot parse, and reads past the end of a
  // list that is shorter than its count. So every word is checked here, and the number of words for
  // float_array.
  void check_list(const Tag& tag) {
    const bool indices = is_index_list(tag.name);
    if (!indices && !is_number_list(tag.name)) return;
    long long words = 0;
    TextScan scan(tag.closes ? std::string_view() : tags_.content());
    while (scan.next_line()) {
      for (auto word = scan.next_word(); !word.empty(); word = scan.next_word()) {
        const bool good =
            indices ? word.find_first_not_of("0123456789") == word.npos && word.size() < 10
                    : number_in(word).has_value();
        if (!good) {
          throw InputError("element " + in_quotes(tag.name) + " has the entry " + in_quotes(word));
        }
        ++words;
        if (tag.name == "vcount") lists_.corners += *integer_in(word);
      }
    }
    if (tag.name == "vcount") lists_.polygons += words;
    if (tag.name == "p") {
      lists_.indices += words;
      ++lists_.lists;
    }
    if (tag.name != "float_array") return;
    if (count_of(tag, "count", std::nullopt) != words) {
      throw InputError("element 'float_array' has " + std::to_string(words) + " entries, not " +
                       std::to_string(count_of(tag, "count", std::nullopt)));
    }
    arrays_[attribute(tag.attributes, "id").value_or("")] = words;
  }

  // Accessors must not reach beyond their array. Checked at the end, when all arrays are known.
  void check_accessors() const {
    for (const Accessor& accessor : accessors_) {
      const auto array = arrays_.find(accessor.source);
      if (array == arrays_.end()) continue;  // of names, which no mesh uses
      if (accessor.end > array->second || accessor.params > accessor.stride) {
        throw InputError("an accessor reaches to entry " + std::to_string(accessor.end) + " of " +
                         std::to_string(array->second) + " of " + in_quotes(accessor.source));
      }
    }
  }

  std::size_t size_;
  Tags tags_;
  NodeGraph graph_;
  std::vector<std::string> nodes_{""};  // open nodes, the file first
  std::vector<std::string> open_;       // open elements
  std::vector<Accessor> accessors_;
  Lists lists_;
  std::map<std::string, long long> arrays_;  // lengths of the arrays of numbers
  int unnamed_ = 0;
};

}  // namespace

void check_dae(std::string_view bytes) {
  need_text(bytes);
  DaeCheck(bytes).run();
}

}  // namespace prehend
