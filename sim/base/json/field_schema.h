// The JSON schema (draft 2020-12) of an object whose fields are visited as in json_fields.h.
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/named_enum.h"
#include "sim/base/pose.h"

namespace prehend {

template <typename T>
inline constexpr bool kIsList = false;
template <typename T>
inline constexpr bool kIsList<std::vector<T>> = true;
template <typename T, std::size_t N>
inline constexpr bool kIsList<std::array<T, N>> = true;

// Of a value as value_to_json writes it. Vectors and poses are "#/$defs/vector3" and
// "#/$defs/pose" of the schema that this one is put into.
template <typename T>
nlohmann::ordered_json schema_of() {
  if constexpr (std::same_as<T, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::integral<T>) {
    return {{"type", "integer"}};
  } else if constexpr (std::floating_point<T>) {
    return {{"type", "number"}};
  } else if constexpr (std::same_as<T, Vector3>) {
    return {{"$ref", "#/$defs/vector3"}};
  } else if constexpr (std::same_as<T, Pose>) {
    return {{"$ref", "#/$defs/pose"}};
  } else if constexpr (NamedEnum<T>) {
    return {{"enum", enum_names(T{})}};
  } else if constexpr (kIsList<T>) {
    return {{"type", "array"}, {"items", schema_of<typename T::value_type>()}};
  } else {
    static_assert(std::same_as<T, std::string>, "a type without a schema");
    return {{"type", "string"}};
  }
}

// Writes down names and types of the fields, and which of them are always written. It has the
// functions of FieldWriter and looks at no value.
class FieldSchema {
 public:
  template <typename T>
  void operator()(std::string_view name, const T& /*value*/) {
    add(name, schema_of<T>(), true);
  }
  template <typename T>
  void operator()(std::string_view name, const std::optional<T>& /*value*/) {
    add(name, schema_of<T>(), false);
  }
  void needs(std::string_view /*name*/) {}
  void require(std::string_view /*name*/, bool /*fits*/, const char* /*what*/) {}
  void unbounded(std::string_view name, double /*value*/) {
    add(name, {{"type", {"number", "null"}}}, true);
  }
  template <typename T, typename Names>
  void named(std::string_view name, const T& /*value*/, const Names& /*names*/) {
    add(name, {{"type", "string"}}, true);
  }
  template <typename T, typename Names>
  void named_or_null(std::string_view name, const T& /*value*/, const Names& /*names*/) {
    add(name, {{"type", {"string", "null"}}}, true);
  }
  template <NamedEnum Enum>
  void counts(std::string_view name, const EnumArray<Enum, int>& /*counts*/) {
    add(name,
        {{"type", "object"},
         {"propertyNames", schema_of<Enum>()},
         {"additionalProperties", {{"type", "integer"}}}},
        true);
  }
  template <typename Visit>
  void object(std::string_view name, const Visit& visit) {
    add(name, object_schema(visit), true);
  }
  template <typename Visit>
  void object_or_null(std::string_view name, bool /*there*/, const Visit& visit) {
    add(name, object_schema(visit, nlohmann::ordered_json::array({"object", "null"})), true);
  }
  template <typename T, typename Visit>
  void part(std::string_view name, const std::optional<T>& /*value*/, const Visit& visit) {
    const T sample{};
    add(name, object_schema([&](auto& inner) { visit(inner, sample); }), false);
  }
  template <typename T, typename Visit>
  void objects(std::string_view name, const std::vector<T>& /*values*/, const Visit& visit) {
    const T sample{};
    add(name,
        {{"type", "array"}, {"items", object_schema([&](auto& inner) { visit(inner, sample); })}},
        true);
  }
  template <typename Make>
  void derived(std::string_view name, const Make& /*make*/) {
    add(name, schema_of<std::invoke_result_t<Make>>(), true);
  }
  template <typename T, typename Visit>
  void derived_part(std::string_view name, const std::optional<T>& value, const Visit& visit) {
    part(name, value, visit);
  }

  // The finished schema, which permits no other fields.
  nlohmann::ordered_json json(nlohmann::ordered_json type = "object") && {
    return {{"type", std::move(type)},
            {"required", std::move(required_)},
            {"properties", std::move(properties_)},
            {"additionalProperties", false}};
  }

 private:
  template <typename Visit>
  static nlohmann::ordered_json object_schema(const Visit& visit,
                                              nlohmann::ordered_json type = "object") {
    FieldSchema inner;
    visit(inner);
    return std::move(inner).json(std::move(type));
  }
  void add(std::string_view name, nlohmann::ordered_json schema, bool always) {
    properties_[std::string(name)] = std::move(schema);
    if (always) required_.push_back(name);
  }

  nlohmann::ordered_json properties_ = nlohmann::ordered_json::object();
  nlohmann::ordered_json required_ = nlohmann::ordered_json::array();
};

}  // namespace prehend
