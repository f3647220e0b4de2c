#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/range.h"
#include "sim/shape/cloud/files/lzf.h"
#include "sim/shape/cloud/files/point_cloud.h"
#include "sim/shape/files/text_scan.h"

namespace prehend {
namespace {

constexpr std::size_t kMostFields = 1000;
constexpr std::size_t kMostBytes = 100'000;  // of a point

// One field of a point: `count` values of `size` bytes.
struct PcdField {
  std::string name;
  std::size_t size = 4;
  char type = 'F';  // F, I or U
  std::size_t count = 1;
  int role = -1;  // the place of a coordinate among kPcdCoordinates

  std::size_t bytes() const { return size * count; }
  bool is_padding() const { return name == "_"; }
};

constexpr std::array<std::string_view, 6> kPcdCoordinates = {"x",        "y",        "z",
                                                             "normal_x", "normal_y", "normal_z"};

struct PcdHeader {
  std::vector<PcdField> fields;
  std::size_t width = 0;
  std::size_t height = 1;
  std::size_t points = 0;
  std::optional<Pose> X_FV = {};
  std::string data;
  bool has_normals = false;

  std::size_t point_bytes() const {
    std::size_t sum = 0;
    for (const PcdField& field : fields) sum += field.bytes();
    return sum;
  }
};

std::size_t count_in(TextScan& scan, long long most) {
  const std::string_view word = scan.next_word();
  const std::optional<long long> count = integer_in(word);
  if (!count || *count < 0 || *count > most) scan.fail("not a count (" + in_quotes(word) + ")");
  return static_cast<std::size_t>(*count);
}

// One value for each field.
void need_fields(const TextScan& scan, const PcdHeader& header, std::string_view of) {
  if (header.fields.empty()) scan.fail("FIELDS must come before " + std::string(of));
}

void read_fields(TextScan& scan, PcdHeader& header) {
  header.fields.clear();
  for (std::string_view name = scan.next_word(); !name.empty(); name = scan.next_word()) {
    if (header.fields.size() == kMostFields) scan.fail("more than 1000 fields");
    PcdField field{.name = std::string(name)};
    const auto known = std::find(kPcdCoordinates.begin(), kPcdCoordinates.end(), name);
    if (known != kPcdCoordinates.end())
      field.role = static_cast<int>(known - kPcdCoordinates.begin());
    header.fields.push_back(std::move(field));
  }
}

void read_sizes(TextScan& scan, PcdHeader& header) {
  need_fields(scan, header, "SIZE");
  for (PcdField& field : header.fields) {
    field.size = count_in(scan, 8);
    if (!std::has_single_bit(field.size)) scan.fail("a SIZE must be 1, 2, 4 or 8");
  }
}

void read_types(TextScan& scan, PcdHeader& header) {
  need_fields(scan, header, "TYPE");
  for (PcdField& field : header.fields) {
    const std::string_view word = scan.next_word();
    if (word != "F" && word != "I" && word != "U") {
      scan.fail("a TYPE must be F, I or U (" + in_quotes(word) + ")");
    }
    field.type = word.front();
  }
}

void read_counts(TextScan& scan, PcdHeader& header) {
  need_fields(scan, header, "COUNT");
  for (PcdField& field : header.fields) field.count = count_in(scan, kMostBytes);
}

void read_viewpoint(TextScan& scan, PcdHeader& header) {
  std::array<double, 7> values{};
  for (double& value : values) {
    const std::string_view word = scan.next_word();
    value = number_in(word).value_or(std::numeric_limits<double>::quiet_NaN());
    if (!(std::abs(value) <= kFarthest)) {
      scan.fail("VIEWPOINT must be 7 numbers (" + in_quotes(word) + ")");
    }
  }
  const Eigen::Quaterniond turn(values[3], values[4], values[5], values[6]);
  constexpr double kUnit = 1e-3;
  if (std::abs(turn.norm() - 1.0) > kUnit) scan.fail("the quaternion of VIEWPOINT is not unit");
  header.X_FV = Pose::Identity();
  header.X_FV->linear() = turn.normalized().toRotationMatrix();
  header.X_FV->translation() = Vector3(values[0], values[1], values[2]);
}

// One line of the header; other words than these are passed over.
void read_line(TextScan& scan, std::string_view word, PcdHeader& header) {
  constexpr long long kMost = std::numeric_limits<std::uint32_t>::max();
  if (word == "FIELDS" || word == "COLUMNS") read_fields(scan, header);
  if (word == "SIZE") read_sizes(scan, header);
  if (word == "TYPE") read_types(scan, header);
  if (word == "COUNT") read_counts(scan, header);
  if (word == "WIDTH") header.width = count_in(scan, kMost);
  if (word == "HEIGHT") header.height = count_in(scan, kMost);
  if (word == "POINTS") header.points = count_in(scan, kMost);
  if (word == "VIEWPOINT") read_viewpoint(scan, header);
  if (word == "DATA") header.data = scan.next_word();
}

void check_header(PcdHeader& header) {
  std::array<int, 6> found{};
  for (const PcdField& field : header.fields) {
    if (field.role < 0) continue;
    if (field.count != 1) throw InputError("field " + field.name + " must have the COUNT 1");
    if (field.type == 'F' && field.size < 4) {
      throw InputError("field " + field.name + ": a number of type F has 4 or 8 bytes");
    }
    ++found[static_cast<std::size_t>(field.role)];
  }
  for (std::size_t c = 0; c < found.size(); ++c) {
    if (found[c] > 1 || (c < 3 && found[c] == 0)) {
      throw InputError("FIELDS must have one x, one y and one z, and a normal at most");
    }
  }
  header.has_normals = found[3] + found[4] + found[5] == 3;
  require_few(header.points, "points");
  if (header.width != 0 && header.width * header.height != header.points) {
    throw InputError(formatted("WIDTH x HEIGHT are %zu x %zu, POINTS %zu", header.width,
                               header.height, header.points));
  }
  if (header.point_bytes() > kMostBytes) throw InputError("a point has more than 100,000 bytes");
}

PcdHeader read_header(TextScan& scan) {
  PcdHeader header;
  while (header.data.empty()) {
    if (!scan.next_line()) throw InputError("no PCD file: no line DATA ends its header");
    const std::string_view word = scan.next_word();
    if (word.empty() || word.front() == '#') continue;
    // A file of another kind is refused before it is searched for DATA.
    constexpr int kMostLines = 1000;
    if (scan.line_number() > kMostLines) throw InputError("no PCD file: its header does not end");
    read_line(scan, word, header);
  }
  check_header(header);
  return header;
}

template <typename Value>
double decoded(const char* data) {
  std::array<char, sizeof(Value)> raw;
  constexpr bool kSwap = std::endian::native == std::endian::big;
  for (std::size_t i = 0; i < raw.size(); ++i) raw[i] = data[kSwap ? raw.size() - 1 - i : i];
  return static_cast<double>(std::bit_cast<Value>(raw));
}

double decoded(const PcdField& field, const char* data) {
  if (field.type == 'F') return field.size == 4 ? decoded<float>(data) : decoded<double>(data);
  const bool is_signed = field.type == 'I';
  switch (field.size) {
    case 1:
      return is_signed ? decoded<std::int8_t>(data) : decoded<std::uint8_t>(data);
    case 2:
      return is_signed ? decoded<std::int16_t>(data) : decoded<std::uint16_t>(data);
    case 4:
      return is_signed ? decoded<std::int32_t>(data) : decoded<std::uint32_t>(data);
    default:
      return is_signed ? decoded<std::int64_t>(data) : decoded<std::uint64_t>(data);
  }
}

void resize(const PcdHeader& header, PointCloud& cloud) {
  cloud.points.assign(header.points, Eigen::Vector3f::Zero());
  if (header.has_normals) cloud.normals.assign(header.points, Eigen::Vector3f::Zero());
}

void set(PointCloud& cloud, std::size_t point, int role, double value) {
  if (role < 3) {
    cloud.points[point][role] = in_single(value);
  } else if (!cloud.normals.empty()) {
    cloud.normals[point][role - 3] = in_single(value);
  }
}

// A point a line.
void read_ascii(TextScan& scan, const PcdHeader& header, PointCloud& cloud) {
  cloud.points.reserve(header.points);
  while (cloud.points.size() < header.points) {
    if (!scan.next_line()) {
      throw InputError(
          formatted("the file ends after %zu of %zu points", cloud.points.size(), header.points));
    }
    std::string_view word = scan.next_word();
    if (word.empty()) continue;
    cloud.points.emplace_back(Eigen::Vector3f::Zero());
    if (header.has_normals) cloud.normals.emplace_back(Eigen::Vector3f::Zero());
    for (const PcdField& field : header.fields) {
      for (std::size_t i = 0; i < field.count; ++i) {
        const std::optional<double> value = number_in(word);
        if (!value && field.role >= 0) scan.fail("not a number (" + in_quotes(word) + ")");
        if (field.role >= 0) set(cloud, cloud.points.size() - 1, field.role, *value);
        word = scan.next_word();
      }
    }
  }
}

// All of a point together, one after the other.
void read_binary(std::string_view data, const PcdHeader& header, PointCloud& cloud) {
  const std::size_t stride = header.point_bytes();
  if (data.size() / stride < header.points) {
    throw InputError(
        formatted("the file ends after %zu of %zu points", data.size() / stride, header.points));
  }
  resize(header, cloud);
  std::size_t offset = 0;
  for (const PcdField& field : header.fields) {
    for (std::size_t i = 0; field.role >= 0 && i < header.points; ++i) {
      set(cloud, i, field.role, decoded(field, data.data() + i * stride + offset));
    }
    offset += field.bytes();
  }
}

// Each field of all points together. The Point Cloud Library writes no padding here.
void read_by_field(std::string_view data, bool with_padding, const PcdHeader& header,
                   PointCloud& cloud) {
  resize(header, cloud);
  std::size_t offset = 0;
  for (const PcdField& field : header.fields) {
    if (field.is_padding() && !with_padding) continue;
    for (std::size_t i = 0; field.role >= 0 && i < header.points; ++i) {
      set(cloud, i, field.role, decoded(field, data.data() + offset + i * field.bytes()));
    }
    offset += field.bytes() * header.points;
  }
}

void read_compressed(std::string_view data, const PcdHeader& header, PointCloud& cloud) {
  constexpr std::size_t kSizes = 8;
  if (data.size() < kSizes) throw InputError("the file ends before its compressed points");
  const auto packed = static_cast<std::size_t>(decoded<std::uint32_t>(data.data()));
  const auto size = static_cast<std::size_t>(decoded<std::uint32_t>(data.data() + 4));
  if (packed > data.size() - kSizes) throw InputError("the file ends inside its compressed points");
  const std::size_t whole = header.point_bytes() * header.points;
  std::size_t bare = whole;
  for (const PcdField& field : header.fields) {
    if (field.is_padding()) bare -= field.bytes() * header.points;
  }
  if ((size != whole && size != bare) || size > kLargestInputFile) {
    throw InputError(formatted("the compressed points have %zu bytes, not %zu", size, bare));
  }
  read_by_field(decompressed_lzf(data.substr(kSizes, packed), size), size != bare, header, cloud);
}

}  // namespace

PointCloud read_pcd(std::string_view bytes) {
  TextScan scan(bytes);
  const PcdHeader header = read_header(scan);
  PointCloud cloud;
  cloud.X_FV = header.X_FV;
  if (header.data == "ascii") {
    read_ascii(scan, header, cloud);
  } else if (header.data == "binary") {
    read_binary(bytes.substr(scan.position()), header, cloud);
  } else if (header.data == "binary_compressed") {
    read_compressed(bytes.substr(scan.position()), header, cloud);
  } else {
    scan.fail("DATA must be ascii, binary or binary_compressed (" + in_quotes(header.data) + ")");
  }
  const bool is_grid = header.width > 0 && header.height > 1;
  cloud.width = is_grid ? header.width : header.points;
  cloud.height = is_grid ? header.height : 1;
  return cloud;
}

}  // namespace prehend
