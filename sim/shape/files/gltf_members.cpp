#include "sim/shape/files/gltf_members.h"

#include <string>

#include "sim/base/input_error.h"

namespace prehend {

void need_object(const nlohmann::json& value) {
  if (!value.is_object()) throw InputError("an entry is not an object");
}

nlohmann::json gltf_list(const nlohmann::json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return nlohmann::json::array();
  if (!found->is_array()) throw InputError({.field = name, .problem = "is not a list"});
  return *found;
}

std::uint64_t gltf_count(const nlohmann::json& object, const char* name, std::uint64_t otherwise) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;
  const auto found = object.find(name);
  if (found == object.end()) return otherwise;
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > kMost) {
    throw InputError(
        {.field = name, .problem = "is not a count", .value = found->dump().substr(0, 40)});
  }
  return found->get<std::uint64_t>();
}

std::uint64_t gltf_index(const nlohmann::json& object, const char* name, std::size_t size) {
  constexpr std::uint64_t kMissing = ~std::uint64_t{0};
  const std::uint64_t index = gltf_count(object, name, kMissing);
  if (index == kMissing) throw InputError({.field = name, .problem = "is missing"});
  if (index >= size) {
    throw InputError(
        {.field = name,
         .problem = "refers to entry " + std::to_string(index) + " of " + std::to_string(size)});
  }
  return index;
}

std::vector<double> gltf_numbers(const nlohmann::json& object, const char* name, std::size_t size) {
  const nlohmann::json& list = object.at(name);
  bool fits = list.is_array() && list.size() == size;
  for (std::size_t i = 0; fits && i < size; ++i) fits = list[i].is_number();
  if (!fits)
    throw InputError({.field = name, .problem = "must be " + std::to_string(size) + " numbers"});
  return list.get<std::vector<double>>();
}

}  // namespace prehend
