// The iteration that solves a conic program.
#pragma once

#include "sim/conic/conic_program.h"

namespace prehend {

// As solve(), for a program with independent rows of A and independent columns of [A; G], whose
// data are of the order of one. Fills in status, x, y, z, s and iterations only.
ConicSolution interior_point(const ConicProgram& program, const ConicOptions& options);

}  // namespace prehend
