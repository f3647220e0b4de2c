#include "planner/bulk/run_batch.h"

#include <iostream>

#include "planner/bulk/cluster/submit_job.h"
#include "planner/main/batch_bar.h"
#include "planner/main/batch_options.h"
#include "planner/main/requested_batch.h"
#include "sim/base/formatted.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

RunContext context_of(const BatchCommand& command, Interrupts& interrupts) {
  RunContext context;
  context.threads = command.common.threads;
  context.cancellation = interrupts.cancellation();
  context.deadline = command.common.deadline;
  return context;
}

void say_failed(const FailedPart& part) {
  std::cerr << "failed: " << on_one_line(part.name) << ": " << on_one_line(part.reason) << "\n";
}

std::string parts_text(const BatchCount& count) {
  return formatted("%zu of %zu parts have a result, %zu failed, %zu are open", count.finished,
                   count.parts, count.failed, count.open());
}

}  // namespace

int run_batch(const BatchCommand& command, Interrupts& interrupts) {
  BatchRunOptions options;
  options.shard = read_shard(command.shard);
  options.retry = command.retry;
  const AskedBatch asked(command.file, command.common.out);
  require_writable(asked.folder.path());
  interrupts.cancel_first();
  BatchBar bar(command.common.progress);
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
  std::cerr << "prehend: " << interrupts.reason() << ", the same command goes on\n";
  return interrupts.exit_status();
}

int run_batch_merge(const BatchCommand& command, Interrupts& interrupts) {
  const AskedBatch asked(command.file, command.common.out);
  require_writable(asked.folder.path());
  interrupts.cancel_first();
  BatchBar bar(command.common.progress);
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
  const AskedBatch asked(command.file, command.common.out);
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

}  // namespace prehend
