// An HDF5 file that is read data set by data set. What it says is not trusted.
//
// Read is the part of the format that files of grasps need, after the HDF5 File Format
// Specification Version 3.0 (The HDF Group, docs.hdfgroup.org); the numbers in parentheses are its
// sections.
// - superblocks of versions 0 to 3 at the start of the file (II.A)
// - groups: symbol tables, link messages, fractal heaps (III.A to III.C, III.G)
// - types: whole numbers of 1 to 8 bytes, IEEE numbers of 2, 4 and 8, texts, booleans as h5py
// writes
//   them (IV.A.2.d)
// - values: compact, contiguous or in chunks, with all indices of chunks (IV.A.2.i, VII)
// - filters: deflate, shuffle and fletcher32 (IV.A.2.l)
// All checksums are verified. Everything else is refused, and the message says what to do.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "planner/results/datasets/hdf5/hdf5_shape.h"
#include "sim/base/input_error.h"

namespace prehend {

// Whether the file begins as HDF5 files do. False also for what cannot be read.
bool is_hdf5_file(const std::filesystem::path& file);

// The whole file is held in memory. The values of a data set take at most 256 MB besides, as they
// are stored and as they are returned, and no more than a compressed file of that size can hold.
// All calls throw InputError that names the file and the path of the data set: for one that is
// missing (but with has), has another type or shape than asked for, has more values than a file of
// that size can hold, is stored in a way that is not read, or is damaged.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& file);
  // The bytes of a file of this name.
  Hdf5Reader(std::string name, std::string bytes);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  bool has(const std::string& path) const;
  // Names in a group, sorted. A group of more than 1,000 members is refused.
  std::vector<std::string> members(const std::string& path) const;
  Hdf5Shape shape(const std::string& path) const;

  // The values of an array of exactly this shape. A scalar may also be an array of one value.
  // Numbers are finite, but for numbers_or_nan. Whole numbers may be stored as booleans, numbers
  // as whole ones.
  std::vector<double> numbers(const std::string& path, const Hdf5Shape& shape) const;
  std::vector<double> numbers_or_nan(const std::string& path, const Hdf5Shape& shape) const;
  std::vector<float> floats_or_nan(const std::string& path, const Hdf5Shape& shape) const;
  std::vector<std::int64_t> integers(const std::string& path, const Hdf5Shape& shape) const;

  // Of a fixed or any length, up to a byte 0.
  std::string text(const std::string& path) const;
  std::vector<std::string> texts(const std::string& path) const;

  // An error about this data set.
  InputError error(const std::string& path, const std::string& problem,
                   const std::string& value = {}) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace prehend
