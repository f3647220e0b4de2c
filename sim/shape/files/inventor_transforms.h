// How nodes of Inventor and VRML files place what follows them.
#pragma once

#include <optional>

#include "sim/shape/files/inventor_tree.h"

namespace prehend {

// Rotations and translations, perhaps with scaling and shear.
using InventorMap = Eigen::Affine3d;

// The map of a node Transform, Translation, Rotation, RotationXYZ, Scale or MatrixTransform (VRML
// 2: Transform) from coordinates behind it to those before it; nothing for other nodes. Throws
// InputError with the line for values that are no such map.
std::optional<InventorMap> inventor_transform(const InventorNode& node);

// The length of a node Units [m]; nothing for other nodes. Throws InputError with the line for a
// unit that it has not.
std::optional<double> inventor_units(const InventorNode& node);

}  // namespace prehend
