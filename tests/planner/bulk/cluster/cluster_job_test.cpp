#include "planner/bulk/cluster/cluster_job.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "planner/bulk/cluster/run_words.h"
#include "sim/base/input_error.h"
#include "tests/planner/bulk/cluster/awkward_words.h"

namespace prehend::test {
namespace {

// A name of a file with all of a word but what no name of a file has.
std::string as_name(std::string word) {
  for (char& c : word) c = c == '/' ? '_' : c;
  return "n" + word;
}

// A folder with a program "PROGRAM" that writes each of its words as a line to the file "words" of
// the folder that follows "-o", and fails as often as its file "fails" says.
struct Stage {
  explicit Stage(const std::string& name)
      : folder(std::filesystem::path(testing::TempDir()) / name) {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }

  std::filesystem::path add_program(const std::string& name) const {
    const std::filesystem::path program = folder / name;
    std::ofstream(program)
        << "#!/bin/bash\n"
           "for ((i = 1; i <= $#; ++i)); do [[ ${!i} == -o ]] && j=$((i + 1)); done\n"
           "printf '%s\\n' \"$@\" >> \"${!j}/words\"\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return program;
  }

  ClusterJob job(const std::string& word, ClusterEngine engine) const {
    const std::string name = as_name(word);
    std::filesystem::remove_all(folder / ("out" + name));
    std::filesystem::create_directories(log_folder(folder / ("out" + name)));
    return {.engine = engine,
            .program = add_program("program" + name),
            .batch = folder / ("batch" + name),
            .out = folder / ("out" + name),
            .shards = 3,
            .cores = 2};
  }

  std::filesystem::path write(const std::string& script) const {
    std::ofstream(folder / "script.sh") << script;
    return folder / "script.sh";
  }

