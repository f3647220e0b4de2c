#include "planner/results/datasets/hdf5_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "planner/results/datasets/hdf5_id.h"
#include "sim/base/formatted.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"

namespace prehend {
namespace {

constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
// Deflate makes at most 1,032 bytes of one. Data sets that claim more than that of the file are
// mostly unwritten, which no program that writes grasps leaves.
constexpr std::size_t kMostPerByte = 1032;
constexpr std::size_t kSlack = std::size_t{1} << 16U;         // bytes that any file may claim
constexpr std::size_t kLargestChunk = std::size_t{1} << 26U;  // bytes
constexpr std::size_t kLongestText = std::size_t{1} << 20U;   // bytes of a fixed length
constexpr std::size_t kMostTexts = 100000;

std::string words_of(const Hdf5Shape& shape) {
  std::string words;
  for (const std::size_t extent : shape) {
    add_part(words, std::to_string(extent));
  }
  return "(" + words + ")";
}

bool is_scalar(const Hdf5Shape& shape) { return shape.empty() || shape == Hdf5Shape{1}; }

Hdf5Id open_in_memory(const std::string& name, std::string& bytes) {
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access.id(), kSlack, false);
  H5Pset_file_image(access.id(), bytes.data(), bytes.size());
  return {H5Fopen(name.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose};
}

}  // namespace

struct Hdf5Reader::File {
  QuietHdf5 quiet;
  std::string path;
  std::size_t size = 0;
  Hdf5Id id;

  File(std::string name, std::string bytes)
      : path(std::move(name)),
        size(bytes.size()),
        id(open_in_memory(name_in_memory(this), bytes)) {}

  InputError error(const std::string& field, const std::string& problem,
                   const std::string& value = {}) const {
    return InputError({path, field, problem, value});
  }

  // Whether there is something of this path, of links inside the file alone: others lead to files
  // that the user has not named.
  bool has(const std::string& field) const {
    for (std::size_t end = 0; end != std::string::npos;) {
      end = field.find('/', end + 1);
      const std::string part = field.substr(0, end);
      if (H5Lexists(id.id(), part.c_str(), H5P_DEFAULT) <= 0) return false;
      H5L_info_t link{};
      if (H5Lget_info(id.id(), part.c_str(), &link, H5P_DEFAULT) < 0) {
        throw error(part, "is damaged");
      }
      if (link.type != H5L_TYPE_HARD) throw error(part, "must not be a link to somewhere else");
    }
    return true;
  }

  Hdf5Id open(const std::string& field) const {
    if (!has(field)) throw error(field, "is missing");
    const Hdf5Id object(H5Oopen(id.id(), field.c_str(), H5P_DEFAULT), H5Oclose);
    if (!object.valid()) throw error(field, "is damaged");
    if (H5Iget_type(object.id()) != H5I_DATASET) throw error(field, "must be a data set");
    Hdf5Id data(H5Dopen2(id.id(), field.c_str(), H5P_DEFAULT), H5Dclose);
    if (!data.valid()) throw error(field, "is damaged");
    require_own_storage(field, data);
    return data;
  }

  // That its values are in this file, in pieces of a bounded size, and need no plug-in.
  void require_own_storage(const std::string& field, const Hdf5Id& data) const {
    const Hdf5Id how(H5Dget_create_plist(data.id()), H5Pclose);
    if (!how.valid()) throw error(field, "is damaged");
    const H5D_layout_t layout = H5Pget_layout(how.id());
    if (layout == H5D_VIRTUAL || H5Pget_external_count(how.id()) != 0) {
      throw error(field, "must not be stored in other files");
    }
    if (layout == H5D_CHUNKED) require_small_chunks(field, data, how);
    const int filters = H5Pget_nfilters(how.id());
    for (int i = 0; i < filters; ++i) {
      unsigned flags = 0;
      unsigned configuration = 0;
      std::size_t values = 0;
      const H5Z_filter_t filter = H5Pget_filter2(how.id(), static_cast<unsigned>(i), &flags,
                                                 &values, nullptr, 0, nullptr, &configuration);
      if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE &&
          filter != H5Z_FILTER_FLETCHER32) {
        throw error(field, "is stored with a filter that is not known", std::to_string(filter));
      }
    }
  }

