// The nodes of an Inventor or VRML file, with their fields, before their meaning is looked at.
#pragma once

#include <string_view>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// A word or text among the values of a field.
struct InventorWord {
  std::string_view text;
  int line = 0;
};

// A field of a node: one value or a list.
struct InventorField {
  std::string_view name;
  int line = 0;
  std::vector<double> numbers = {};
  std::vector<InventorWord> words = {};  // values that are no numbers
  std::vector<int> nodes = {};           // values that are nodes: indices into InventorTree::nodes
};

// A node. The nodes of a VRML 2 group are in its field "children", those of others in `children`.
struct InventorNode {
  std::string_view type;
  int line = 0;
  std::vector<InventorField> fields = {};
  std::vector<int> children = {};  // indices into InventorTree::nodes

  // The field of this name; null: not given.
  const InventorField* field(std::string_view name) const;
  // Values of a field, or `otherwise` where it is not given. Throws InputError with the line for
  // values of another kind or number, and for numbers that are not finite or beyond 1e30.
  double number(std::string_view name, double otherwise) const;
  Vector3 vector3(std::string_view name, const Vector3& otherwise) const;
  std::vector<double> numbers(std::string_view name, std::size_t count,
                              const std::vector<double>& otherwise) const;
  std::string_view word(std::string_view name, std::string_view otherwise) const;
  bool flag(std::string_view name, bool otherwise) const;  // TRUE or FALSE
};

// A parsed file. It refers to the text, which must outlive it.
struct InventorTree {
  bool vrml2 = false;  // a node Transform has children then; else it moves what follows it
  std::vector<InventorNode> nodes;
  std::vector<int> roots;
};

// Throws InputError, one line with the line number, for text that is not Inventor 2 or VRML in
// ascii (binary and compressed files have no such text), brackets that do not match, a name that is
// used before it is defined, nodes nested deeper than 100, and more than 2,000,000 nodes and
// fields. A node may be used again (USE) by any later one, so the nodes form an acyclic graph.
InventorTree parse_inventor(std::string_view text);

// The numbers of a field. Throws InputError with the line where a value is no number.
const std::vector<double>& numbers_of(const InventorField& field);

}  // namespace prehend
