#include "planner/results/datasets/hdf5_writer.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <new>
#include <numeric>
#include <sys/mman.h>

#include "planner/results/datasets/hdf5_id.h"

namespace prehend {
namespace {

constexpr std::size_t kSmallArray = 512;  // bytes that stand in the header of a data set
constexpr std::size_t kChunk = std::size_t{1} << 18U;  // bytes that are compressed together
constexpr unsigned kDeflateLevel = 6;
// Children of a node of the index of chunks, halved. HDF5 reserves whole nodes, so that many would
// cost more than the content of most data sets.
constexpr unsigned kIndexNode = 4;

// Throws std::bad_alloc unless there is memory for `bytes` and what HDF5 takes beside them. Where
// HDF5 itself finds none, it may end the process.
void require_memory(std::size_t bytes) {
  constexpr std::size_t kBeside = std::size_t{16} << 20U;
  // Of the copies in the file and in its image. An optimiser may leave out a new that nothing uses.
  const std::size_t size = 2 * bytes + kBeside;
  void* tried = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (tried == MAP_FAILED) throw std::bad_alloc();
  ::munmap(tried, size);
}

// All is made in memory: that is what calls fail for.
Hdf5Id checked(hid_t id, Hdf5Id::Close close) {
  if (id < 0) throw std::bad_alloc();
  return {id, close};
}

void check(herr_t status) {
  if (status < 0) throw std::bad_alloc();
}

std::size_t product(const Hdf5Shape& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<hsize_t> extents(const Hdf5Shape& shape) { return {shape.begin(), shape.end()}; }

Hdf5Id space_of(const Hdf5Shape& shape) {
  if (shape.empty()) return checked(H5Screate(H5S_SCALAR), H5Sclose);
  const std::vector<hsize_t> sizes = extents(shape);
  return checked(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose);
}

Hdf5Id properties(hid_t kind) {
  Hdf5Id made = checked(H5Pcreate(kind), H5Pclose);
  check(H5Pset_obj_track_times(made.id(), false));
  return made;
}

// Of a group, or of a file, which is one. In groups whose order is kept, names take less room.
Hdf5Id group_properties(hid_t kind) {
  Hdf5Id made = properties(kind);
  check(H5Pset_link_creation_order(made.id(), H5P_CRT_ORDER_TRACKED));
  return made;
}

// How the values of an array are stored: small ones with its header, others compressed in pieces
// of whole rows.
Hdf5Id storage(const Hdf5Shape& shape, std::size_t value_size) {
  Hdf5Id made = properties(H5P_DATASET_CREATE);
  const std::size_t bytes = product(shape) * value_size;
  if (bytes == 0) return made;
  if (bytes <= kSmallArray) {
    check(H5Pset_layout(made.id(), H5D_COMPACT));
    return made;
  }
  std::vector<hsize_t> chunk = extents(shape);
  const std::size_t row = bytes / shape.front();
  chunk.front() = std::clamp<hsize_t>(kChunk / row, 1, chunk.front());
  check(H5Pset_chunk(made.id(), static_cast<int>(chunk.size()), chunk.data()));
  check(H5Pset_shuffle(made.id()));
  check(H5Pset_deflate(made.id(), kDeflateLevel));
  return made;
}

Hdf5Id text_type() {
  Hdf5Id type = checked(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type.id(), H5T_VARIABLE));
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8));
  return type;
}

Hdf5Id file_in_memory(const std::string& name) {
  constexpr std::size_t kGrowth = std::size_t{1} << 16U;
  const Hdf5Id access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  check(H5Pset_fapl_core(access.id(), kGrowth, false));
  // Later versions of the first block have a checksum, which H5Fget_file_image invalidates.
  check(H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18));
  const Hdf5Id creation = group_properties(H5P_FILE_CREATE);
  check(H5Pset_istore_k(creation.id(), kIndexNode));
  // No file of this name is made.
  return checked(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
}

}  // namespace

struct Hdf5Writer::File {
  QuietHdf5 quiet;
  Hdf5Id id = file_in_memory(name_in_memory(this));

  void write(const std::string& path, const Hdf5Shape& shape, hid_t stored, hid_t given,
             const Hdf5Id& how, const void* values) const {
    require_memory(product(shape) * sizeof(double));
    const Hdf5Id space = space_of(shape);
    const Hdf5Id data = checked(
        H5Dcreate2(id.id(), path.c_str(), stored, space.id(), H5P_DEFAULT, how.id(), H5P_DEFAULT),
        H5Dclose);
    if (product(shape) == 0) return;
    check(H5Dwrite(data.id(), given, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  }
};

Hdf5Writer::Hdf5Writer() {
  require_memory(0);
  file_ = std::make_unique<File>();
}
Hdf5Writer::~Hdf5Writer() = default;

void Hdf5Writer::group(const std::string& path) {
  const Hdf5Id creation = group_properties(H5P_GROUP_CREATE);
  checked(H5Gcreate2(file_->id.id(), path.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
          H5Gclose);
}

void Hdf5Writer::array(const std::string& path, const Hdf5Shape& shape,
                       std::span<const double> values) {
  file_->write(path, shape, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, storage(shape, sizeof(double)),
               values.data());
}

void Hdf5Writer::array(const std::string& path, const Hdf5Shape& shape,
                       std::span<const float> values) {
  file_->write(path, shape, H5T_IEEE_F32LE, H5T_NATIVE_FLOAT, storage(shape, sizeof(float)),
               values.data());
}

void Hdf5Writer::array(const std::string& path, const Hdf5Shape& shape,
                       std::span<const std::int64_t> values) {
  file_->write(path, shape, H5T_STD_I64LE, H5T_NATIVE_INT64, storage(shape, sizeof(std::int64_t)),
               values.data());
}

void Hdf5Writer::array(const std::string& path, const Hdf5Shape& shape,
                       std::span<const std::int32_t> values) {
  file_->write(path, shape, H5T_STD_I32LE, H5T_NATIVE_INT32, storage(shape, sizeof(std::int32_t)),
               values.data());
}

void Hdf5Writer::array(const std::string& path, const Hdf5Shape& shape,
                       std::span<const std::int8_t> values) {
  file_->write(path, shape, H5T_STD_I8LE, H5T_NATIVE_INT8, storage(shape, 1), values.data());
}

void Hdf5Writer::text(const std::string& path, const std::string& value) {
  const Hdf5Id type = text_type();
  const char* const pointer = value.c_str();
  file_->write(path, {}, type.id(), type.id(), properties(H5P_DATASET_CREATE), &pointer);
}

void Hdf5Writer::texts(const std::string& path, const std::vector<std::string>& values) {
  const Hdf5Id type = text_type();
  std::vector<const char*> pointers;
  pointers.reserve(values.size());
  for (const std::string& value : values) pointers.push_back(value.c_str());
  file_->write(path, {values.size()}, type.id(), type.id(), properties(H5P_DATASET_CREATE),
               pointers.data());
}

std::string Hdf5Writer::bytes() const {
  require_memory(0);
  check(H5Fflush(file_->id.id(), H5F_SCOPE_GLOBAL));
  const ssize_t size = H5Fget_file_image(file_->id.id(), nullptr, 0);
  if (size < 0) check(-1);
  std::string image(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file_->id.id(), image.data(), image.size()) != size) check(-1);
  return image;
}

}  // namespace prehend
