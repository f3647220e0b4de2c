#include "planner/results/datasets/hdf5/checksum.h"

#include <algorithm>
#include <array>
#include <bit>

namespace prehend::hdf5 {
namespace {

using Words = std::array<std::uint32_t, 3>;

// Adds up to 12 bytes.
void add(Words& words, Bytes bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    words.at(i / 4) += std::uint32_t{bytes[i]} << (8 * (i % 4));
  }
}

void mix(Words& words) {
  auto& [a, b, c] = words;
  a -= c, a ^= std::rotl(c, 4), c += b;
  b -= a, b ^= std::rotl(a, 6), a += c;
  c -= b, c ^= std::rotl(b, 8), b += a;
  a -= c, a ^= std::rotl(c, 16), c += b;
  b -= a, b ^= std::rotl(a, 19), a += c;
  c -= b, c ^= std::rotl(b, 4), b += a;
}

void finish(Words& words) {
  auto& [a, b, c] = words;
  c ^= b, c -= std::rotl(b, 14);
  a ^= c, a -= std::rotl(c, 11);
  b ^= a, b -= std::rotl(a, 25);
  c ^= b, c -= std::rotl(b, 16);
  a ^= c, a -= std::rotl(c, 4);
  b ^= a, b -= std::rotl(a, 14);
  c ^= b, c -= std::rotl(b, 24);
}

}  // namespace

std::uint32_t lookup3(Bytes bytes) {
  Words words{};
  words.fill(0xdeadbeefU + static_cast<std::uint32_t>(bytes.size()));
  if (bytes.empty()) return words[2];
  for (; bytes.size() > 12; bytes = bytes.subspan(12)) {
    add(words, bytes.first(12));
    mix(words);
  }
  add(words, bytes);
  finish(words);
  return words[2];
}

std::uint32_t fletcher32(Bytes bytes) {
  constexpr std::size_t kBlock = 720;  // bytes whose sums stay below 2^32
  const auto fold = [](std::uint32_t sum) { return (sum & 0xffffU) + (sum >> 16U); };
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  while (!bytes.empty()) {
    const Bytes block = bytes.first(std::min(kBlock, bytes.size()));
    for (std::size_t i = 0; i < block.size(); i += 2) {
      first += std::uint32_t{block[i]} << 8U;
      if (i + 1 < block.size()) first += block[i + 1];
      second += first;
    }
    first = fold(first);
    second = fold(second);
    bytes = bytes.subspan(block.size());
  }
  return fold(second) << 16U | fold(first);
}

}  // namespace prehend::hdf5
