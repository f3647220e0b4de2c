// Reading and writing the fields of a JSON object with one function. The fields are named once, in
// a function template that visits them: given a FieldWriter it writes the object, given a
// FieldReader it reads it. So the written and the read fields cannot differ, and the reader knows
// all permitted names.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/base/joined.h"
#include "sim/base/json/json_field.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/named_enum.h"

namespace prehend {

// Conversion of a value to JSON and back. read_value throws InputError that names the file and the
// field when the type does not fit.
inline nlohmann::ordered_json value_to_json(const Vector3& value) { return vector_to_json(value); }
inline nlohmann::ordered_json value_to_json(const Pose& value) { return pose_to_json(value); }
// Takes a reference as the template for all types does: gcc finds one that takes a value ambiguous
// with it.
template <NamedEnum Enum>
nlohmann::ordered_json value_to_json(const Enum& value) {
  return name_of(value);
}
template <typename T>
nlohmann::ordered_json value_to_json(const T& value) {
  return value;
}

inline void read_value(const JsonField& field, double& value) { value = field.number(); }
inline void read_value(const JsonField& field, bool& value) { value = field.boolean(); }
inline void read_value(const JsonField& field, int& value) { value = field.integer(); }
inline void read_value(const JsonField& field, std::uint64_t& value) {
  value = field.unsigned_integer();
}
inline void read_value(const JsonField& field, std::string& value) { value = field.text(); }
inline void read_value(const JsonField& field, Vector3& value) { value = field.vector3(); }
inline void read_value(const JsonField& field, Pose& value) { value = read_pose(field); }
template <NamedEnum Enum>
void read_value(const JsonField& field, Enum& value) {
  const std::optional<Enum> named = value_named<Enum>(field.text());
  if (!named) field.fail("must be one of " + joined(enum_names(Enum{})));
  value = *named;
}
template <typename T>
void read_value(const JsonField& field, std::optional<T>& value) {
  read_value(field, value.emplace());
}
template <typename T>
void read_value(const JsonField& field, std::vector<T>& values) {
  values.clear();
  for (const JsonField& item : field.items()) read_value(item, values.emplace_back());
}

// Pairs of a name in the file and its meaning, such as the index of an entry of a list.
template <typename T>
using ValueNames = std::vector<std::pair<std::string, T>>;

// Writes fields to a JSON object in the order in which they are visited. It has the functions of
// FieldReader that visitors call; the checks (needs, require) do nothing here.
class FieldWriter {
 public:
  // A field with a plain value (value_to_json).
  template <typename T>
  void operator()(std::string_view name, const T& value) {
    json_[std::string(name)] = value_to_json(value);
  }
  // A field that is left out when it has no value.
  template <typename T>
  void operator()(std::string_view name, const std::optional<T>& value) {
    if (value) (*this)(name, *value);
  }
  void needs(std::string_view /*name*/) {}
  // A number that may be infinite, which no number of JSON is: null stands for it.
  void unbounded(std::string_view name, double value) {
    json_[std::string(name)] = std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
  }
  // A field that holds the name of `value`; left out when `names` has none for it.
  template <typename T>
  void named(std::string_view name, const T& value, const ValueNames<T>& names) {
    for (const auto& [word, meaning] : names) {
      if (meaning == value) json_[std::string(name)] = word;
    }
  }
  // The same of a value that may be missing: null then.
  template <typename T>
  void named_or_null(std::string_view name, const std::optional<T>& value,
                     const ValueNames<T>& names) {
    json_[std::string(name)] = nullptr;
    if (value) named(name, *value, names);
  }
  // A nested object; visit(fields) visits its fields.
  template <typename Visit>
  void object(std::string_view name, const Visit& visit) {
    FieldWriter inner;
    visit(inner);
    json_[std::string(name)] = std::move(inner).json();
  }
  // A nested object that is null unless it is `there`.
  template <typename Visit>
  void object_or_null(std::string_view name, bool there, const Visit& visit) {
    json_[std::string(name)] = nullptr;
    if (there) object(name, visit);
  }
  // A nested object that is left out where it has no value; visit(fields, value) visits its fields.
  template <typename T, typename Visit>
  void part(std::string_view name, const std::optional<T>& value, const Visit& visit) {
    if (value) object(name, [&](auto& inner) { visit(inner, *value); });
  }
  // An object with a count for each value of an enum that occurs.
  template <NamedEnum Enum>
  void counts(std::string_view name, const EnumArray<Enum, int>& counts) {
    nlohmann::ordered_json& json = json_[std::string(name)] = nlohmann::ordered_json::object();
    for (const Enum value : kAll<Enum>) {
      if (counts[value] > 0) json[std::string(name_of(value))] = counts[value];
    }
  }
  // A list of objects; visit(fields, value) visits the fields of one entry.
  template <typename T, typename Visit>
  void objects(std::string_view name, const std::vector<T>& values, const Visit& visit) {
    json_[std::string(name)] = nlohmann::ordered_json::array();
    for (const T& value : values) {
      FieldWriter inner;
      visit(inner, value);
      json_[std::string(name)].push_back(std::move(inner).json());
    }
  }
  // A field that is written for the reader's information only, because it follows from other fields
  // or from the scene; reading ignores it. make() returns its value; left out where that is an
  // empty optional.
  template <typename Make>
  void derived(std::string_view name, const Make& make) {
    (*this)(name, make());
  }
  // The same of a part.
  template <typename T, typename Visit>
  void derived_part(std::string_view name, const std::optional<T>& value, const Visit& visit) {
    part(name, value, visit);
  }
  void require(std::string_view /*name*/, bool /*fits*/, const char* /*what*/) {}

