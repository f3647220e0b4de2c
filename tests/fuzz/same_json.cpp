#include "tests/fuzz/same_json.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace prehend::fuzz {
namespace {

using Json = nlohmann::json;

constexpr double kRounding = 1e-9;

bool is_numbers(const Json& list) {
  return list.is_array() &&
         std::all_of(list.begin(), list.end(), [](const Json& item) { return item.is_number(); });
}

// Whether a = sign * b.
bool same_numbers(const Json& a, const Json& b, double sign) {
  double largest = 1.0;
  for (const Json& number : a) largest = std::max(largest, std::abs(number.get<double>()));
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Json& x, const Json& y) {
    return std::abs(x.get<double>() - sign * y.get<double>()) <= kRounding * largest;
  });
}

bool same_value(const std::string& name, const Json& a, const Json& b) {
  if (a.is_number() && b.is_number()) return same_numbers(Json::array({a}), Json::array({b}), 1.0);
  if (is_numbers(a) && is_numbers(b)) {
    return same_numbers(a, b, 1.0) || (name == "quaternion_wxyz" && same_numbers(a, b, -1.0));
  }
  if (a.type() != b.type() || a.size() != b.size()) return false;
  if (a.is_array()) {
    return std::equal(a.begin(), a.end(), b.begin(),
                      [](const Json& x, const Json& y) { return same_value("", x, y); });
  }
  if (!a.is_object()) return a == b;
  const auto entries = a.items();
  return std::all_of(entries.begin(), entries.end(), [&](const auto& entry) {
    return b.contains(entry.key()) && same_value(entry.key(), entry.value(), b[entry.key()]);
  });
}

}  // namespace

bool same_but_rounded(const std::string& a, const std::string& b) {
  return a == b || same_value("", Json::parse(a), Json::parse(b));
}

}  // namespace prehend::fuzz
