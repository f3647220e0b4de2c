// Checked access to the members of glTF's JSON objects. All functions throw InputError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <nlohmann/json.hpp>

namespace prehend {

// Throws unless the value is an object.
void need_object(const nlohmann::json& value);

// A list of the document; empty when the document has none of that name.
nlohmann::json gltf_list(const nlohmann::json& object, const char* name);

// A non-negative integer, `otherwise` where it is missing. At most 2^40, so that sums of two of
// them, and products with a valid stride (at most 252), cannot overflow.
std::uint64_t gltf_count(const nlohmann::json& object, const char* name, std::uint64_t otherwise);

// A required index into a list of `size` entries.
std::uint64_t gltf_index(const nlohmann::json& object, const char* name, std::size_t size);

// Member `name`, which must be a list of `size` numbers.
std::vector<double> gltf_numbers(const nlohmann::json& object, const char* name, std::size_t size);

}  // namespace prehend
