#include "planner/results/datasets/hdf5/hdf5_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include "planner/results/datasets/hdf5/data_set.h"
#include "planner/results/datasets/hdf5/group.h"
#include "planner/results/datasets/hdf5/values.h"
#include "planner/results/datasets/hdf5/values_as.h"
#include "sim/base/formatted.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"

namespace prehend {
namespace {

constexpr std::string_view kFileSignature = "\x89HDF\r\n\x1a\n";
constexpr std::size_t kLongestText = std::size_t{1} << 20U;  // bytes of a fixed length
constexpr std::size_t kMostTexts = 100000;

std::string words_of(const Hdf5Shape& shape) {
  return "(" + joined(shape, ", ", [](std::size_t extent) { return std::to_string(extent); }) + ")";
}

bool is_scalar(const Hdf5Shape& shape) { return shape.empty() || shape == Hdf5Shape{1}; }

hdf5::Bytes bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

hdf5::Superblock superblock_of(const std::string& name, const std::string& bytes) {
  try {
    return hdf5::read_superblock(bytes_of(bytes));
  } catch (const InputError& error) {
    throw InputError(
        {.file = name, .problem = "is no HDF5 file, or a damaged one: it " + error.problem()});
  }
}

// Throws InputError unless the data set has this shape.
void require_shape(const Hdf5Shape& found, const Hdf5Shape& asked) {
  if (found == asked || (asked.empty() && is_scalar(found))) return;
  throw InputError({.problem = "must have the shape " + words_of(asked), .value = words_of(found)});
}

}  // namespace

struct Hdf5Reader::File {
  std::string name;
  std::string bytes;
  hdf5::Superblock superblock;
  const hdf5::Image& image = superblock.image;

  File(std::string name_of_file, std::string bytes_of_file)
      : name(std::move(name_of_file)),
        bytes(std::move(bytes_of_file)),
        superblock(superblock_of(name, bytes)) {}

  // What `call` gives; its errors with the file and the path of the data set.
  template <typename Call>
  auto about(const std::string& path, const Call& call) const {
    try {
      return call();
    } catch (const InputError& error) {
      throw error.under(path).in_file(name);
    }
  }

  // The header of the object of this path, by links inside of the file alone: others lead to files
  // that the user has not named.
  std::optional<hdf5::Messages> find(const std::string& path) const {
    std::uint64_t object = superblock.root;
    for (std::size_t start = 0; start <= path.size();) {
      const std::size_t end = std::min(path.find('/', start), path.size());
      const std::string_view part = std::string_view(path).substr(start, end - start);
      const auto links = hdf5::links_of(image, hdf5::object_header(image, object));
      const auto link = std::find_if(links.begin(), links.end(),
                                     [&](const hdf5::Link& each) { return each.name == part; });
      if (link == links.end()) return {};
      if (link->object == hdf5::kNowhere) {
        throw InputError("must not be a link to somewhere else: copy what it leads to");
      }
      object = link->object;
      start = end + 1;
    }
    return hdf5::object_header(image, object);
  }

  hdf5::Messages object(const std::string& path) const {
    const auto found = find(path);
    if (!found) throw InputError("is missing");
    return *found;
  }

  hdf5::Messages data_object(const std::string& path) const {
    hdf5::Messages header = object(path);
    if (!hdf5::is_data_set(header)) throw InputError("must be a data set");
    return header;
  }

  hdf5::DataSet data(const std::string& path) const {
    hdf5::DataSet data = hdf5::data_set_of(image, data_object(path));
    if (data.extents.none) throw InputError("has no values");
    return data;
  }

  template <typename T>
  std::vector<T> numbers(const hdf5::DataSet& data, const Hdf5Shape& shape) const {
    require_shape(data.extents.sizes, shape);
    (void)hdf5::value_count(image, data.extents, sizeof(T));
    return hdf5::numbers_of<T>(data.type, hdf5::raw_values(image, data));
  }