  // The finished object.
  nlohmann::ordered_json json() && { return std::move(json_); }

 private:
  nlohmann::ordered_json json_ = nlohmann::ordered_json::object();
};

// Reads the fields that are present; the values of absent fields keep what they were. Every
// function throws InputError that names the file and the field.
class FieldReader {
 public:
  explicit FieldReader(const JsonField& object) : object_(object) {}

  // Registers `name` as permitted. True when the field is present.
  bool allow(std::string_view name) {
    known_.emplace_back(name);
    return object_.has(name);
  }

  // A field with a plain value (read_value).
  template <typename T>
  void operator()(std::string_view name, T& value) {
    if (allow(name)) read_value(object_[name], value);
  }
  // Throws InputError when the field is missing.
  void needs(std::string_view name) { (void)object_[name]; }
  // A field that holds one of `names`. Throws InputError that lists them for any other text.
  template <typename T>
  void named(std::string_view name, T& value, const ValueNames<T>& names) {
    if (!allow(name)) return;
    const std::string word = object_[name].text();
    std::string known;
    for (const auto& [candidate, meaning] : names) {
      if (candidate == word) {
        value = meaning;
        return;
      }
      add_part(known, candidate);
    }
    object_[name].fail("must be one of " + known);
  }
  // A nested object; unknown fields in it are errors.
  template <typename Visit>
  void object(std::string_view name, const Visit& visit) {
    if (!allow(name)) return;
    FieldReader inner(object_[name]);
    visit(inner);
    inner.finish();
  }
  template <typename Visit>
  void object_or_null(std::string_view name, bool /*there*/, const Visit& visit) {
    object(name, visit);
  }
  template <typename T, typename Visit>
  void part(std::string_view name, std::optional<T>& value, const Visit& visit) {
    object(name, [&](auto& inner) { visit(inner, value.emplace()); });
  }
  // A list of objects, which replaces `values`; unknown fields in them are errors.
  template <typename T, typename Visit>
  void objects(std::string_view name, std::vector<T>& values, const Visit& visit) {
    if (!allow(name)) return;
    values.clear();
    for (const JsonField& item : object_[name].items()) {
      FieldReader inner(item);
      visit(inner, values.emplace_back());
      inner.finish();
    }
  }
  // Permitted, but not read.
  template <typename Make>
  void derived(std::string_view name, const Make& /*make*/) {
    allow(name);
  }
  template <typename T, typename Visit>
  void derived_part(std::string_view name, const std::optional<T>& /*value*/,
                    const Visit& /*visit*/) {
    allow(name);
  }
  // Throws InputError with the text `what` at the field when `fits` is false: the value was read
  // but is not valid here.
  void require(std::string_view name, bool fits, const char* what) {
    if (!fits) object_[name].fail(what);
  }

  // To be called after all fields have been visited: throws InputError at the first field whose
  // name was not visited.
  void finish() const {
    const std::vector<std::string_view> names(known_.begin(), known_.end());
    object_.allow_only(names);
  }

  // The object that is read.
  const JsonField& field() const { return object_; }

 private:
  JsonField object_;
  std::vector<std::string> known_;
};

// True when a visitor's argument `fields` is a FieldReader (kReads<decltype(fields)>), for the few
// fields that differ between reading and writing.
template <typename Fields>
inline constexpr bool kReads = std::is_same_v<std::remove_cvref_t<Fields>, FieldReader>;

}  // namespace prehend
