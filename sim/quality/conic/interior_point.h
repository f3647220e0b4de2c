// The interior point iteration that solves a conic program, without scaling and reduction.
#pragma once

#include "sim/quality/conic/conic_program.h"

namespace prehend {

// As solve() (conic_program.h), for a program whose rows of A and columns of [A; G] are linearly
// independent and whose entries are of the order of one. Fills in status, x, y, z, s and iterations
// only.
ConicSolution interior_point(const ConicProgram& program, const ConicOptions& options);

}  // namespace prehend
