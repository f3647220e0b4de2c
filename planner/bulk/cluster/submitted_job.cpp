#include "planner/bulk/cluster/submitted_job.h"

#include <nlohmann/json.hpp>

#include "sim/base/input_file.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

constexpr const char* kFormat = "prehend cluster job 1";

template <typename T>
nlohmann::ordered_json value_or_null(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

nlohmann::ordered_json settings_json(const ClusterJob& job) {
  nlohmann::ordered_json json;
  json["name"] = job.name;
  json["program"] = job.program.string();
  json["batch"] = job.batch.string();
  json["cores"] = job.cores;
  json["at_once"] = value_or_null(job.at_once);
  json["merge"] = job.merge;
  if (job.engine == ClusterEngine::slurm) {
    json["memory"] = job.memory.value_or(kUsualMemory);
    json["time_limit"] = value_or_null(job.time_limit);
    json["partition"] = job.partition;
    json["account"] = job.account;
  } else {
    json["hosts"] = job.hosts.string();
  }
  json["extra_lines"] = job.extra_lines;
  return json;
}

nlohmann::ordered_json process_json(const ProcessMark& process) {
  nlohmann::ordered_json json;
  json["host"] = process.host;
  json["boot"] = process.boot;
  json["pid"] = process.pid;
  json["started"] = process.started;
  return json;
}

ProcessMark read_process(const JsonField& field) {
  field.allow_only({"host", "boot", "pid", "started"});
  ProcessMark process{.host = field["host"].text(),
                      .boot = field["boot"].text(),
                      .pid = field["pid"].integer(),
                      .started = field["started"].unsigned_integer()};
  // Smaller numbers mean groups of processes, or all of them, to kill(2).
  if (process.pid <= 1) field["pid"].fail("must be larger than 1");
  return process;
}

// scancel and squeue take more than numbers, options among it.
std::string read_id(const JsonField& field) {
  std::string id = field.text();
  if (id.find_first_not_of("0123456789") != std::string::npos) field.fail("must be a number");
  return id;
}

}  // namespace

std::filesystem::path job_file(const std::filesystem::path& out) { return out / "job.json"; }

void write_submitted_job(const SubmittedJob& submitted, const ClusterJob& job) {
  nlohmann::ordered_json json;
  json["format"] = kFormat;
  json["engine"] = name_of(submitted.engine);
  json["shards"] = submitted.shards;
  if (submitted.engine == ClusterEngine::slurm) json["ids"] = submitted.ids;
  if (submitted.process) json["process"] = process_json(*submitted.process);
  json["settings"] = settings_json(job);
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  write_file(job_file(job.out), json.dump(2, ' ', false, replace) + "\n");
}

std::optional<SubmittedJob> read_submitted_job(const std::filesystem::path& out) {
  if (!is_there(job_file(out))) return std::nullopt;
  const JsonFile file(job_file(out));
  const JsonField root = file.root();
  root.allow_only({"format", "engine", "shards", "ids", "process", "settings"});
  if (root["format"].text() != kFormat) {
    root["format"].fail(std::string("must be \"") + kFormat + "\"");
  }
  SubmittedJob job;
  job.engine =
      with_field_errors(root["engine"], [&] { return engine_named(root["engine"].text()); });
  job.shards = root["shards"].integer();
  if (job.engine == ClusterEngine::slurm) {
    for (const JsonField& id : root["ids"].items()) job.ids.push_back(read_id(id));
    if (job.ids.empty()) root["ids"].fail("must not be empty");
  } else {
    job.process = read_process(root["process"]);
  }
  return job;
}

}  // namespace prehend
