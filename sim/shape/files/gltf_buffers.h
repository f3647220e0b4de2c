// The binary data of glTF files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace prehend {

// The buffers of a glTF document, one behind the other, each at a multiple of 4 bytes.
struct GltfBuffers {
  std::string bytes;
  std::vector<std::size_t> starts;   // of each buffer, in `bytes`
  std::vector<std::size_t> lengths;  // as declared, in bytes
};

// Fetches the buffers of the list `buffers` (glTF 2.0 specification, section 3.6.1): the binary
// chunk of a GLB for a first buffer without uri, base64 data inside a uri, or a regular *.bin file
// in `folder`. Throws InputError where there are less bytes than declared, for a uri of another
// kind, for letters that are not base64, and for buffers of more than 2 GiB together.
GltfBuffers fetch_gltf_buffers(const nlohmann::json& buffers, std::string_view chunk,
                               const std::filesystem::path& folder);

// The bytes that base64 text stands for (RFC 4648, section 4). Throws InputError on letters that
// are none of its alphabet, and where the text ends inside a byte. The padding may be missing.
std::string from_base64(std::string_view text);

}  // namespace prehend
