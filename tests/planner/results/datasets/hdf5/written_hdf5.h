// HDF5 files that HDF5's own library writes, in each of the ways that the format has.
#pragma once

#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/results/datasets/hdf5_id.h"
#include "sim/base/input_file.h"

namespace prehend::test {

// Which version of the superblock, and of all that follows from it, is written.
enum class Superblock { version_0 = 0, version_1 = 1, version_2 = 2, version_3 = 3 };

// The bytes of the file that `fill` is given open.
inline std::string written_hdf5(Superblock version, const std::function<void(hid_t)>& fill) {
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  const Hdf5Id creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  const H5F_libver_t low = version == Superblock::version_3   ? H5F_LIBVER_V110
                           : version == Superblock::version_2 ? H5F_LIBVER_V18
                                                              : H5F_LIBVER_EARLIEST;
  EXPECT_GE(H5Pset_libver_bounds(access.id(), low, H5F_LIBVER_V110), 0);
  if (version == Superblock::version_1) {
    EXPECT_GE(H5Pset_istore_k(creation.id(), 3), 0);
  }
  const std::string name = "written.h5";
  {
    const Hdf5Id file(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
    EXPECT_TRUE(file.valid());
    fill(file.id());
  }
  std::string bytes = read_file(name);
  EXPECT_EQ(bytes.at(8), static_cast<char>(version));
  return bytes;
}

// How a data set is made.
struct HowStored {
  std::vector<hsize_t> shape = {};
  std::vector<hsize_t> most = {};   // empty: the shape
  std::vector<hsize_t> chunk = {};  // empty: not in chunks
  bool compact = false;
  bool shuffle = false;
  bool deflate = false;
  bool fletcher32 = false;
  bool early = false;        // all chunks are made at once
  bool whole_edges = false;  // chunks that the extents cut are not filtered
};

inline Hdf5Id space_of(const HowStored& how) {
  if (how.shape.empty()) return {H5Screate(H5S_SCALAR), H5Sclose};
  const hsize_t* most = how.most.empty() ? nullptr : how.most.data();
  return {H5Screate_simple(static_cast<int>(how.shape.size()), how.shape.data(), most), H5Sclose};
}

// Makes the data set; nothing is written to it yet.
inline Hdf5Id made_data_set(hid_t file, const std::string& path, hid_t stored, const HowStored& how,
                            const void* fill = nullptr) {
  const Hdf5Id creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (how.compact) H5Pset_layout(creation.id(), H5D_COMPACT);
  if (!how.chunk.empty()) {
    H5Pset_chunk(creation.id(), static_cast<int>(how.chunk.size()), how.chunk.data());
  }
  if (how.whole_edges) {
    H5Pset_chunk_opts(creation.id(), H5D_CHUNK_DONT_FILTER_PARTIAL_CHUNKS);
  }
  if (how.shuffle) H5Pset_shuffle(creation.id());
  if (how.deflate) H5Pset_deflate(creation.id(), 6);
  if (how.fletcher32) H5Pset_fletcher32(creation.id());
  if (how.early) H5Pset_alloc_time(creation.id(), H5D_ALLOC_TIME_EARLY);
  if (fill != nullptr) H5Pset_fill_value(creation.id(), stored, fill);
  const Hdf5Id space = space_of(how);
  Hdf5Id data(
      H5Dcreate2(file, path.c_str(), stored, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
      H5Dclose);
  EXPECT_TRUE(data.valid()) << path;
  return data;
}

inline void write_values(hid_t file, const std::string& path, hid_t stored, hid_t given,
                         const HowStored& how, const void* values) {
  const Hdf5Id data = made_data_set(file, path, stored, how);
  EXPECT_GE(H5Dwrite(data.id(), given, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), 0) << path;
}

inline void make_group(hid_t file, const std::string& path) {
  const Hdf5Id group(H5Gcreate2(file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                     H5Gclose);
  EXPECT_TRUE(group.valid()) << path;
}

}  // namespace prehend::test
