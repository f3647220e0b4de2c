// Every setting of a struct of options, by name: what a file records of a run.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

namespace prehend {

// Beside each struct of options whose values the result depends on stands
//
//   template <SettingsOf<SomeOptions> Options, typename Visit>
//   void for_each_setting(Options& options, const Visit& visit) {
//     auto& [angle, steps, inner] = options;   // does not compile while a field is missing
//     visit("angle", angle);
//     visit("steps", steps);
//     visit("inner", inner);                   // has settings of its own: visit_settings goes on
//   }
//
// with all its fields, but for seeds, which derive from the seed of the run (run_seed.h).
template <typename T, typename Options>
concept SettingsOf = std::same_as<std::remove_const_t<T>, Options>;

namespace detail {
struct AnySetting {
  void operator()(std::string_view, auto&) const {}
};
}  // namespace detail

template <typename T>
concept HasSettings = requires(T& options) {
  for_each_setting(options, detail::AnySetting{});
};

// Calls leaf(name, value) for every value in `options` and in the options inside it. Names of inner
// values are OUTER_INNER, or just INNER where the outer one visits them with an empty name.
template <HasSettings Options, typename Leaf>
void visit_settings(Options& options, const Leaf& leaf, const std::string& prefix = "") {
  for_each_setting(options, [&](std::string_view name, auto& value) {
    const std::string whole = prefix + std::string(name);
    if constexpr (HasSettings<std::remove_reference_t<decltype(value)>>) {
      visit_settings(value, leaf, name.empty() ? prefix : whole + "_");
    } else {
      leaf(whole, value);
    }
  });
}

}  // namespace prehend
