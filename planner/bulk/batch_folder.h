// The folder of a batch: results that are whole or absent, named by what they depend on.
//
//   batch.json        to which batch the folder belongs
//   parts/3f/KEY.h5   the result of a part (docs/reference/datasets.md); KEY begins with "3f"
//   parts/3f/KEY.txt  why the part has none, in one line
//   merged/           what merge_batch makes of the parts
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "planner/bulk/batch.h"

namespace prehend {

// How far a part is.
enum class PartState { open, finished, failed };

class BatchFolder {
 public:
  // Opens the folder of a batch. Creates nothing. Throws InputError for a folder that belongs to
  // another batch (by its name), and for one that has files but belongs to none.
  BatchFolder(std::filesystem::path folder, const Batch& batch);

  // Creates what is missing of it. Throws InputError where that cannot be done.
  void create() const;

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path result_file(const std::string& key) const;
  std::filesystem::path failure_file(const std::string& key) const;
  PartState state(const std::string& key) const;

  // Written whole; both throw InputError. A result takes the place of a failure.
  void write_result(const std::string& key, const std::string& bytes) const;
  void write_failure(const std::string& key, const std::string& reason) const;
  // The reason of a failed part.
  std::string failure(const std::string& key) const;

 private:
  std::filesystem::path folder_;
  std::string batch_;
};

}  // namespace prehend