  void require_small_chunks(const std::string& field, const Hdf5Id& data, const Hdf5Id& how) const {
    std::array<hsize_t, H5S_MAX_RANK> chunk{};
    const int rank = H5Pget_chunk(how.id(), H5S_MAX_RANK, chunk.data());
    const Hdf5Id type(H5Dget_type(data.id()), H5Tclose);
    if (rank <= 0 || !type.valid()) throw error(field, "is damaged");
    std::size_t bytes = std::max<std::size_t>(H5Tget_size(type.id()), 1);
    for (int i = 0; i < rank; ++i) {
      const std::size_t extent = chunk.at(static_cast<std::size_t>(i));
      if (extent == 0 || extent > kLargestChunk / bytes) throw error(field, "has too large chunks");
      bytes *= extent;
    }
  }

  Hdf5Shape shape_of(const std::string& field, const Hdf5Id& data) const {
    const Hdf5Id space(H5Dget_space(data.id()), H5Sclose);
    if (!space.valid()) throw error(field, "is damaged");
    const H5S_class_t kind = H5Sget_simple_extent_type(space.id());
    if (kind == H5S_SCALAR) return {};
    std::array<hsize_t, H5S_MAX_RANK> extents{};
    const int rank = H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr);
    if (kind != H5S_SIMPLE || rank < 0) throw error(field, "has no values");
    return {extents.begin(), extents.begin() + rank};
  }

  // The number of values. Checks it against the size of the file before any memory is taken.
  std::size_t counted(const std::string& field, const Hdf5Shape& shape, std::size_t value) const {
    const std::size_t most = (size * kMostPerByte + kSlack) / value;
    std::size_t count = 1;
    for (const std::size_t extent : shape) {
      if (extent != 0 && count > most / extent) {
        throw error(field, "has more values than a file of this size can hold", words_of(shape));
      }
      count *= extent;
    }
    return count;
  }

  void require_shape(const std::string& field, const Hdf5Id& data, const Hdf5Shape& asked) const {
    const Hdf5Shape found = shape_of(field, data);
    if (found == asked || (asked.empty() && is_scalar(found))) return;
    throw error(field, "must have the shape " + words_of(asked), words_of(found));
  }

  template <typename T>
  std::vector<T> read(const std::string& field, const Hdf5Id& data, const Hdf5Shape& shape,
                      hid_t type) const {
    require_shape(field, data, shape);
    std::vector<T> values(counted(field, shape, sizeof(T)));
    if (values.empty()) return values;
    if (H5Dread(data.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
      throw error(field, "cannot be read: it is damaged");
    }
    return values;
  }

  // Numbers of 1 to 8 bytes.
  bool is_number(const Hdf5Id& type, H5T_class_t kind) const {
    const std::size_t bytes = H5Tget_size(type.id());
    return H5Tget_class(type.id()) == kind && bytes >= 1 && bytes <= 8;
  }

  template <typename T>
  std::vector<T> floats(const std::string& field, const Hdf5Shape& shape, hid_t in_memory) const {
    const Hdf5Id data = open(field);
    const Hdf5Id type(H5Dget_type(data.id()), H5Tclose);
    if (!is_number(type, H5T_FLOAT) && !is_number(type, H5T_INTEGER)) {
      throw error(field, "must be numbers");
    }
    return read<T>(field, data, shape, in_memory);
  }

  std::vector<std::string> fixed_texts(const std::string& field, const Hdf5Id& data,
                                       const Hdf5Id& type, std::size_t count) const {
    const std::size_t length = H5Tget_size(type.id());
    if (length == 0 || length > kLongestText) throw error(field, "has too long texts");
    std::string all(counted(field, {count, length}, 1), '\0');
    if (count > 0 && H5Dread(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0) {
      throw error(field, "cannot be read: it is damaged");
    }
    // Padded with zeros or blanks.
    const bool blanks = H5Tget_strpad(type.id()) == H5T_STR_SPACEPAD;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < count; ++i) {
      std::string text = all.substr(i * length, length);
      text.resize(std::min(text.find('\0'), text.size()));
      if (blanks) text.erase(text.find_last_not_of(' ') + 1);
      texts.push_back(std::move(text));
    }
    return texts;
  }

  std::vector<std::string> any_texts(const std::string& field, const Hdf5Id& data,
                                     const Hdf5Id& type, std::size_t count) const {
    std::vector<char*> pointers(count, nullptr);
    const Hdf5Id space(H5Dget_space(data.id()), H5Sclose);
    const bool read = count == 0 || H5Dread(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                            pointers.data()) >= 0;
    std::vector<std::string> texts;
    for (const char* pointer : pointers) texts.emplace_back(pointer == nullptr ? "" : pointer);
    if (count > 0) H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, pointers.data());
    if (!read) throw error(field, "cannot be read: it is damaged");
    return texts;
  }

  std::vector<std::string> texts(const std::string& field, const Hdf5Id& data,
                                 std::size_t count) const {
    if (count > kMostTexts) throw error(field, "has too many texts", std::to_string(count));
    const Hdf5Id type(H5Dget_type(data.id()), H5Tclose);
    if (!type.valid() || H5Tget_class(type.id()) != H5T_STRING) throw error(field, "must be text");
    const bool any_length = H5Tis_variable_str(type.id()) > 0;
    return any_length ? any_texts(field, data, type, count) : fixed_texts(field, data, type, count);
  }
};

