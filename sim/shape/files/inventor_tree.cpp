#include "sim/shape/files/inventor_tree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "sim/base/index.h"
#include "sim/base/range.h"
#include "sim/shape/files/inventor_tokens.h"
#include "sim/shape/files/text_scan.h"

namespace prehend {
namespace {

constexpr int kDeepestInventor = 100;
constexpr std::size_t kMostInventorParts = 2'000'000;

class InventorParser {
 public:
  InventorParser(std::string_view text, InventorTree& tree) : tokens_(text), tree_(tree) {}

  void read_all() {
    while (tokens_.peek().kind != InventorToken::Kind::end) {
      if (!skip_route()) tree_.roots.push_back(read_node(0));
    }
  }

 private:
  bool at_node() const {
    const InventorToken& token = tokens_.peek();
    return token.is_word() &&
           (token.text == "DEF" || token.text == "USE" || tokens_.peek_second().is("{"));
  }

  // ROUTE A.field TO B.field: animation.
  bool skip_route() {
    if (!tokens_.peek().is_word() || tokens_.peek().text != "ROUTE") return false;
    for (int word = 0; word < 4; ++word) need_word("the rest of ROUTE");
    return true;
  }

  InventorToken need_word(const std::string& what) {
    const InventorToken token = tokens_.next();
    if (!token.is_word()) fail_in_line(token.line, what + " is missing", token.text);
    return token;
  }

  void spend() {
    if (++parts_ > kMostInventorParts) {
      fail_in_line(tokens_.peek().line, "more than 2,000,000 nodes and fields");
    }
  }

  int read_node(int depth);
  int read_body(const InventorToken& type, int depth);
  void read_field(InventorNode& node, int depth);
  void read_value(InventorField& field, int depth);
  void read_list(InventorField& field, int depth);

