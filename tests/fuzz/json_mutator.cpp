#include "tests/fuzz/json_mutator.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/json/json_depth.h"
#include "sim/base/random.h"

namespace prehend::fuzz {
namespace {

using Json = nlohmann::json;

// Values that readers may not expect.
Json extreme_value(Random& random) {
  static const std::vector<Json> values{nullptr,
                                        true,
                                        false,
                                        Json::array(),
                                        Json::object(),
                                        "",
                                        "x",
                                        std::string(300, 'a'),
                                        "\n\x1b",
                                        0,
                                        1,
                                        -1,
                                        2,
                                        3,
                                        0.5,
                                        -0.0,
                                        1e-320,
                                        1e-160,
                                        1e-9,
                                        1e9,
                                        1e30,
                                        1e155,
                                        1e300,
                                        -1e308,
                                        255,
                                        65536,
                                        2147483647,
                                        -2147483648LL,
                                        4294967296LL,
                                        9223372036854775807LL,
                                        18446744073709551615ULL,
                                        Json::array({0, 0, 0}),
                                        Json::array({1, 0, 0}),
                                        Json::array({1e200, 1e200, 1e200}),
                                        Json::array({1e-200, 0, 0}),
                                        Json::array({0, 0, 0, 0})};
  return values[random.index(values.size())];
}

// All values of a document, the outermost first, and the names of all its fields.
struct Parts {
  std::vector<Json*> values;
  std::vector<std::string> names;
};

void collect(Json& value, Parts& parts) {
  parts.values.push_back(&value);
  if (value.is_object()) {
    for (const auto& [name, unused] : value.items()) parts.names.push_back(name);
  }
  if (!value.is_structured()) return;
  for (Json& inner : value) collect(inner, parts);
}

Parts parts_of(Json& document) {
  Parts parts;
  collect(document, parts);
  return parts;
}

template <typename T>
T& any_of(Random& random, std::vector<T>& values) {
  return values[random.index(values.size())];
}

Json::iterator any_entry(Random& random, Json& container) {
  return std::next(container.begin(), static_cast<std::ptrdiff_t>(random.index(container.size())));
}

Json nudged(Random& random, const Json& number) {
  const double value = number.get<double>();
  const std::array<double, 8> others{
      -value,      value + 1.0, value - 1.0,  value * 2.0,
      value / 2.0, value * 1e3, value * 1e-3, value * std::pow(10.0, random.integer(-300, 300))};
  const double other = others[random.index(others.size())];
  // Whole numbers mostly stay whole: indices and counts.
  if (number.is_number_integer() && std::abs(other) < 1e15 && random.index(4) != 0) {
    return static_cast<std::int64_t>(other);
  }
  return std::isfinite(other) ? Json(other) : Json(1e308);
}

// One change of the document at a random place. `other` is what parts are taken from.
class Change {
 public:
  Change(Random& random, Json& document, Json& other, const ChangeText& change)
      : random_(random), parts_(parts_of(document)), others_(parts_of(other)), change_(change) {}

  void run() {
    Json& value = *any_of(random_, parts_.values);
    switch (random_.index(6)) {
      case 0:
        value = extreme_value(random_);
        break;
      case 1:
        value = Json(*any_of(random_, random_.index(2) == 0 ? parts_.values : others_.values));
        break;
      default:
        change_inside(value);
    }
  }

 private:
  void change_inside(Json& value) {
    if (value.is_number()) {
      value = nudged(random_, value);
    } else if (value.is_string()) {
      value = change_(value.get<std::string>());
    } else if (value.is_structured() && !value.empty()) {
      change_container(value);
    } else {
      value = extreme_value(random_);
    }
  }

  void change_container(Json& container) {
    const auto entry = any_entry(random_, container);
    switch (random_.index(4)) {
      case 0:
        container.erase(entry);
        break;
      case 1:
        repeat(container, Json(*entry));
        break;
      case 2:
        std::swap(*entry, *any_entry(random_, container));
        break;
      default:
        rename(container, entry);
    }
  }

  // A name of the file, or an entry of its own name with some change.
  std::string any_name() {
    std::vector<std::string>& names = random_.index(2) == 0 ? parts_.names : others_.names;
    if (names.empty()) return "x";
    std::string name = any_of(random_, names);
    return random_.index(4) == 0 ? change_(name) : name;
  }

  void repeat(Json& container, const Json& copy) {
    if (container.is_array()) {
      const std::size_t times = random_.index(8) == 0 ? 1 + random_.index(64) : 1;
      for (std::size_t i = 0; i < times; ++i) container.push_back(copy);
    } else {
      container[any_name()] = copy;
    }
  }

  void rename(Json& container, const Json::iterator& entry) {
    if (container.is_array()) {
      *entry = extreme_value(random_);
      return;
    }
    Json moved = std::move(*entry);
    container.erase(entry);
    container[any_name()] = std::move(moved);
  }

  Random& random_;
  Parts parts_;
  Parts others_;
  const ChangeText& change_;
};

Json parsed(const std::string& text) {
  if (json_depth(text) > kDeepestJson) return Json(Json::value_t::discarded);
  return Json::parse(text, nullptr, false);
}

// What is not UTF-8 after a change of a string becomes U+FFFD.
std::string dumped(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

constexpr std::size_t kGlbHeader = 12;
constexpr std::size_t kChunkHeader = 8;

std::uint32_t glb_word(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

void set_glb_word(std::string& bytes, std::size_t at, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  std::memcpy(bytes.data() + at, &word, sizeof(word));
}

}  // namespace

std::optional<std::string> mutated_json(const std::string& text, const std::string& other,
                                        std::uint32_t seed, const ChangeText& change) {
  Json document = parsed(text);
  if (document.is_discarded()) return std::nullopt;
  Json source = parsed(other);
  if (source.is_discarded()) source = document;
  Random random(seed);
  for (std::size_t left = 1 + random.index(4); left > 0; --left) {
    Change(random, document, source, change).run();
  }
  return dumped(document);
}

std::optional<std::string> mutated_glb(const std::string& bytes, std::uint32_t seed,
                                       const ChangeText& change) {
  const std::size_t begin = kGlbHeader + kChunkHeader;
  if (bytes.size() < begin) return std::nullopt;
  const std::size_t length = glb_word(bytes, kGlbHeader);
  if (length > bytes.size() - begin) return std::nullopt;
  auto json = mutated_json(bytes.substr(begin, length), "", seed, change);
  if (!json) return std::nullopt;
  json->resize((json->size() + 3) / 4 * 4, ' ');
  std::string result = bytes.substr(0, begin) + *json + bytes.substr(begin + length);
  set_glb_word(result, 8, result.size());
  set_glb_word(result, kGlbHeader, json->size());
  return result;
}

}  // namespace prehend::fuzz
