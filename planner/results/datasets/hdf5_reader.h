// An HDF5 file that is read data set by data set. What it says is not trusted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "planner/results/datasets/hdf5_writer.h"
#include "sim/base/input_error.h"

namespace prehend {

// Whether the file begins as HDF5 files do. False also for what cannot be read.
bool is_hdf5_file(const std::filesystem::path& file);

// The whole file is held in memory. All calls throw InputError that names the file and the path
// of the data set: for one that is missing (but with has), has another type or shape than asked
// for, has more values than a file of that size can hold, is stored in other files or with other
// filters than HDF5's own deflate, shuffle and checksum, or cannot be read.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& file);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  bool has(const std::string& path) const;
  // Names in a group, sorted; at most kMostMembers.
  std::vector<std::string> members(const std::string& path) const;
  Hdf5Shape shape(const std::string& path) const;

  // The values of an array of exactly this shape. A scalar may also be an array of one value.
  // Numbers are finite, but for numbers_or_nan. Whole numbers may be stored as booleans, numbers
  // as whole ones.
  std::vector<double> numbers(const std::string& path, const Hdf5Shape& shape) const;
  std::vector<double> numbers_or_nan(const std::string& path, const Hdf5Shape& shape) const;
  std::vector<float> floats_or_nan(const std::string& path, const Hdf5Shape& shape) const;
  std::vector<std::int64_t> integers(const std::string& path, const Hdf5Shape& shape) const;

  // Of a fixed or any length.
  std::string text(const std::string& path) const;
  std::vector<std::string> texts(const std::string& path) const;

  // An error about this data set.
  InputError error(const std::string& path, const std::string& problem,
                   const std::string& value = {}) const;

  static constexpr std::size_t kMostMembers = 1000;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace prehend
