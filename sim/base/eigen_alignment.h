// A check at link time that a program and the library agree on Eigen's memory alignment.
#pragma once

#include <Eigen/Core>

namespace prehend {

// Eigen's fixed-size types are aligned for the vector extensions (-march) that a file is compiled
// for. A program compiled for other extensions than the library would disagree with it on the
// layout of structs and crash. It fails to link instead: this function is defined only for the
// library's own alignment, and every program that includes a header of prehend refers to the
// definition for the program's alignment.
template <int bytes>
int library_compiled_for_eigen_alignment();
template <>
int library_compiled_for_eigen_alignment<EIGEN_DEFAULT_ALIGN_BYTES>();

// The reference to that function; [[gnu::used]] keeps the compiler from removing it as unused.
[[gnu::used]] inline int (*const kEigenAlignment)() =
    &library_compiled_for_eigen_alignment<EIGEN_DEFAULT_ALIGN_BYTES>;

}  // namespace prehend
