// Linear elasticity of a solid made of hexahedra, and how its surface yields to forces.
#pragma once

#include <span>
#include <vector>

#include <Eigen/SparseCore>

#include "sim/base/run_context.h"
#include "sim/soft/elastic_material.h"
#include "sim/soft/hex_mesh.h"

namespace prehend {

// The stiffness matrix, 3n x 3n for n nodes [N/m]: row 3i + k is the force on node i along axis k.
// Trilinear displacements; the change of volume is averaged over each element, so that nearly
// incompressible materials do not lock. Source: Hughes, "Generalization of selective integration
// procedures to anisotropic and nonlinear media", 1980 (the mean-dilatation B-bar element).
//
// Throws InputError for a material out of range and for an element that is turned inside out or
// folded, with its number.
Eigen::SparseMatrix<double> stiffness_matrix(const HexMesh& mesh, const ElasticMaterial& material);

// The compliance matrix of the components `loaded` (3i + k as above): entry (a, b) is the
// displacement of loaded[a] under a unit force on loaded[b] [m/N], with all components `held` at
// rest. Symmetric up to rounding, and then made exactly so. This is the static condensation of the
// solid onto these components.
//
// Throws InputError where `held` lets the solid move as a whole, or names a loaded component;
// Cancelled.
Eigen::MatrixXd compliance_matrix(const Eigen::SparseMatrix<double>& stiffness,
                                  const std::vector<bool>& held, std::span<const int> loaded,
                                  const RunContext& context = {});

}  // namespace prehend
