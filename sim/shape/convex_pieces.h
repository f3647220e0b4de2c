// A solid as convex pieces that together are nearly the solid, for programs whose bodies have to be
// convex.
#pragma once

#include <vector>

#include "sim/base/run_context.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

struct ConvexPiecesOptions {
  // No piece reaches farther out of the solid than this, or than this part of the diagonal of the
  // solid's bounds, whichever is less [m]; > 0. Smaller values take more pieces.
  double tolerance = 1e-3;
  double relative_tolerance = 0.01;
  // No more cuts are made when there are so many pieces, before some are joined again; where they
  // do not suffice, pieces reach farther out. >= 1.
  int most = 256;
  // What is flat is made so much thicker to either side, because a convex body needs a volume [m].
  double least_thickness = 1e-4;
};

struct ConvexPieces {
  std::vector<TriangleMesh> pieces;  // convex and closed, facing outward
  // How far the worst of them reaches out of the solid; 0 where all are within the tolerance [m].
  double overhang = 0.0;
};

// Convex pieces whose union contains the surface of the mesh: the parts that do not touch each
// other, each cut in two by planes, again and again, where its hull reaches out of the solid the
// most (after Mamou and Ghorbel 2009, and Wei et al. 2022, whose measure this is: distance, not
// volume); then pieces whose common hull is within the tolerance are joined again. How far hulls
// reach out is found at points on their faces, so that the tolerance holds up to what lies between
// these. Cavities that nothing can get into may be filled; inside the solid pieces may leave gaps.
// The same mesh gives the same pieces. Throws InputError for a mesh without a triangle, for options
// out of range, and Cancelled.
ConvexPieces convex_pieces(const TriangleMesh& mesh, const ConvexPiecesOptions& options = {},
                           const RunContext& context = {});

}  // namespace prehend
