// docs/reference/settings.md is the table of all settings, as they are declared.
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "planner/plan/plan_options.h"
#include "sim/base/formatted.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"
#include "sim/base/output_file.h"
#include "sim/base/visit_settings.h"
#include "sim/shape/cloud/reconstruct.h"

namespace prehend {
namespace {

constexpr const char* kHead =
    R"(# Settings

For: changing one tolerance or limit in an [accuracy file](accuracy-file.md), in C++ (`PlanOptions`) or
in Python. The tests make this page: `PREHEND_WRITE_SETTINGS=1 ctest -R SettingsTable` writes it anew.

```json
{"trials": 300, "cone_edges": 12}
```
)";

template <typename Value>
std::string default_text(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_enum_v<Value>) {
    return std::string(name_of(value));
  } else if constexpr (std::is_same_v<Value, Vector3>) {
    return formatted("[%g, %g, %g]", value.x(), value.y(), value.z());
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

// The listed values of a struct, then those of the structs in it. A struct that was there before
// has the same settings again, under other names.
class Table {
 public:
  template <HasSettings Options>
  void add(const Options& options, const std::string& prefix = "") {
    const std::string name(Options::kAbout.name);
    const std::string rows = rows_of(options, prefix);
    if (!rows.empty()) text_ << "\n### " << name << "\n\n" << Options::kAbout.meaning << "\n\n";
    if (const auto [before, is_new] = prefixes_.try_emplace(name, prefix); !is_new) {
      text_ << "`" << prefix << "...` as `" << before->second << "...` above.\n";
      return;
    }
    if (!rows.empty()) {
      text_ << "|setting|standard|range|unit|meaning|\n|---|---|---|---|---|\n" << rows;
    }
    const auto nested = [&](const Setting& setting, const auto& value) {
      if constexpr (HasSettings<std::remove_cvref_t<decltype(value)>>) {
        const std::string inner(setting.name.in_files);
        add(value, inner.empty() ? prefix : prefix + inner + "_");
      }
    };
    for_each_setting(options, SettingVisitor(nested));
  }

  void add(const char* text) { text_ << text; }
  std::string text() const { return text_.str(); }

 private:
  template <HasSettings Options>
  static std::string rows_of(const Options& options, const std::string& prefix) {
    std::ostringstream rows;
    const auto row = [&](const Setting& setting, const auto& value) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if constexpr (!HasSettings<Value> && !detail::kIsOptional<Value>) {
        if (!setting.listed) return;
        rows << "|`" << prefix << setting.name.in_files << "`|" << default_text(value) << "|"
             << range_text<Value>(setting) << "|" << setting.unit << "|" << setting.meaning
             << "|\n";
      }
    };
    for_each_setting(options, SettingVisitor(row));
    return rows.str();
  }

  std::ostringstream text_;
  std::map<std::string, std::string> prefixes_;  // of each struct, where it was first
};

std::string settings_table() {
  Table table;
  table.add(kHead);
  table.add(PlanOptions{});
  table.add("\n## Paths\n\nIn the object `paths`, for `--path`.\n");
  table.add(GraspPathOptions{});
  table.add("\n## Approach\n\nIn the object `approach`, for `--approach`.\n");
  table.add(ApproachLimit{});
  table.add("\n## Views of depth cameras\n\nIn files of [views](../how-to/camera.md).\n");
  table.add(ReconstructOptions{});
  return table.text();
}

TEST(SettingsTable, IsTheOneInTheDocuments) {
  const std::string file = std::string(PREHEND_SOURCE_DIR) + "/docs/reference/settings.md";
  if (std::getenv("PREHEND_WRITE_SETTINGS") != nullptr) write_file(file, settings_table());
  EXPECT_EQ(read_file(file), settings_table())
      << "Write it anew with PREHEND_WRITE_SETTINGS=1 ctest -R SettingsTable";
}

}  // namespace
}  // namespace prehend
