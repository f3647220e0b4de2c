// The fields of an object in a JSON file, named once for both directions: a function template that
// visits them writes the object when it is given a FieldWriter, and reads it when given a
// FieldReader. What is written and what is read cannot drift apart, and the reader knows every name
// that is allowed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/json/json_field.h"
#include "sim/json/json_pose.h"

namespace prehend {

// A value as JSON and back. Reading throws InputError that names file and field.
inline nlohmann::ordered_json value_to_json(const Vector3& value) { return vector_to_json(value); }
inline nlohmann::ordered_json value_to_json(const Pose& value) { return pose_to_json(value); }
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
template <typename T>
void read_value(const JsonField& field, std::optional<T>& value) {
  read_value(field, value.emplace());
}
template <typename T>
void read_value(const JsonField& field, std::vector<T>& values) {
  values.clear();
  for (const JsonField& item : field.items()) read_value(item, values.emplace_back());
}

// The names of the values of an enum, or of the entries of a list (then T is int): the first of
// each pair is what the file says.
template <typename T>
using ValueNames = std::vector<std::pair<std::string, T>>;

// `name(value)` for each of the values of an enum.
template <typename Values, typename Name>
auto value_names(const Values& values, const Name& name) {
  ValueNames<typename Values::value_type> names;
  for (const auto& value : values) names.emplace_back(std::string(name(value)), value);
  return names;
}

// Writes the fields in the order in which they are visited.
class FieldWriter {
 public:
  template <typename T>
  void operator()(std::string_view name, const T& value) {
    json_[std::string(name)] = value_to_json(value);
  }
  template <typename T>
  void operator()(std::string_view name, const std::optional<T>& value) {
    if (value) (*this)(name, *value);
  }
  void needs(std::string_view /*name*/) {}
  // A value that has a name.
  template <typename T>
  void named(std::string_view name, const T& value, const ValueNames<T>& names) {
    for (const auto& [word, meaning] : names) {
      if (meaning == value) json_[std::string(name)] = word;
    }
  }
  // An object inside this one; `visit(fields)` names its fields.
  template <typename Visit>
  void object(std::string_view name, const Visit& visit) {
    FieldWriter inner;
    visit(inner);
    json_[std::string(name)] = std::move(inner).json();
  }
  // A list of objects; `visit(fields, value)` names the fields of one.
  template <typename T, typename Visit>
  void objects(std::string_view name, const std::vector<T>& values, const Visit& visit) {
    json_[std::string(name)] = nlohmann::ordered_json::array();
    for (const T& value : values) {
      FieldWriter inner;
      visit(inner, value);
      json_[std::string(name)].push_back(std::move(inner).json());
    }
  }
  // Written for whoever reads the file, and not read back: it follows from other fields or from the
  // scene. `make()` gives its JSON.
  template <typename Make>
  void derived(std::string_view name, const Make& make) {
    json_[std::string(name)] = make();
  }
  void require(std::string_view /*name*/, bool /*fits*/, const char* /*what*/) {}

  nlohmann::ordered_json json() && { return std::move(json_); }

 private:
  nlohmann::ordered_json json_ = nlohmann::ordered_json::object();
};

// Reads the fields that are there and leaves the values of others as they are. Every function
// throws InputError that names file and field.
class FieldReader {
 public:
  explicit FieldReader(const JsonField& object) : object_(object) {}

  // True where the field is there, and then it may be.
  bool knows(std::string_view name) {
    known_.emplace_back(name);
    return object_.has(name);
  }

  template <typename T>
  void operator()(std::string_view name, T& value) {
    if (knows(name)) read_value(object_[name], value);
  }
  // Complains where the field is missing.
  void needs(std::string_view name) { (void)object_[name]; }
  template <typename T>
  void named(std::string_view name, T& value, const ValueNames<T>& names) {
    if (!knows(name)) return;
    const std::string word = object_[name].text();
    std::string known;
    for (const auto& [candidate, meaning] : names) {
      if (candidate == word) {
        value = meaning;
        return;
      }
      known += (known.empty() ? "" : ", ") + candidate;
    }
    object_[name].fail("must be one of " + known);
  }
  template <typename Visit>
  void object(std::string_view name, const Visit& visit) {
    if (!knows(name)) return;
    FieldReader inner(object_[name]);
    visit(inner);
    inner.finish();
  }
  template <typename T, typename Visit>
  void objects(std::string_view name, std::vector<T>& values, const Visit& visit) {
    if (!knows(name)) return;
    values.clear();
    for (const JsonField& item : object_[name].items()) {
      FieldReader inner(item);
      visit(inner, values.emplace_back());
      inner.finish();
    }
  }
  template <typename Make>
  void derived(std::string_view name, const Make& /*make*/) {
    knows(name);
  }
  // Complains of a field that was read where it does not fit.
  void require(std::string_view name, bool fits, const char* what) {
    if (!fits) object_[name].fail(what);
  }

  // Call when all fields have been visited: others are complained of.
  void finish() const {
    const std::vector<std::string_view> names(known_.begin(), known_.end());
    object_.allow_only(names);
  }

  const JsonField& field() const { return object_; }

 private:
  JsonField object_;
  std::vector<std::string> known_;
};

// Whether a visitor's fields (`kReads<decltype(fields)>`) are being read: for the few that are not
// the same in both directions.
template <typename Fields>
inline constexpr bool kReads = std::is_same_v<std::remove_cvref_t<Fields>, FieldReader>;

}  // namespace prehend
