#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <span>
#include <system_error>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "benchmarks/report/names.h"
#include "benchmarks/suite/parts.h"
#include "benchmarks/suite/record.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"

namespace prehend::bench {
namespace {

// A run of `prehend plan`, and what its entries are called.
struct PlanRun {
  const char* series;
  const char* arguments;
};

// Words without anything that a shell would change.
constexpr std::array kRuns = {
    PlanRun{"mug, draft", "mug --accuracy draft"},
    PlanRun{"mug", "mug"},
    PlanRun{"hammer", "hammer"},
    PlanRun{"mug, without report", "mug --no-report"},
    PlanRun{"mug, uncertainty", "mug --uncertainty --rank success"},
    PlanRun{"mug_on_table", "mug_on_table"},
    PlanRun{"mug_on_table, shaken", "mug_on_table --shake simready"},
    PlanRun{"panda_on_table, paths", "panda_on_table --path --top 3"},
};

// A folder of its own, which goes when this does.
class RunFolder {
 public:
  RunFolder() {
    std::string name = std::filesystem::temp_directory_path() / "prehend-bench-XXXXXX";
    if (mkdtemp(name.data()) == nullptr) throw InputError("no folder for the files of a run");
    path_ = name;
  }
  ~RunFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// The times of the stages of one run, in `folder` [ms], and that of all of them.
std::map<std::string, double> times_of(const PlanRun& run, const std::filesystem::path& folder) {
  const std::string command = std::string(PREHEND_PROGRAM) + " plan " + run.arguments +
                              " --threads 1 --out '" + folder.string() + "' > /dev/null";
  if (std::system(command.c_str()) != 0) {
    throw InputError("prehend plan " + std::string(run.arguments) + " failed");
  }
  const auto timings = nlohmann::json::parse(read_file(folder / "timings.json"));
  std::map<std::string, double> times;
  for (const auto& stage : timings.at("stages")) {
    times[kTimeOf + stage.at("name").get<std::string>()] = 1e3 * stage.at("seconds").get<double>();
  }
  times[kRun] = 1e3 * timings.at("total").get<double>();
  return times;
}

}  // namespace

void measure_plans(const Sizes& sizes, std::vector<Entry>& entries) {
  Record record(kPlans, entries);
  const RunFolder folder;
  for (const PlanRun& run : std::span(kRuns).first(static_cast<std::size_t>(sizes.plans))) {
    record.say(run.series);
    std::map<std::string, std::vector<double>> times;
    for (int i = 0; i < sizes.plan_runs; ++i) {
      for (const auto& [group, milliseconds] : times_of(run, folder.path())) {
        times[group].push_back(milliseconds);
      }
    }
    for (const auto& [group, values] : times) record.add(group, run.series, "ms", values);
  }
}

}  // namespace prehend::bench
