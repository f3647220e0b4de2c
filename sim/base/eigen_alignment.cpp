#include "sim/base/eigen_alignment.h"

namespace prehend {

template <>
int library_compiled_for_eigen_alignment<EIGEN_DEFAULT_ALIGN_BYTES>() {
  return EIGEN_DEFAULT_ALIGN_BYTES;
}

}  // namespace prehend
