#include "planner/bulk/merge_batch.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

#include "planner/bulk/batch_pictures.h"
#include "planner/bulk/batch_summary.h"
#include "planner/bulk/part_worker.h"
#include "planner/results/datasets/acronym_file.h"
#include "planner/results/datasets/grasp_table.h"
#include "planner/results/datasets/graspgen_file.h"
#include "sim/base/csv_row.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"
#include "sim/base/parallel/parallel.h"
#include "sim/base/pool.h"

// Parts are read in groups, in parallel, and what is made of them is written in their order: the
// same bytes on any number of threads, in the memory of one group.
namespace prehend {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kGroup = 32;

// What is made of one part while others are read.
struct MergedPart {
  PartState state = PartState::open;
  std::string name;
  std::string key;
  std::string reason;
  std::string rows;
  std::string graspgen;
  BatchTally tally;
  GraspLottery stable{0};
  GraspLottery others{0};
};

template <typename Values, typename Name>
std::string axis_text(const char* what, const Values& values, const Name& name) {
  constexpr std::size_t kMostNamed = 20;
  std::string words = formatted("%s: %zu", what, values.size());
  for (std::size_t i = 0; i < std::min(values.size(), kMostNamed); ++i) {
    words += (i == 0 ? " (" : ", ") + name(values[i]);
  }
  return words + (values.size() > kMostNamed ? ", ...)" : ")");
}

std::vector<std::string> axes_of(const Batch& batch) {
  const auto number = [](double value) { return formatted("%.6g", value); };
  const auto named = [](const auto& value) { return value.name; };
  return {axis_text("objects", batch.objects, named),
          axis_text("scales", batch.scales, number),
          axis_text("hands", batch.hands, hand_name),
          axis_text("scenes", batch.scenes, named),
          axis_text("friction coefficients", batch.frictions,
                    [&](const std::optional<double>& friction) {
                      return friction ? number(*friction) : std::string("of the materials");
                    }),
          axis_text("settings", batch.settings, named),
          axis_text("seeds", batch.seeds, [](std::uint64_t seed) { return std::to_string(seed); })};
}

class Merge {
 public:
  Merge(const Batch& batch, const BatchInputs& inputs, const BatchFolder& folder,
        const MergeOptions& options, const RunContext& context,
        const std::function<void(const BatchCount&)>& progress)
      : batch_(batch),
        inputs_(inputs),
        folder_(folder),
        options_(options),
        context_(context),
        progress_(progress),
        stable_(options.pictures - options.pictures / 4),
        others_(options.pictures / 4) {
    count_.parts = part_count(batch);
  }

  BatchCount run() {
    if (!options_.partial && !is_complete()) return count_;
    folder_.create();
    write_folder(folder_.path() / "merged", [&](const fs::path& target) {
      target_ = target;
      write_all();
    });
    return count_;
  }

 private:
  void write_all() {
    write_file(target_ / "failures.csv", [&](std::ostream& failures) {
      failures << "part,reason\n";
      if (!wants("csv")) {
        write_parts(nullptr, failures);
      } else {
        write_file(target_ / "grasps.csv", [&](std::ostream& table) {
          write_grasp_table_header(table);
          write_parts(&table, failures);
        });
      }
    });
    summary_.tally.count_shares();
    write_pictures();
    write_file(target_ / "CARD.md", data_card(summarized()));
    write_file(target_ / "index.html", batch_page(summarized()));
  }

  bool wants(std::string_view format) const {
    return std::find(options_.formats.begin(), options_.formats.end(), format) !=
           options_.formats.end();
  }

  bool is_complete() {
    const BatchCount status = batch_status(batch_, inputs_, folder_, {}, context_);
    if (status.open() == 0) return true;
    count_ = status;
    return false;
  }

  void write_parts(std::ostream* table, std::ostream& failures) {
    for (std::size_t begin = 0; begin < count_.parts; begin += kGroup) {
      const std::size_t size = std::min(kGroup, count_.parts - begin);
      std::vector<MergedPart> group(size);
      for_each_in_parallel(size, context_.threads, [&](std::size_t i) {
        context_.cancellation.check();
        group[i] = read_part(begin + i);
      });
      for (const MergedPart& part : group) write_part(part, table, failures);
      if (progress_) progress_(count_);
    }
  }

