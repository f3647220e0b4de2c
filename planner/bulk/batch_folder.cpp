#include "planner/bulk/batch_folder.h"

#include <utility>

#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

constexpr const char* kMarker = "batch.json";

// Folders with many files are slow on the file systems of clusters: parts are spread over 256.
std::filesystem::path part_folder(const std::filesystem::path& folder, const std::string& key) {
  return folder / "parts" / key.substr(0, 2);
}

// Besides the marker, also half written.
bool has_other_files(const std::filesystem::path& folder) {
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; at != end; at.increment(error)) {
    if (!at->path().filename().string().starts_with(kMarker)) return true;
  }
  return false;
}

}  // namespace

BatchFolder::BatchFolder(std::filesystem::path folder, const Batch& batch)
    : folder_(std::move(folder)), batch_(batch.name) {
  const std::filesystem::path marker = folder_ / kMarker;
  // The marker is looked for last: another process that begins the batch writes it first.
  const bool is_used = has_other_files(folder_);
  if (!is_there(marker)) {
    require(!is_used, {.file = folder_.string(), .problem = "has files, but not of a batch"});
    return;
  }
  const JsonFile file(marker);
  const std::string owner = file.root()["batch"].text();
  require(
      owner == batch_,
      {.file = folder_.string(), .problem = "belongs to another batch, " + owner, .value = batch_});
}

void BatchFolder::create() const {
  make_folder(folder_);
  if (is_there(folder_ / kMarker)) return;
  nlohmann::ordered_json json{{"batch", batch_}};
  write_file(folder_ / kMarker, json.dump(2) + "\n");
}

std::filesystem::path BatchFolder::result_file(const std::string& key) const {
  return part_folder(folder_, key) / (key + ".h5");
}

std::filesystem::path BatchFolder::failure_file(const std::string& key) const {
  return part_folder(folder_, key) / (key + ".txt");
}

PartState BatchFolder::state(const std::string& key) const {
  if (is_file(result_file(key))) return PartState::finished;
  return is_file(failure_file(key)) ? PartState::failed : PartState::open;
}

void BatchFolder::write_result(const std::string& key, const std::string& bytes) const {
  make_folder(part_folder(folder_, key));
  write_file(result_file(key), bytes);
  remove_file(failure_file(key));
}

void BatchFolder::write_failure(const std::string& key, const std::string& reason) const {
  make_folder(part_folder(folder_, key));
  write_file(failure_file(key), on_one_line(reason) + "\n");
}

std::string BatchFolder::failure(const std::string& key) const {
  std::string line = read_file(failure_file(key));
  while (!line.empty() && line.back() == '\n') line.pop_back();
  return line;
}

}  // namespace prehend
