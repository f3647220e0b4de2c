// What an HDF5 file says of a data set: type, extents, how and where its values are stored.
#pragma once

#include <vector>

#include "planner/results/datasets/hdf5/object_header.h"

namespace prehend::hdf5 {

enum class ValueKind {
  other,       // nothing that is read
  whole,       // whole numbers of 1 to 8 bytes
  real,        // IEEE numbers of 2, 4 or 8 bytes
  flag,        // an enum over whole numbers of 1 byte, such as h5py's booleans
  fixed_text,  // texts of one length
  any_text,    // texts of any length
};

struct ValueType {
  ValueKind kind = ValueKind::other;
  std::size_t size = 0;  // bytes of a value in the file
  bool big_endian = false;
  bool is_signed = false;
  bool blanks = false;  // texts are padded with blanks, not with bytes 0
};

struct Extents {
  bool none = false;               // a data set without values (H5S_NULL)
  std::vector<std::size_t> sizes;  // empty: a scalar
  std::vector<std::size_t> most;   // how far each may grow; kNowhere: without end
};

enum class ChunkIndex : std::uint8_t {
  tree1 = 0,  // of layouts of version 3; the others are of version 4
  single = 1,
  implicit = 2,
  fixed_array = 3,
  extensible_array = 4,
  tree2 = 5,
};

struct Layout {
  enum class Kind { compact, contiguous, chunked } kind = Kind::contiguous;
  Bytes compact;                     // the values themselves
  std::uint64_t address = kNowhere;  // of the values, or of the index of chunks
  // Chunks:
  std::vector<std::size_t> chunk;  // values along each extent
  ChunkIndex index = ChunkIndex::tree1;
  bool whole_edges = false;      // chunks that the extents cut are not filtered
  bool single_filtered = false;  // with the next two
  std::uint64_t single_size = 0;
  std::uint64_t single_mask = 0;
};

enum class FilterType : std::uint16_t { deflate = 1, shuffle = 2, fletcher32 = 3 };

struct Filter {
  FilterType type{};
  std::uint64_t value = 0;  // its first parameter
};

struct DataSet {
  ValueType type;
  Extents extents;
  Layout layout;
  std::vector<Filter> filters;  // in the order of writing
  Bytes fill;                   // one value; empty: zeros
};

bool is_data_set(const Messages& header);

// Throws damaged(), and not_read() for layouts and filters that are not known.
Extents extents_of(const Image& image, const Messages& header);
DataSet data_set_of(const Image& image, const Messages& header);

}  // namespace prehend::hdf5
