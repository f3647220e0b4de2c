// A check at link time that a program and the library agree on Eigen's memory layout.
#pragma once

#include <Eigen/Core>

namespace prehend {

// Eigen lays out memory by the vector extensions (-march) that it is compiled for. A program that
// differs from the library in that would crash. Instead it does not link: the function below is
// defined for the library's own alignment only, and every program that includes a header of
// prehend's refers to the one for its own.
template <int bytes>
int library_compiled_for_eigen_alignment();
template <>
int library_compiled_for_eigen_alignment<EIGEN_DEFAULT_ALIGN_BYTES>();

// Kept by the compiler although nobody uses it.
[[gnu::used]] inline int (*const kEigenAlignment)() =
    &library_compiled_for_eigen_alignment<EIGEN_DEFAULT_ALIGN_BYTES>;

}  // namespace prehend
