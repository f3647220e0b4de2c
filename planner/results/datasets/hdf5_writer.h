// An HDF5 file that is made in memory: same calls, same bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "planner/results/datasets/hdf5/hdf5_shape.h"

namespace prehend {

// Paths are those of HDF5 ("grasps/transforms"); the group in which something is made has to be
// there. What a call makes must not be there yet. Arrays of more than a few hundred bytes are
// compressed. Files can be read by HDF5 1.8 and later. Nothing that the machine, the time or the
// memory before says gets into the bytes. Several threads may write files at the same time, one
// each: Debian's HDF5 takes turns. Throws std::bad_alloc where HDF5 fails: it writes to memory.
class Hdf5Writer {
 public:
  Hdf5Writer();
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  void group(const std::string& path);

  // As many values as the shape has, the last index running fastest.
  void array(const std::string& path, const Hdf5Shape& shape, std::span<const double> values);
  void array(const std::string& path, const Hdf5Shape& shape, std::span<const float> values);
  void array(const std::string& path, const Hdf5Shape& shape, std::span<const std::int64_t> values);
  void array(const std::string& path, const Hdf5Shape& shape, std::span<const std::int32_t> values);
  void array(const std::string& path, const Hdf5Shape& shape, std::span<const std::int8_t> values);

  void scalar(const std::string& path, double value) { array(path, {}, std::span(&value, 1)); }
  void scalar(const std::string& path, std::int64_t value) {
    array(path, {}, std::span(&value, 1));
  }

  // Texts of any length in UTF-8, without a byte 0 in them.
  void text(const std::string& path, const std::string& value);
  void texts(const std::string& path, const std::vector<std::string>& values);

  // The file as it is so far.
  std::string bytes() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace prehend