  MergedPart read_part(std::size_t number) {
    const Pool<PartWorker>::Loan worker(workers_);
    const BatchPart part = part_at(batch_, number);
    MergedPart merged;
    merged.name = part_name(batch_, part);
    try {
      merged.key = worker->key(batch_, inputs_, part);
    } catch (const InputError& error) {
      merged.state = PartState::failed;
      merged.reason = error.what();
      return merged;
    }
    merged.state = folder_.state(merged.key);
    if (merged.state == PartState::failed) merged.reason = folder_.failure(merged.key);
    if (merged.state != PartState::finished) return merged;
    const GraspSet set = read_acronym(folder_.result_file(merged.key));
    if (wants("csv")) {
      std::ostringstream rows;
      write_grasp_table_rows(rows, merged.name, set);
      merged.rows = std::move(rows).str();
    }
    if (wants("graspgen")) merged.graspgen = graspgen_text(set);
    merged.tally.add(batch_.objects[part.object].name, set);
    merged.stable = GraspLottery(1);
    merged.stable.add(number, merged.key, set, true);
    merged.others = GraspLottery(1);
    merged.others.add(number, merged.key, set, false);
    return merged;
  }

  void write_part(const MergedPart& part, std::ostream* table, std::ostream& failures) {
    if (part.state == PartState::failed) {
      ++count_.failed;
      CsvRow row;
      row.text(part.name);
      row.text(part.reason);
      failures << row.line();
      if (summary_.failed.size() < kMostListed) summary_.failed.push_back({part.name, part.reason});
    }
    if (part.state != PartState::finished) return;
    ++count_.finished;
    count_.trials += part.tally.outcomes.all();
    if (table != nullptr) *table << part.rows;
    if (wants("graspgen")) {
      const fs::path file = target_ / "graspgen" / (part.name + ".json");
      make_folder(file.parent_path());
      write_file(file, part.graspgen);
    }
    if (wants("acronym")) link_result(part);
    summary_.tally.add(part.tally);
    stable_.add(part.stable);
    others_.add(part.others);
  }

  // A result takes no room twice where the file system has hard links.
  void link_result(const MergedPart& part) {
    const fs::path file = target_ / "acronym" / (part.name + ".h5");
    make_folder(file.parent_path());
    std::error_code error;
    fs::create_hard_link(folder_.result_file(part.key), file, error);
    if (error) fs::copy_file(folder_.result_file(part.key), file);
  }

  void write_pictures() {
    std::vector<ChosenGrasp> chosen = stable_.chosen();
    chosen.insert(chosen.end(), others_.chosen().begin(), others_.chosen().end());
    std::vector<BatchPicture> pictures(chosen.size());
    RunContext own = context_;
    own.threads = 1;
    own.progress = {};
    for_each_in_parallel(chosen.size(), context_.threads, [&](std::size_t i) {
      pictures[i] = batch_picture(batch_, inputs_, chosen[i], own);
    });
    if (!pictures.empty()) make_folder(target_ / "pictures");
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      write_png(target_ / "pictures" / formatted("%02zu.png", i + 1), pictures[i].image);
      summary_.pictures.push_back(pictures[i].title);
    }
  }

  const BatchSummary& summarized() {
    summary_.name = batch_.name;
    summary_.version = "prehend " PREHEND_VERSION;
    summary_.licence = batch_.licence;
    summary_.parts = count_.parts;
    summary_.open = count_.open();
    summary_.failed_parts = count_.failed;
    summary_.formats = options_.formats;
    summary_.axes = axes_of(batch_);
    summary_.settings.clear();
    BatchPart part;
    for (part.setting = 0; part.setting < batch_.settings.size(); ++part.setting) {
      summary_.settings.push_back(inputs_.settings_of(part));
    }
    return summary_;
  }

  const Batch& batch_;
  const BatchInputs& inputs_;
  const BatchFolder& folder_;
  const MergeOptions& options_;
  const RunContext& context_;
  const std::function<void(const BatchCount&)>& progress_;
  fs::path target_;  // a temporary folder
  Pool<PartWorker> workers_;
  BatchCount count_;
  BatchSummary summary_;
  GraspLottery stable_;
  GraspLottery others_;
};

}  // namespace

BatchCount merge_batch(const Batch& batch, const BatchInputs& inputs, const BatchFolder& folder,
                       const MergeOptions& options, const RunContext& context,
                       const std::function<void(const BatchCount&)>& progress) {
  return Merge(batch, inputs, folder, options, context, progress).run();
}

}  // namespace prehend
