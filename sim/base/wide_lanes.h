// Eight numbers of single precision, or four of double, at once: in one register with AVX2, in two
// without, with the same results.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

// Before a function of which there is one more, for processors that have AVX2. What it calls has to
// be inlined.
#if defined(__x86_64__)
#define PREHEND_FOR_AVX2 [[gnu::target("avx2")]]
#else
#define PREHEND_FOR_AVX2
#endif

// Before a function that takes or returns lanes: there is no calling convention then that could
// differ between processors.
#define PREHEND_INLINE [[gnu::always_inline]] inline

namespace prehend {

// The alignment is stated: gcc takes that of the vectors that the processor of the build has, also
// for what functions for another one load and store. As arguments of templates they lose it.
using Floats8 = float __attribute__((vector_size(32), aligned(32)));
using Ints8 = int __attribute__((vector_size(32), aligned(32)));
using Longs4 = long long __attribute__((vector_size(32), aligned(32)));
using Doubles4 = double __attribute__((vector_size(32), aligned(32)));
static_assert(alignof(Floats8) == 32 && alignof(Doubles4) == 32);

// Whether this processor has AVX2. For tests of what processors without compute, the environment
// variable PREHEND_WITHOUT_AVX2 hides it.
inline bool has_avx2() {
#if defined(__x86_64__)
  // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing here changes the environment
  static const bool has =
      __builtin_cpu_supports("avx2") != 0 && std::getenv("PREHEND_WITHOUT_AVX2") == nullptr;
  return has;
#else
  return false;
#endif
}

// Replaces each number by its square root. Rounded correctly, so the same on all processors.
PREHEND_INLINE void take_roots(Floats8& numbers) {
#if defined(__x86_64__)
  __m128 halves[2];
  std::memcpy(halves, &numbers, sizeof numbers);
  halves[0] = _mm_sqrt_ps(halves[0]);
  halves[1] = _mm_sqrt_ps(halves[1]);
  std::memcpy(&numbers, halves, sizeof numbers);
#else
  for (std::size_t i = 0; i < 8; ++i) numbers[i] = std::sqrt(numbers[i]);
#endif
}

// A bit for each number that is not 0, as comparisons give them.
PREHEND_INLINE unsigned bits_of(const Ints8& is) {
#if defined(__x86_64__)
  __m128 halves[2];
  std::memcpy(halves, &is, sizeof is);
  return static_cast<unsigned>(_mm_movemask_ps(halves[0])) |
         static_cast<unsigned>(_mm_movemask_ps(halves[1])) << 4;
#else
  unsigned bits = 0;
  for (unsigned i = 0; i < 8; ++i) bits |= (is[i] != 0 ? 1U : 0U) << i;
  return bits;
#endif
}

}  // namespace prehend