  template <typename T>
  std::vector<T> floats(const std::string& path, const Hdf5Shape& shape) const {
    return about(path, [&] {
      const hdf5::DataSet found = data(path);
      if (found.type.kind != hdf5::ValueKind::whole && found.type.kind != hdf5::ValueKind::real) {
        throw InputError("must be numbers, of 1 to 8 bytes");
      }
      return numbers<T>(found, shape);
    });
  }

  std::vector<std::string> texts(const hdf5::DataSet& data) const {
    const std::size_t count = hdf5::value_count(image, data.extents, 1);
    if (count > kMostTexts) {
      throw InputError({.problem = "has too many texts", .value = std::to_string(count)});
    }
    const bool fixed = data.type.kind == hdf5::ValueKind::fixed_text;
    if (!fixed && data.type.kind != hdf5::ValueKind::any_text) throw InputError("must be text");
    if (fixed && (data.type.size == 0 || data.type.size > kLongestText)) {
      throw InputError("has too long texts");
    }
    return hdf5::texts_of(image, data.type, hdf5::raw_values(image, data));
  }
};

bool is_hdf5_file(const std::filesystem::path& file) {
  if (!is_file(file)) return false;
  std::array<char, kFileSignature.size()> start{};
  std::ifstream(file, std::ios::binary).read(start.data(), start.size());
  return std::string_view(start.data(), start.size()) == kFileSignature;
}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file)
    : Hdf5Reader(file.string(), read_file(file)) {}

Hdf5Reader::Hdf5Reader(std::string name, std::string bytes)
    : file_(std::make_unique<File>(std::move(name), std::move(bytes))) {}

Hdf5Reader::~Hdf5Reader() = default;

InputError Hdf5Reader::error(const std::string& path, const std::string& problem,
                             const std::string& value) const {
  return InputError({file_->name, path, problem, value});
}

bool Hdf5Reader::has(const std::string& path) const {
  return file_->about(path, [&] { return file_->find(path).has_value(); });
}

std::vector<std::string> Hdf5Reader::members(const std::string& path) const {
  return file_->about(path, [&] {
    const hdf5::Messages header = file_->object(path);
    if (!hdf5::is_group(header)) throw InputError("must be a group");
    std::vector<std::string> names;
    for (const hdf5::Link& link : hdf5::links_of(file_->image, header)) names.push_back(link.name);
    std::sort(names.begin(), names.end());
    return names;
  });
}

Hdf5Shape Hdf5Reader::shape(const std::string& path) const {
  return file_->about(path, [&] {
    const hdf5::Extents extents = hdf5::extents_of(file_->image, file_->data_object(path));
    if (extents.none) throw InputError("has no values");
    return extents.sizes;
  });
}

std::vector<double> Hdf5Reader::numbers_or_nan(const std::string& path,
                                               const Hdf5Shape& shape) const {
  return file_->floats<double>(path, shape);
}

std::vector<float> Hdf5Reader::floats_or_nan(const std::string& path,
                                             const Hdf5Shape& shape) const {
  return file_->floats<float>(path, shape);
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
  return file_->about(path, [&] {
    const hdf5::DataSet data = file_->data(path);
    if (data.type.kind != hdf5::ValueKind::whole && data.type.kind != hdf5::ValueKind::flag) {
      throw InputError("must be whole numbers, of 1 to 8 bytes");
    }
    return file_->numbers<std::int64_t>(data, shape);
  });
}

std::string Hdf5Reader::text(const std::string& path) const {
  return file_->about(path, [&] {
    const hdf5::DataSet data = file_->data(path);
    if (!is_scalar(data.extents.sizes)) {
      throw InputError({.problem = "must be one text", .value = words_of(data.extents.sizes)});
    }
    return file_->texts(data).front();
  });
}

std::vector<std::string> Hdf5Reader::texts(const std::string& path) const {
  return file_->about(path, [&] {
    const hdf5::DataSet data = file_->data(path);
    if (data.extents.sizes.size() != 1) {
      throw InputError(
          {.problem = "must be a list of texts", .value = words_of(data.extents.sizes)});
    }
    return file_->texts(data);
  });
}

}  // namespace prehend
