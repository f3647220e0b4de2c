#include "planner/bulk/run_batch.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "planner/bulk/cluster/submit_job.h"
#include "planner/bulk/merge_batch.h"
#include "planner/main/bulk/batch_bar.h"
#include "planner/main/bulk/bulk_commands.h"
#include "planner/main/bulk/requested_batch.h"
#include "planner/main/other_programs.h"
#include "planner/main/shared_options.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

// Options of `batch` and of the commands below it that work on the same folder.
struct BatchCommand {
  std::filesystem::path file;  // batch file
  std::filesystem::path out;   // empty: out/NAME, of the batch
  std::string shard = "1/1";
  bool retry = false;  // parts that failed
  int threads = 0;     // 0: all processors
  bool progress = false;
  MergeOptions merge;
};

// Returns the option of the batch file.
CLI::Option* add_folder_options(CLI::App& command, BatchCommand& batch) {
  CLI::Option* file =
      command.add_option("file", batch.file, "batch file (docs/reference/batch-file.md)");
  file->required();
  command.add_option("-o,--out", batch.out,
                     "folder of the results, out/NAME where it is not stated");
  command.add_option("--threads", batch.threads, "number of threads, 0: all processors")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_flag("--progress", batch.progress, "say on stderr, line by line, how far it is");
  return file;
}

RunContext context_of(const BatchCommand& command, Interrupts& interrupts) {
  RunContext context;
  context.threads = command.threads;
  context.cancellation = interrupts.cancellation();
  context.deadline = interrupts.deadline();
  return context;
}

void say_failed(const FailedPart& part) {
  std::cerr << "failed: " << on_one_line(part.name) << ": " << on_one_line(part.reason) << "\n";
}

std::string parts_text(const BatchCount& count) {
  return formatted("%zu of %zu parts have a result, %zu failed, %zu are open", count.finished,
                   count.parts, count.failed, count.open());
}

int run_batch(const BatchCommand& command, Interrupts& interrupts) {
  BatchRunOptions options;
  options.shard = read_shard(command.shard);
  options.retry = command.retry;
  const AskedBatch asked(command.file, command.out);
  require_writable(asked.folder.path());
  interrupts.cancel_first();
  BatchBar bar(command.progress);
  const BatchListener listener{[&](const BatchCount& count) { bar.show(count); },
                               [&](const FailedPart& part) {
                                 bar.clear();
                                 say_failed(part);
                               }};
  const BatchCount count = run_batch(asked.batch, asked.inputs, asked.folder, options,
                                     context_of(command, interrupts), listener);
  bar.clear();
  const double seconds = bar.seconds();
  std::cout << parts_text(count)
            << formatted("; %zu in this run, %zu trials in %.1f s, %.0f trials/s\n", count.made,
                         count.trials, seconds, static_cast<double>(count.trials) / seconds);
  if (count.open() == 0) return 0;
  if (count.short_of_memory > 0 && !interrupts.cancellation().requested()) {
    std::cerr << "prehend: not enough memory for " << count.short_of_memory
              << " parts: allow more (--memory-limit), or use fewer threads (--threads), the same "
                 "command goes on\n";
    return 1;
  }
  std::cerr << "prehend: " << interrupts.reason() << ", the same command goes on\n";
  return interrupts.exit_status();
}

int run_batch_merge(const BatchCommand& command, Interrupts& interrupts) {
  const AskedBatch asked(command.file, command.out);
  require_writable(asked.folder.path());
  interrupts.cancel_first();
  BatchBar bar(command.progress);
  BatchCount count;
  try {
    count = merge_batch(asked.batch, asked.inputs, asked.folder, command.merge,
                        context_of(command, interrupts),
                        [&](const BatchCount& so_far) { bar.show(so_far); });
  } catch (const Cancelled&) {
    bar.clear();
    std::cerr << "prehend: " << interrupts.reason() << ", nothing is merged\n";
    return interrupts.exit_status();
  }
  bar.clear();
  std::cout << parts_text(count) << "\n";
  if (count.open() > 0 && !command.merge.partial) {
    std::cerr << "prehend: not merged while parts are open (--partial merges what there is)\n";
    return 1;
  }
  std::cout << formatted("merged %zu grasps, wrote ", count.trials)
            << (asked.folder.path() / "merged").string() << "\n";
  return 0;
}

int run_batch_status(const BatchCommand& command, Interrupts& interrupts) {
  const AskedBatch asked(command.file, command.out);
  const BatchCount count =
      batch_status(asked.batch, asked.inputs, asked.folder, {}, context_of(command, interrupts),
                   [](const FailedPart& part) {
                     std::cout << "failed: " << part.name << ": " << part.reason << "\n";
                   });
  std::cout << parts_text(count) << "\n";
  const auto job = cluster_status(std::filesystem::absolute(asked.folder.path()));
  if (job) std::cout << status_text(*job);
  return 0;
}

}  // namespace

// The commands below `batch` share its options, so that those which stand before their names count.
void add_batch(CLI::App& app, CommandRequest& request) {
  const auto options = std::make_shared<BatchCommand>();
  BatchCommand& command = *options;
  CLI::App& batch = *app.add_subcommand(kBatch.name, kBatch.summary);
  batch.require_subcommand(0, 1);
  add_examples(batch, {"batch batch.json --out out/batch", "batch batch.json --shard 1/4",
                       "batch status batch.json --out out/batch"});
  // Required, but where a command below it has a batch file of its own.
  add_folder_options(batch, command)->required(false);
  batch.add_option("--shard", command.shard, "I/N: do part I of N of it")->capture_default_str();
  batch.add_flag("--retry", command.retry, "try parts again that failed");
  add_limits(batch, request.limits);
  batch.callback([&batch, options, &request] {
    if (!batch.get_subcommands().empty()) return;
    if (options->file.empty()) throw CLI::RequiredError("a batch file");
    request.run = [options](Interrupts& interrupts) { return run_batch(*options, interrupts); };
  });

  CLI::App& merge = *batch.add_subcommand("merge", "make one data set of all results");
  add_examples(merge, {"batch merge batch.json --out out/batch --formats acronym,csv"});
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
  add_limits(merge, request.limits);
  merge.callback([options, &request] {
    request.run = [options](Interrupts& interrupts) {
      return run_batch_merge(*options, interrupts);
    };
  });

  CLI::App& status = *batch.add_subcommand("status", "say how far it is, and what failed");
  add_examples(status, {"batch status batch.json --out out/batch"});
  add_folder_options(status, command);
  status.callback([options, &request] {
    request.run = [options](Interrupts& interrupts) {
      return run_batch_status(*options, interrupts);
    };
  });
  add_cluster_commands(batch, request);
}

}  // namespace prehend