bool is_hdf5_file(const std::filesystem::path& file) {
  if (!is_file(file)) return false;
  std::array<char, kSignature.size()> start{};
  std::ifstream(file, std::ios::binary).read(start.data(), start.size());
  return std::string_view(start.data(), start.size()) == kSignature;
}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file)
    : file_(std::make_unique<File>(file.string(), read_file(file))) {
  if (!file_->id.valid()) {
    throw InputError({.file = file.string(), .problem = "is no HDF5 file, or a damaged one"});
  }
}

Hdf5Reader::~Hdf5Reader() = default;

InputError Hdf5Reader::error(const std::string& path, const std::string& problem,
                             const std::string& value) const {
  return file_->error(path, problem, value);
}

bool Hdf5Reader::has(const std::string& path) const { return file_->has(path); }

std::vector<std::string> Hdf5Reader::members(const std::string& path) const {
  if (!file_->has(path)) throw error(path, "is missing");
  const Hdf5Id group(H5Gopen2(file_->id.id(), path.c_str(), H5P_DEFAULT), H5Gclose);
  H5G_info_t info{};
  if (!group.valid() || H5Gget_info(group.id(), &info) < 0) throw error(path, "must be a group");
  if (info.nlinks > kMostMembers) throw error(path, "has too many members");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    std::array<char, 256> name{};
    const ssize_t length = H5Lget_name_by_idx(group.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i,
                                              name.data(), name.size(), H5P_DEFAULT);
    if (length < 0) throw error(path, "is damaged");
    if (static_cast<std::size_t>(length) < name.size()) names.emplace_back(name.data());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Hdf5Shape Hdf5Reader::shape(const std::string& path) const {
  return file_->shape_of(path, file_->open(path));
}

std::vector<double> Hdf5Reader::numbers_or_nan(const std::string& path,
                                               const Hdf5Shape& shape) const {
  return file_->floats<double>(path, shape, H5T_NATIVE_DOUBLE);
}

std::vector<float> Hdf5Reader::floats_or_nan(const std::string& path,
                                             const Hdf5Shape& shape) const {
  return file_->floats<float>(path, shape, H5T_NATIVE_FLOAT);
}

std::vector<double> Hdf5Reader::numbers(const std::string& path, const Hdf5Shape& shape) const {
  std::vector<double> values = numbers_or_nan(path, shape);
  const auto bad = std::find_if(values.begin(), values.end(),
                                [](double value) { return !std::isfinite(value); });
  if (bad == values.end()) return values;
  const std::size_t place = static_cast<std::size_t>(bad - values.begin());
  const std::size_t row = shape.empty() ? 0 : place / (values.size() / shape.front());
  throw error(path + (shape.empty() ? "" : "[" + std::to_string(row) + "]"), "must be finite",
              formatted("%g", *bad));
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& path,
                                               const Hdf5Shape& shape) const {
  const Hdf5Id data = file_->open(path);
  const Hdf5Id type(H5Dget_type(data.id()), H5Tclose);
  if (file_->is_number(type, H5T_INTEGER)) {
    return file_->read<std::int64_t>(path, data, shape, H5T_NATIVE_INT64);
  }
  // What h5py writes of booleans.
  if (!file_->is_number(type, H5T_ENUM) || H5Tget_size(type.id()) != 1) {
    throw error(path, "must be whole numbers");
  }
  const auto flags = file_->read<std::int8_t>(path, data, shape, type.id());
  return {flags.begin(), flags.end()};
}

std::string Hdf5Reader::text(const std::string& path) const {
  const Hdf5Id data = file_->open(path);
  const Hdf5Shape shape = file_->shape_of(path, data);
  if (!is_scalar(shape)) throw error(path, "must be one text", words_of(shape));
  return file_->texts(path, data, 1).front();
}

std::vector<std::string> Hdf5Reader::texts(const std::string& path) const {
  const Hdf5Id data = file_->open(path);
  const Hdf5Shape shape = file_->shape_of(path, data);
  if (shape.size() != 1) throw error(path, "must be a list of texts", words_of(shape));
  return file_->texts(path, data, shape.front());
}

}  // namespace prehend
