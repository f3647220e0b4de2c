// Eight numbers of single precision, or four of double, at once: in one register with AVX2, in two
// without, with the same results.
#pragma once

#include <cstddef>
#include <cstring>

// Before a function of which there is one more, for processors that have AVX2. What it calls has to
// be inlined.
#if defined(__x86_64__)
#define PREHEND_FOR_AVX2 [[gnu::target("avx2")]]
#else
#define PREHEND_FOR_AVX2
#endif

namespace prehend {

using Floats8 = float __attribute__((vector_size(32)));
using Ints8 = int __attribute__((vector_size(32)));
using Longs4 = long long __attribute__((vector_size(32)));
using Doubles4 = double __attribute__((vector_size(32)));

// Whether this processor has AVX2.
inline bool has_avx2() {
#if defined(__x86_64__)
  static const bool has = __builtin_cpu_supports("avx2") != 0;
  return has;
#else
  return false;
#endif
}

}  // namespace prehend
