#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "sim/base/index.h"
#include "sim/shape/files/inventor_shapes.h"
#include "sim/shape/files/inventor_tokens.h"
#include "sim/shape/files/inventor_transforms.h"
#include "sim/shape/files/inventor_tree.h"
#include "sim/shape/files/mesh_readers.h"

namespace prehend {
namespace {

using Names = std::span<const std::string_view>;

bool among(Names names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Nodes that keep to themselves what their children set.
constexpr std::array<std::string_view, 6> kSeparators{
    "Separator", "Annotation", "Selection", "Anchor", "WWWAnchor", "TopologySeparator"};
// VRML 2: their children are in the field "children".
constexpr std::array<std::string_view, 5> kGroups{"Group", "Anchor", "Billboard", "Collision",
                                                  "Transform"};
// Nodes with surfaces, or that change where surfaces are, which are not read.
constexpr std::array<std::string_view, 15> kRefused{"Coordinate4",
                                                    "Text",
                                                    "Text3",
                                                    "AsciiText",
                                                    "Extrusion",
                                                    "File",
                                                    "Inline",
                                                    "WWWInline",
                                                    "Array",
                                                    "ResetTransform",
                                                    "MultipleCopy",
                                                    "TriangleSet",
                                                    "IndexedTriangleSet",
                                                    "TriangleFanSet",
                                                    "IndexedTriangleFanSet"};
// Endings of names of nodes that are not known and sound like surfaces.
constexpr std::array<std::string_view, 9> kSurfaceEndings{
    "Mesh", "Surface", "Grid", "Shape", "Patch", "FaceSet", "Kit", "Manip", "Dragger"};
// Enough for files of a few nodes that are used again many times.
constexpr double kTrianglesBeside = 1e6;
constexpr double kVisitsBeside = 2e5;
constexpr double kPolygonWork = 1e9;

// What nodes set for those that follow them.
struct InventorState {
  InventorMap X = InventorMap::Identity();  // of the file's frame
  double unit = 1.0;                        // m
  InventorCoordinates coordinates;
};

class InventorWalk {
 public:
  InventorWalk(const InventorTree& tree, std::size_t bytes)
      : tree_(tree),
        budget_{kTrianglesBeside + static_cast<double>(bytes), kPolygonWork},
        visits_(kVisitsBeside + static_cast<double>(bytes)) {}

  TriangleMesh walk() {
    InventorState state;
    visit_all(tree_.roots, state);
    return std::move(mesh_);
  }

 private:
  void visit_all(std::span<const int> nodes, InventorState& state) {
    for (const int node : nodes) visit(tree_.nodes[index(node)], state);
  }

  void visit(const InventorNode& node, InventorState& state);
  bool visit_group(const InventorNode& node, InventorState& state);
  bool visit_vrml2(const InventorNode& node, const InventorState& state);
  void visit_chosen(const InventorNode& node, std::span<const int> nodes, const char* field,
                    InventorState& state);
  void refuse_surface(const InventorNode& node) const;
  bool holds_surface(const InventorNode& node) const;
  std::span<const int> listed(const InventorNode& node, const char* field) const;

  const InventorTree& tree_;
  InventorBudget budget_;
  double visits_;
  TriangleMesh mesh_;
};

std::span<const int> InventorWalk::listed(const InventorNode& node, const char* field) const {
  const InventorField* found = node.field(field);
  return found ? std::span<const int>(found->nodes) : std::span<const int>();
}

// Switch and its relatives: one child, none (-1) or, in Inventor, all (-3).
void InventorWalk::visit_chosen(const InventorNode& node, std::span<const int> nodes,
                                const char* field, InventorState& state) {
  const double which = node.number(field, -1.0);
  if (which == -3.0) return visit_all(nodes, state);
  if (which >= 0.0 && which < static_cast<double>(nodes.size())) {
    visit(tree_.nodes[index(nodes[static_cast<std::size_t>(which)])], state);
  }
}

bool InventorWalk::visit_vrml2(const InventorNode& node, const InventorState& state) {
  InventorState inside = state;
  if (among(kGroups, node.type)) {
    if (node.type == "Transform") inside.X = state.X * *inventor_transform(node);
    visit_all(listed(node, "children"), inside);
  } else if (node.type == "Shape") {
    visit_all(listed(node, "geometry"), inside);
  } else if (node.type == "Switch") {
    visit_chosen(node, listed(node, "choice"), "whichChoice", inside);
  } else if (node.type == "LOD") {
    const std::span<const int> levels = listed(node, "level");
    visit_all(levels.first(std::min<std::size_t>(levels.size(), 1)), inside);
  } else {
    return false;
  }
  return true;
}

bool InventorWalk::visit_group(const InventorNode& node, InventorState& state) {
  if (tree_.vrml2) return visit_vrml2(node, state);
  const std::span<const int> children(node.children);
  if (among(kSeparators, node.type)) {
    InventorState inside = state;
    visit_all(children, inside);
  } else if (node.type == "TransformSeparator") {
    const InventorMap X = state.X;
    const double unit = state.unit;
    visit_all(children, state);
    state.X = X;
    state.unit = unit;
  } else if (node.type == "Group") {
    visit_all(children, state);
  } else if (node.type == "Switch") {
    visit_chosen(node, children, "whichChild", state);
  } else if (node.type == "LOD" || node.type == "LevelOfDetail") {
    visit_all(children.first(std::min<std::size_t>(children.size(), 1)), state);
  } else {
    return false;
  }
  return true;
}

void InventorWalk::visit(const InventorNode& node, InventorState& state) {
  if (--visits_ < 0.0) {
    fail_in_line(node.line, "nodes are used again millions of times", node.type);
  }
  if (visit_group(node, state)) return;
  if (const auto X = inventor_transform(node)) {
    state.X = state.X * *X;
  } else if (const auto unit = inventor_units(node)) {
    state.X.scale(*unit / state.unit);
    state.unit = *unit;
  } else if (node.type == "Coordinate3") {
    state.coordinates.points = node.field("point");
  } else if (node.type == "ShapeHints") {
    state.coordinates.clockwise = node.word("vertexOrdering", "UNKNOWN_ORDERING") == "CLOCKWISE";
  } else if (auto faces = inventor_faces(tree_, node, state.coordinates, budget_)) {
    append(mesh_, *faces, state.X);
  } else if (auto shape = basic_inventor_shape(node)) {
    budget_.triangles -= static_cast<double>(shape->triangles.size());
    if (budget_.triangles < 0.0) fail_in_line(node.line, "millions of triangles", node.type);
    append(mesh_, *shape, state.X);
  } else {
    refuse_surface(node);
  }
}

// Of a node that is not read, whether nodes inside it have surfaces.
bool InventorWalk::holds_surface(const InventorNode& node) const {
  constexpr std::array<std::string_view, 12> kSurfaces{"Separator",
                                                       "Shape",
                                                       "Cube",
                                                       "Box",
                                                       "Cylinder",
                                                       "Cone",
                                                       "Sphere",
                                                       "Group",
                                                       "FaceSet",
                                                       "IndexedFaceSet",
                                                       "TriangleStripSet",
                                                       "Coordinate3"};
  const auto is_surface = [&](int child) {
    return among(kSurfaces, tree_.nodes[index(child)].type);
  };
  return std::any_of(node.children.begin(), node.children.end(), is_surface) ||
         std::any_of(node.fields.begin(), node.fields.end(), [&](const InventorField& field) {
           return std::any_of(field.nodes.begin(), field.nodes.end(), is_surface);
         });
}

void InventorWalk::refuse_surface(const InventorNode& node) const {
  const bool sounds_so =
      std::any_of(kSurfaceEndings.begin(), kSurfaceEndings.end(),
                  [&](std::string_view ending) { return node.type.ends_with(ending); });
  if (among(kRefused, node.type) || sounds_so || holds_surface(node)) {
    fail_in_line(node.line, "a node that cannot be read, and may have a surface", node.type);
  }
}

}  // namespace

TriangleMesh read_inventor(std::string_view text) {
  const InventorTree tree = parse_inventor(text);
  return InventorWalk(tree, text.size()).walk();
}

}  // namespace prehend
