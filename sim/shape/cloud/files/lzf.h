// Decompression of LZF (Lehmann's LibLZF), by which PCD files are compressed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace prehend {

// The `size` bytes that were compressed. Throws InputError where these are not so many, also before
// memory is taken where they cannot be: a byte stands for at most 88 others.
std::string decompressed_lzf(std::string_view bytes, std::size_t size);

}  // namespace prehend
