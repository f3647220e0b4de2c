// Names for results, made of what the results depend on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "sim/base/pose.h"

namespace prehend {

// Collects contents and makes a name of them: 32 hexadecimal digits, those of XXH3 with 128 bits.
// Different contents have different names but by accident, with a probability of 1e-20 among 1e9 of
// them; the hash is no protection against contents that were made to collide.
class ContentKey {
 public:
  ContentKey();
  ~ContentKey();
  ContentKey(const ContentKey&) = delete;
  ContentKey& operator=(const ContentKey&) = delete;

  // Contents are kept apart: "ab" and "c" are not "a" and "bc".
  ContentKey& add(std::string_view content);
  ContentKey& add(double number);
  ContentKey& add(std::uint64_t number);

  std::string name() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// The name of what a mesh file says: of its bytes, and of those of the files that it refers to for
// its shape (the buffers of .gltf). Throws InputError as read_file.
std::string mesh_file_key(const std::filesystem::path& file);

}  // namespace prehend
