// How many trials an order that was learnt saves: the table of docs/how-to/learning.md, and a model
// of the same trials.
//
//   learn_benchmark collect RUNS FIRST LAST TRIALS HANDS FOLDER...
//   learn_benchmark compare RUNS[,RUNS...] SEEDS TRIALS HANDS FIRST EVERY FOLDER...
//   learn_benchmark train RUNS[,RUNS...] MODEL
//
// Lists are written with commas. `collect` tries the first candidates of the sequence of each
// object of the folders and of the generator, without following the good ones, with each hand, and
// appends the trials to the file; of each object in the variants FIRST to LAST (learn_cases.h).
// `compare` searches every EVERYth object from number FIRST on, without a model and ordered by a
// model of other objects (three folds; objects of the same kind are in the same one): once of all
// hands in the file and once of the others only. It prints a line for each pair:
//
//   known|unknown OBJECT HAND SEED without TRIAL EPSILON ... with TRIAL EPSILON ...
//
// the trials that were better than all before them, and their epsilon. table.py makes the table.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/learn/learn_cases.h"
#include "benchmarks/learn/learn_file.h"
#include "planner/bulk/train/train_order.h"
#include "planner/plan/learn/tree_model_file.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"

namespace prehend::bench {
namespace {

constexpr int kFolds = 3;

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

std::vector<LearnRun> read_all(const std::string& files) {
  std::vector<LearnRun> runs;
  for (const std::string& file : split(files)) {
    for (LearnRun& run : read_runs(file)) runs.push_back(std::move(run));
  }
  return runs;
}

// Objects of one kind under one name: a model must not be tried on a mug when it knows mugs.
std::string kind_of(const std::string& object) {
  for (const char* kind : {"mug", "phone", "flask", "ylinder", "wine", "box", "ball", "bowl",
                           "marker", "bottle", "can"}) {
    if (object.find(kind) != std::string::npos) return kind;
  }
  return object;
}

int fold_of(const std::string& object) {
  unsigned sum = 7;
  for (const char c : kind_of(object)) sum = sum * 31U + static_cast<unsigned char>(c);
  return static_cast<int>(sum % kFolds);
}

// Whether a model learns from a run.
using Chosen = std::function<bool(const LearnRun& run)>;

std::shared_ptr<const TreeModel> model_of(const std::vector<LearnRun>& runs, const Chosen& chosen) {
  TrainOptions options;
  options.any_hand = true;
  OrderTraining training(options);
  for (const LearnRun& run : runs) {
    if (chosen(run)) training.add(run.set);
  }
  return std::make_shared<const TreeModel>(training.train());
}

void collect_run(const LearnObject& object, const std::string& hand, const LearnSearch& search,
                 std::ofstream& file) {
  const std::optional<LearnRun> run = run_learn_case(object, hand, search);
  if (!run) return;
  write_run(*run, file);
  std::fprintf(stderr, "%s %s %d %.4f\n", run->object.c_str(), run->hand.c_str(), search.variant,
               run->best.empty() ? 0.0 : run->best.back());
}

void collect(const std::vector<std::string>& words) {
  std::ofstream file(words.at(0), std::ios::app);
  const std::vector<LearnObject> objects = learn_objects({words.begin() + 5, words.end()});
  for (int variant = std::stoi(words.at(1)); variant <= std::stoi(words.at(2)); ++variant) {
    const LearnSearch search{.seed = static_cast<std::uint64_t>(variant),
                             .trials = std::stoi(words.at(3)),
                             .variant = variant,
                             .follow = false,
                             .learned = {},
                             .features = true,
                             .threads = 1};
    for (const LearnObject& object : objects) {
      for (const std::string& hand : split(words.at(4))) {
        collect_run(object, hand, search, file);
      }
    }
  }
}

void print_improvements(const char* what, const std::vector<double>& best) {
  std::printf(" %s", what);
  double before = 0.0;
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (best[i] > before) std::printf(" %d %.7f", static_cast<int>(i) + 1, best[i]);
    before = best[i];
  }
}

void print_comparison(const char* what, const LearnRun& base, const LearnRun& learned) {
  std::printf("%s %s %s %d", what, base.object.c_str(), base.hand.c_str(),
              static_cast<int>(base.seed));
  print_improvements("without", base.best);
  print_improvements("with", learned.best);
  std::printf("\n");
  std::fflush(stdout);
}

class Comparison {
 public:
  explicit Comparison(const std::vector<std::string>& words)
      : runs_(read_all(words.at(0))),
        seeds_(split(words.at(1))),
        trials_(std::stoi(words.at(2))),
        hands_(split(words.at(3))),
        first_(static_cast<std::size_t>(std::stoi(words.at(4)))),
        every_(static_cast<std::size_t>(std::stoi(words.at(5)))),
        objects_(learn_objects({words.begin() + 6, words.end()})) {}

  void run() {
    for (std::size_t o = first_; o < objects_.size(); o += every_) {
      for (const std::string& hand : hands_) {
        for (const std::string& seed : seeds_) {
          compare(objects_[o], hand, std::stoull(seed));
        }
      }
    }
  }

 private:
  void compare(const LearnObject& object, const std::string& hand, std::uint64_t seed) {
    LearnSearch search;
    search.seed = seed;
    search.trials = trials_;
    search.threads = 1;
    const std::optional<LearnRun> base = run_learn_case(object, hand, search);
    if (!base || base->best.empty() || !(base->best.back() > 0.0)) return;
    for (const bool known : {true, false}) {
      search.learned = LearnedOrder{.model = model(fold_of(object.name), known ? "" : hand)};
      const std::optional<LearnRun> learned = run_learn_case(object, hand, search);
      if (learned) print_comparison(known ? "known" : "unknown", *base, *learned);
    }
  }

  // Of the other folds, and of all hands but this one.
  const std::shared_ptr<const TreeModel>& model(int fold, const std::string& without) {
    std::shared_ptr<const TreeModel>& model = models_[{fold, without}];
    if (!model) {
      model = model_of(runs_, [&](const LearnRun& run) {
        return fold_of(run.object) != fold && run.hand != without;
      });
    }
    return model;
  }

  std::vector<LearnRun> runs_;
  std::vector<std::string> seeds_;
  int trials_ = 800;
  std::vector<std::string> hands_;
  std::size_t first_ = 0;
  std::size_t every_ = 1;
  std::vector<LearnObject> objects_;
  std::map<std::pair<int, std::string>, std::shared_ptr<const TreeModel>> models_;
};

void train(const std::vector<std::string>& words) {
  const TreeModel model =
      *model_of(read_all(words.at(0)), [](const LearnRun& /*run*/) { return true; });
  write_file(words.at(1), tree_model_json(model));
  std::printf("%d trials, %d objects, %d hands\n", model.trials, model.objects,
              static_cast<int>(model.hands.size()));
}

void run(const std::vector<std::string>& words) {
  const std::string what = words.empty() ? "" : words.front();
  const std::vector<std::string> rest(words.begin() + (words.empty() ? 0 : 1), words.end());
  if (what == "collect" && rest.size() > 5) return collect(rest);
  if (what == "compare" && rest.size() > 6) return Comparison(rest).run();
  if (what == "train" && rest.size() == 2) return train(rest);
  throw InputError("see the head of benchmarks/learn/learn.cpp for the words");
}

}  // namespace
}  // namespace prehend::bench

int main(int argc, char** argv) {
  try {
    prehend::bench::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "learn_benchmark: %s\n", error.what());
    return 2;
  }
  return 0;
}