  InventorTokens tokens_;
  InventorTree& tree_;
  std::map<std::string_view, int> named_;
  std::size_t parts_ = 0;
};

void add_number(InventorField& field, const InventorToken& token) {
  const std::optional<double> value = number_in(token.text);
  if (value) {
    field.numbers.push_back(*value);
  } else {
    field.words.push_back({token.text, token.line});
  }
}

int InventorParser::read_node(int depth) {
  const InventorToken first = need_word("a node");
  if (first.text == "PROTO" || first.text == "EXTERNPROTO") {
    fail_in_line(first.line, "node types defined in the file cannot be read", first.text);
  }
  if (first.text == "USE") {
    const InventorToken name = need_word("the name of a node");
    const auto found = named_.find(name.text);
    if (found == named_.end()) fail_in_line(name.line, "no node of this name before", name.text);
    return found->second;
  }
  if (first.text != "DEF") return read_body(first, depth);
  const InventorToken name = need_word("the name of a node");
  const InventorToken type = need_word("a node");
  const int node = read_body(type, depth);
  // Known only from here on, so no node can contain itself.
  named_[name.text] = node;
  return node;
}

int InventorParser::read_body(const InventorToken& type, int depth) {
  if (depth > kDeepestInventor) fail_in_line(type.line, "nodes are nested deeper than 100");
  if (!tokens_.peek().is("{")) fail_in_line(type.line, "not a node: no { follows", type.text);
  tokens_.next();
  spend();
  InventorNode node{.type = type.text, .line = type.line};
  while (!tokens_.peek().is("}")) {
    if (tokens_.peek().kind == InventorToken::Kind::end) {
      fail_in_line(type.line, "the { of this node is not closed", type.text);
    }
    if (skip_route()) continue;
    if (at_node()) {
      node.children.push_back(read_node(depth + 1));
    } else {
      read_field(node, depth);
    }
  }
  tokens_.next();
  tree_.nodes.push_back(std::move(node));
  return static_cast<int>(tree_.nodes.size()) - 1;
}

void InventorParser::read_field(InventorNode& node, int depth) {
  const InventorToken name = need_word("the name of a field");
  if (name.is_numeric()) fail_in_line(name.line, "a number where a field begins", name.text);
  spend();
  InventorField field{.name = name.text, .line = name.line};
  read_value(field, depth);
  node.fields.push_back(std::move(field));
}

void InventorParser::read_value(InventorField& field, int depth) {
  const InventorToken& token = tokens_.peek();
  if (token.is("[")) {
    read_list(field, depth);
  } else if (token.is("(")) {
    for (tokens_.next(); tokens_.peek().is_word();) {
      const InventorToken word = tokens_.next();
      field.words.push_back({word.text, word.line});
    }
    if (!tokens_.next().is(")")) fail_in_line(field.line, "the ( is not closed", field.name);
  } else if (token.is_numeric()) {
    while (tokens_.peek().is_numeric()) add_number(field, tokens_.next());
  } else if (at_node()) {
    field.nodes.push_back(read_node(depth + 1));
  } else if (token.is_word() || token.kind == InventorToken::Kind::text) {
    if (token.is("=") || token.is("IS")) {
      fail_in_line(token.line, "fields that are connected to others cannot be read", field.name);
    }
    const InventorToken word = tokens_.next();
    if (!word.is("NULL")) field.words.push_back({word.text, word.line});
  } else {
    fail_in_line(field.line, "a field without a value", field.name);
  }
  if (tokens_.peek().is("~")) tokens_.next();  // Marks fields that are to be ignored.
}

void InventorParser::read_list(InventorField& field, int depth) {
  tokens_.next();
  while (!tokens_.peek().is("]")) {
    if (at_node()) {
      field.nodes.push_back(read_node(depth + 1));
      continue;
    }
    if (skip_route()) continue;
    const InventorToken token = tokens_.next();
    if (token.is_word()) {
      add_number(field, token);
    } else if (token.kind == InventorToken::Kind::text) {
      field.words.push_back({token.text, token.line});
    } else {
      fail_in_line(field.line, "the [ of this field is not closed", field.name);
    }
  }
  tokens_.next();
}

bool is_vrml2(std::string_view text) {
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  const bool inventor = line.starts_with("#Inventor V2");
  const bool vrml1 = line.starts_with("#VRML V1");
  const bool vrml2 = line.starts_with("#VRML V2");
  if (!inventor && !vrml1 && !vrml2) {
    fail_in_line(1, "neither #Inventor V2.x ascii nor #VRML V1.0 ascii nor #VRML V2.0 utf8", line);
  }
  if (line.find("binary") != std::string_view::npos) {
    fail_in_line(1, "binary Inventor files cannot be read, only ascii", line);
  }
  return vrml2;
}

}  // namespace

const InventorField* InventorNode::field(std::string_view name) const {
  for (const InventorField& field : fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

const std::vector<double>& numbers_of(const InventorField& field) {
  if (!field.words.empty()) {
    fail_in_line(field.words.front().line, "not a number", field.words.front().text);
  }
  if (!field.nodes.empty()) fail_in_line(field.line, "must be numbers, not nodes", field.name);
  return field.numbers;
}

std::vector<double> InventorNode::numbers(std::string_view name, std::size_t count,
                                          const std::vector<double>& otherwise) const {
  const InventorField* found = field(name);
  if (!found) return otherwise;
  const std::vector<double>& values = numbers_of(*found);
  if (values.size() != count) {
    fail_in_line(found->line,
                 "must be " + std::to_string(count) + (count == 1 ? " number" : " numbers"), name);
  }
  for (const double value : values) {
    if (!(std::abs(value) <= kLargestNumber)) {
      fail_in_line(found->line, "not a finite number within 1e30", name);
    }
  }
  return values;
}

double InventorNode::number(std::string_view name, double otherwise) const {
  return numbers(name, 1, {otherwise}).front();
}

Vector3 InventorNode::vector3(std::string_view name, const Vector3& otherwise) const {
  const std::vector<double> v = numbers(name, 3, {otherwise.x(), otherwise.y(), otherwise.z()});
  return {v[0], v[1], v[2]};
}

std::string_view InventorNode::word(std::string_view name, std::string_view otherwise) const {
  const InventorField* found = field(name);
  if (!found) return otherwise;
  if (found->words.size() != 1) fail_in_line(found->line, "must be one word", name);
  return found->words.front().text;
}

bool InventorNode::flag(std::string_view name, bool otherwise) const {
  const std::string_view value = word(name, otherwise ? "TRUE" : "FALSE");
  if (value != "TRUE" && value != "FALSE") {
    fail_in_line(field(name)->line, "must be TRUE or FALSE", value);
  }
  return value == "TRUE";
}

InventorTree parse_inventor(std::string_view text) {
  InventorTree tree;
  tree.vrml2 = is_vrml2(text);
  InventorParser(text, tree).read_all();
  return tree;
}

}  // namespace prehend