  std::filesystem::path folder;
};

std::string content_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::string shard_words(const ClusterJob& job, int shard) {
  return "batch\n" + job.batch.string() + "\n-o\n" + job.out.string() + "\n--shard\n" +
         std::to_string(shard) + "/" + std::to_string(job.shards) + "\n--threads\n" +
         std::to_string(job.cores) + "\n";
}

std::string merge_text(const ClusterJob& job) {
  return "batch\nmerge\n" + job.batch.string() + "\n-o\n" + job.out.string() + "\n";
}

ClusterJob plain_job(ClusterEngine engine = ClusterEngine::slurm) {
  return {.engine = engine, .program = "/p/prehend", .batch = "/b.json", .out = "/o", .shards = 8};
}

bool has_line(const std::string& script, const std::string& line) {
  return ("\n" + script).find("\n" + line + "\n") != std::string::npos;
}

// The script of Slurm as Slurm runs it: by bash, with the number of the task in the environment.
TEST(JobScript, OfSlurmRunsTheShardWhateverThePaths) {
  const Stage stage("job_script_slurm");
  for (const std::string& word : awkward_words()) {
    if (word.find_first_of("\\%") != std::string::npos) continue;  // refused
    const ClusterJob job = stage.job(word, ClusterEngine::slurm);
    const std::filesystem::path script = stage.write(job_script(job));
    EXPECT_EQ(run_words({"bash", "-n", script}).status, 0) << word;
    // The number of tasks is another one where only some of them were submitted.
    printed_by({"env", "SLURM_ARRAY_TASK_ID=2", "SLURM_ARRAY_TASK_COUNT=1", "bash", script});
    EXPECT_EQ(content_of(job.out / "words"), shard_words(job, 2)) << word;
  }
}

TEST(MergeScript, MergesWhateverThePaths) {
  const Stage stage("merge_script");
  for (const std::string& word : awkward_words()) {
    if (word.find_first_of("\\%") != std::string::npos) continue;  // refused
    const ClusterJob job = stage.job(word, ClusterEngine::slurm);
    printed_by({"bash", stage.write(merge_script(job))});
    EXPECT_EQ(content_of(job.out / "words"), merge_text(job)) << word;
  }
}

TEST(JobScript, OfParallelRunsAllShardsAndMergesWhateverThePaths) {
  if (!has_program("parallel")) GTEST_SKIP() << "there is no GNU parallel";
  const Stage stage("job_script_parallel");
  for (const std::string& word : {std::string("plain"), awkward_words().back()}) {
    ClusterJob job = stage.job(word, ClusterEngine::parallel);
    job.at_once = 1;  // in the order of their numbers
    const std::filesystem::path script = stage.write(job_script(job));
    EXPECT_EQ(run_words({"bash", "-n", script}).status, 0) << word;
    printed_by({"bash", script});
    EXPECT_EQ(content_of(job.out / "words"),
              shard_words(job, 1) + shard_words(job, 2) + shard_words(job, 3) + merge_text(job));
  }
}

TEST(JobScript, OfParallelDoesNotMergeWhereAShardFails) {
  if (!has_program("parallel")) GTEST_SKIP() << "there is no GNU parallel";
  const Stage stage("job_script_fails");
  ClusterJob job = stage.job("a b", ClusterEngine::parallel);
  job.program = stage.folder / "fails";
  std::ofstream(job.program) << "#!/bin/bash\necho \"$2\" >> '" << stage.folder.string()
                             << "/tries'\nexit 1\n";
  std::filesystem::permissions(job.program, std::filesystem::perms::owner_all);
  job.shards = 1;
  EXPECT_NE(run_words({"bash", stage.write(job_script(job))}).status, 0);
  std::string tries;
  for (int i = 0; i < kParallelTries; ++i) tries += job.batch.string() + "\n";
  EXPECT_EQ(content_of(stage.folder / "tries"), tries);
}

// The program ends by itself when it is asked to, and the task asks for another turn.
TEST(JobScript, OfSlurmStartsAgainWhenItsTimeEnds) {
  const Stage stage("job_script_time");
  ClusterJob job = stage.job("a b", ClusterEngine::slurm);
  std::ofstream(job.program) << "#!/bin/bash\ntrap 'exit 143' TERM\nkill -USR1 $PPID\n"
                                "for ((i = 0; i < 3000; ++i)); do sleep 0.01; done\n";
  std::ofstream(stage.folder / "scontrol") << "#!/bin/bash\necho \"$@\"\n";
  std::filesystem::permissions(stage.folder / "scontrol", std::filesystem::perms::owner_all);
  const std::string path = "PATH=" + stage.folder.string() + ":/usr/bin:/bin";
  std::vector<std::string> words{"env",
                                 path,
                                 "SLURM_ARRAY_TASK_ID=2",
                                 "SLURM_ARRAY_JOB_ID=17",
                                 "bash",
                                 stage.write(job_script(job))};
  const Finished again = run_words(words);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(again.out.ends_with("\nrequeue 17_2\n")) << again.out;
  words.insert(words.begin() + 1, "SLURM_RESTART_COUNT=" + std::to_string(kMostStarts));
  const Finished enough = run_words(words);
  EXPECT_EQ(enough.status, 143);
  EXPECT_EQ(enough.out, "");
}

TEST(JobScript, OfSlurmEndsAsItsProgramDoes) {
  const Stage stage("job_script_status");
  const ClusterJob job = stage.job("a b", ClusterEngine::slurm);
  std::ofstream(job.program) << "#!/bin/bash\nexit 2\n";
  EXPECT_EQ(run_words({"bash", stage.write(job_script(job))}).status, 2);
}

TEST(JobScript, HasWhatWasAskedFor) {
  ClusterJob job = plain_job();
  job.cores = 3;
  job.at_once = 5;
  job.memory = 2000;
  job.time_limit = 2 * 86400 + 3 * 3600 + 4 * 60 + 5;
  job.partition = "long";
  job.account = "grasps";
  const std::string script = job_script(job);
  for (const char* option :
       {"--array=1-8%5", "--cpus-per-task=3", "--mem=2000M", "--time=2-03:04:05",
        "--partition=long", "--account=grasps", "--requeue", "--open-mode=append"}) {
    EXPECT_TRUE(has_line(script, std::string("#SBATCH ") + option)) << option;
  }
}

TEST(JobScript, HasOptionsOfExtraLinesBeforeTheFirstCommand) {
  ClusterJob job = plain_job();
  job.extra_lines = {"module load gcc", "#SBATCH --qos=low"};
  for (const std::string& script : {job_script(job), merge_script(job)}) {
    EXPECT_NE(script.find("\n#SBATCH --qos=low\nmodule load gcc\n"), std::string::npos) << script;
    EXPECT_GT(script.find("module"), script.rfind("#SBATCH"));
  }
}

TEST(CheckClusterJob, RefusesWhatDoesNotFit) {
  const auto expect_refused = [](const std::string& field, const auto& change) {
    ClusterJob job = plain_job();
    change(job);
    try {
      check_cluster_job(job);
      ADD_FAILURE() << field;
    } catch (const InputError& error) {
      EXPECT_EQ(error.field(), field);
    }
  };
  check_cluster_job(plain_job());
  expect_refused("out", [](ClusterJob& job) { job.out = "relative"; });
  expect_refused("out", [](ClusterJob& job) { job.out = "/a\nb"; });
  expect_refused("out", [](ClusterJob& job) { job.out = "/a\\b"; });
  expect_refused("out", [](ClusterJob& job) { job.out = "/100%"; });
  expect_refused("batch", [](ClusterJob& job) { job.batch = "/a\rb"; });
  expect_refused("program", [](ClusterJob& job) { job.program = "/a\tb"; });
  expect_refused("shards", [](ClusterJob& job) { job.shards = 0; });
  expect_refused("cores", [](ClusterJob& job) { job.cores = -1; });
  expect_refused("at_once", [](ClusterJob& job) { job.at_once = 0; });
  expect_refused("memory", [](ClusterJob& job) { job.memory = 0; });
  expect_refused("time_limit", [](ClusterJob& job) { job.time_limit = 299; });
  expect_refused("partition", [](ClusterJob& job) { job.partition = "a b"; });
  expect_refused("account", [](ClusterJob& job) { job.account = "--x"; });
  expect_refused("extra_lines", [](ClusterJob& job) { job.extra_lines = {"a\nb"}; });
  expect_refused("hosts", [](ClusterJob& job) { job.hosts = "/hosts"; });
}

TEST(CheckClusterJob, RefusesOptionsOfSlurmForParallel) {
  ClusterJob job = plain_job(ClusterEngine::parallel);
  check_cluster_job(job);
  job.time_limit = 3600;
  EXPECT_THROW(check_cluster_job(job), InputError);
}

}  // namespace
}  // namespace prehend::test
