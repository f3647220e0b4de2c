// docs/reference/settings.md is the table of all settings, as they are declared.
#include <cstdlib>
#include <sstream>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "planner/plan/plan_options.h"
#include "sim/base/formatted.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

constexpr const char* kHead =
    R"(# Settings

For: changing one tolerance or limit in an [accuracy file](accuracy-file.md), in C++ (`PlanOptions`) or
in Python. `grasps.json` lists them under `settings`, by the same names. The program's tests make this
table from the declarations of the settings: `PREHEND_WRITE_SETTINGS=1 ctest -R SettingsTable` writes it.
)";

template <typename Value>
std::string default_text(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_enum_v<Value>) {
    return std::string(name_of(value));
  } else {
    return formatted("%.6g", static_cast<double>(value));
  }
}

template <typename Value>
std::string range_text(const Setting& setting) {
  if constexpr (std::is_enum_v<Value>) {
    return joined(enum_names(Value{}), ", ");
  } else {
    return setting.range.interval();
  }
}

// The listed values of a struct, then those of the structs in it.
template <HasSettings Options>
void write_section(std::ostream& text, const Options& options, const std::string& prefix,
                   std::string_view meaning) {
  std::ostringstream rows;
  const auto row = [&](const Setting& setting, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (!HasSettings<Value> && !detail::kIsOptional<Value>) {
      if (!setting.listed) return;
      rows << "|`" << prefix << setting.name.in_files << "`|" << default_text(value) << "|"
           << range_text<Value>(setting) << "|" << setting.unit << "|" << setting.meaning << "|\n";
    }
  };
  for_each_setting(options, SettingVisitor(row));
  if (!rows.str().empty()) {
    text << "\n### " << Options::kAbout.name << (prefix.empty() ? "" : ": `" + prefix + "...`")
         << "\n\n"
         << meaning << " " << Options::kAbout.meaning
         << "\n\n|setting|standard|range|unit|meaning|\n|---|---|---|---|---|\n"
         << rows.str();
  }
  const auto nested = [&](const Setting& setting, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (HasSettings<Value>) {
      const std::string name(setting.name.in_files);
      write_section(text, value, name.empty() ? prefix : prefix + name + "_", setting.meaning);
    }
  };
  for_each_setting(options, SettingVisitor(nested));
}

std::string settings_table() {
  std::ostringstream text;
  text << kHead << "\n## Of a plan\n";
  const PlanOptions options;
  write_section(text, options, "", "");
  text << "\n## Of paths\n\nIn the object `paths`, for `--path`.\n";
  write_section(text, GraspPathOptions{}, "", "");
  return text.str();
}

TEST(SettingsTable, IsTheOneInTheDocuments) {
  const std::string file = std::string(PREHEND_SOURCE_DIR) + "/docs/reference/settings.md";
  if (std::getenv("PREHEND_WRITE_SETTINGS") != nullptr) write_file(file, settings_table());
  EXPECT_EQ(read_file(file), settings_table())
      << "Write it anew with PREHEND_WRITE_SETTINGS=1 ctest -R SettingsTable";
}

}  // namespace
}  // namespace prehend
