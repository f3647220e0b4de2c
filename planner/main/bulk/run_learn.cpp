#include <iostream>

#include "planner/bulk/train/data_sets.h"
#include "planner/bulk/train/train_order.h"
#include "planner/main/bulk/bulk_commands.h"
#include "planner/main/other_programs.h"
#include "planner/main/shared_options.h"
#include "planner/plan/learn/tree_model_file.h"
#include "planner/results/datasets/acronym_file.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

// Arguments of `learn`.
struct LearnCommand {
  std::vector<std::filesystem::path> sets;  // data sets, and folders with such files
  std::filesystem::path model;              // file to write
  bool any_hand = false;                    // it may be used for hands that it was not trained on
  std::uint64_t seed = 1;
};

void declare(CLI::App& command, LearnCommand& options) {
  add_examples(command, {"learn sets -o model.json"});
  command.add_option("sets", options.sets, "data sets (.h5), or folders with such files")
      ->required();
  command.add_option("-o,--out", options.model, "model to write (docs/how-to/learning.md)")
      ->required();
  command.add_flag("--any-hand", options.any_hand,
                   "the model may be used for hands that it was not trained on");
  command.add_option("--seed", options.seed, "of the training")->capture_default_str();
}

int run_learn(const LearnCommand& command, Interrupts& interrupts) {
  require_training();
  const std::filesystem::path folder = std::filesystem::absolute(command.model).parent_path();
  require_writable(folder);
  const std::vector<std::filesystem::path> files = data_set_files(command.sets);
  TrainOptions options;
  options.any_hand = command.any_hand;
  options.boost.seed = command.seed;
  OrderTraining training(options);
  for (const std::filesystem::path& file : files) {
    try {
      training.add(read_acronym(file));
    } catch (const InputError& error) {
      throw error.in_file(file.string());
    }
  }
  const TreeModel model = training.train();
  make_folder(folder);
  interrupts.write(command.model, tree_model_json(model));
  std::cout << "learnt from " << model.trials << " trials of " << model.objects << " objects and "
            << model.hands.size() << " hands" << (model.any_hand ? ", for any hand" : "")
            << "\nwrote " << command.model.string() << "\n";
  return 0;
}

}  // namespace

void add_learn(CLI::App& app, CommandRequest& request) {
  add_command(app, request, kLearn.name, kLearn.summary, declare, run_learn);
}

}  // namespace prehend
