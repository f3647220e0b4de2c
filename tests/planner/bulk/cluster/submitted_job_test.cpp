#include "planner/bulk/cluster/submitted_job.h"

#include <fstream>

#include <gtest/gtest.h>

#include "planner/bulk/cluster/submit_job.h"
#include "sim/base/input_error.h"

namespace prehend::test {
namespace {

std::filesystem::path empty_folder() {
  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "submitted_job";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

ClusterJob job_in(const std::filesystem::path& folder) {
  return {.program = "/p", .batch = folder / "b.json", .out = folder, .shards = 8};
}

TEST(SubmittedJob, IsReadAsItWasWritten) {
  const std::filesystem::path folder = empty_folder();
  EXPECT_FALSE(read_submitted_job(folder).has_value());
  write_submitted_job({.shards = 8, .ids = {"17", "18"}}, job_in(folder));
  const std::optional<SubmittedJob> slurm = read_submitted_job(folder);
  ASSERT_TRUE(slurm.has_value());
  EXPECT_EQ(slurm->engine, ClusterEngine::slurm);
  EXPECT_EQ(slurm->shards, 8);
  EXPECT_EQ(slurm->ids, (std::vector<std::string>{"17", "18"}));
  const ProcessMark mark{.host = "h", .boot = "b", .pid = 7, .started = std::uint64_t{1} << 60U};
  write_submitted_job({.engine = ClusterEngine::parallel, .shards = 3, .process = mark},
                      job_in(folder));
  const std::optional<SubmittedJob> parallel = read_submitted_job(folder);
  ASSERT_TRUE(parallel.has_value() && parallel->process.has_value());
  EXPECT_EQ(parallel->engine, ClusterEngine::parallel);
  EXPECT_EQ(parallel->process->host, mark.host);
  EXPECT_EQ(parallel->process->boot, mark.boot);
  EXPECT_EQ(parallel->process->pid, mark.pid);
  EXPECT_EQ(parallel->process->started, mark.started);
}

// What kill(2) and scancel would take for much more than one job.
TEST(SubmittedJob, RefusesNumbersThatMeanMany) {
  const std::filesystem::path folder = empty_folder();
  const auto write = [&](const std::string& engine, const std::string& fields) {
    std::ofstream(job_file(folder)) << R"({"format":"prehend cluster job 1","engine":")" << engine
                                    << R"(","shards":1,)" << fields << "}";
  };
  for (const char* id : {"", "--user=root", "1,2", "-1"}) {
    write("slurm", std::string(R"("ids":[")") + id + "\"]");
    EXPECT_THROW(read_submitted_job(folder), InputError) << id;
  }
  write("slurm", "\"ids\":[]");
  EXPECT_THROW(read_submitted_job(folder), InputError);
  for (const char* pid : {"-1", "0", "1", "\"7\"", "99999999999"}) {
    write("parallel",
          std::string(R"("process":{"host":"h","boot":"b","started":1,"pid":)") + pid + "}");
    EXPECT_THROW(read_submitted_job(folder), InputError) << pid;
  }
}

TEST(StatusText, IsALine) {
  const JobStatus status{.job = {.shards = 8, .ids = {"17", "18"}},
                         .shards = {{"running", 2}, {"pending", 6}},
                         .started_again = 1,
                         .is_alive = true,
                         .merge = "pending"};
  EXPECT_EQ(status_text(status),
            "Slurm job 17: 6 pending, 2 running of 8 shards; 1 of them started again; "
            "merge pending\n");
}

TEST(CancelJob, NeedsAJob) { EXPECT_THROW(cancel_job(empty_folder()), InputError); }

}  // namespace
}  // namespace prehend::test
