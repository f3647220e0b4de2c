#include "planner/main/batch_options.h"

#include "planner/main/shared_options.h"

namespace prehend {
namespace {

// Returns the option of the batch file.
CLI::Option* add_folder_options(CLI::App& command, BatchCommand& batch) {
  CLI::Option* file = command.add_option("file", batch.file, "batch file (docs/batch-file.md)");
  file->required();
  command.add_option("-o,--out", batch.common.out,
                     "folder of the results, out/NAME where it is not stated");
  command.add_option("--threads", batch.common.threads, "number of threads, 0: all processors")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_flag("--progress", batch.common.progress,
                   "say on stderr, line by line, how far it is");
  return file;
}

}  // namespace

CLI::App& add_batch(CLI::App& app, BatchCommand& command, Limits& limits,
                    const std::function<void(std::function<int(Interrupts&)>)>& choose) {
  command.common.out.clear();
  CLI::App& batch =
      *app.add_subcommand("batch", "plan many objects with many hands, on one machine or many");
  batch.require_subcommand(0, 1);
  // Required, but where a command below it has a batch file of its own.
  add_folder_options(batch, command)->required(false);
  batch.add_option("--shard", command.shard, "I/N: do part I of N of it")->capture_default_str();
  batch.add_flag("--retry", command.retry, "try parts again that failed");
  add_limits(batch, limits);
  batch.callback([&batch, &command, choose] {
    if (!batch.get_subcommands().empty()) return;
    if (command.file.empty()) throw CLI::RequiredError("a batch file");
    choose([&command](Interrupts& interrupts) { return run_batch(command, interrupts); });
  });

  CLI::App& merge = *batch.add_subcommand("merge", "make one data set of all results");
  add_folder_options(merge, command);
  merge
      .add_option("--formats", command.merge.formats,
                  "files of the data set, with commas: acronym, graspgen, csv")
      ->delimiter(',')
      ->check(CLI::IsMember(std::vector<std::string>(kBatchFormats.begin(), kBatchFormats.end())));
  merge.add_option("--pictures", command.merge.pictures, "random grasps to draw")
      ->check(CLI::Range(0, 99))
      ->capture_default_str();
  merge.add_flag("--partial", command.merge.partial, "also while parts are open");
  add_limits(merge, limits);
  merge.callback([&command, choose] {
    choose([&command](Interrupts& interrupts) { return run_batch_merge(command, interrupts); });
  });

  CLI::App& status = *batch.add_subcommand("status", "say how far it is, and what failed");
  add_folder_options(status, command);
  status.callback([&command, choose] {
    choose([&command](Interrupts& interrupts) { return run_batch_status(command, interrupts); });
  });
  return batch;
}

}  // namespace prehend
