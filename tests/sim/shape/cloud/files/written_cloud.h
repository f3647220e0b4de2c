// Clouds as files, written here in every encoding.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "sim/shape/cloud/files/point_cloud.h"

namespace prehend::test {

// A column of a file: its name, type (as in PCD) and size, and a value for each point.
struct Column {
  std::string name;
  char type = 'F';
  int size = 4;
  std::vector<double> values;
};

template <typename Value>
void append_as(double value, bool big_endian, std::string& bytes) {
  const auto typed = static_cast<Value>(value);
  char raw[sizeof(Value)];
  std::memcpy(raw, &typed, sizeof(Value));
  if (big_endian != (std::endian::native == std::endian::big)) {
    for (std::size_t i = sizeof(Value); i-- > 0;) bytes.push_back(raw[i]);
  } else {
    bytes.append(raw, sizeof(Value));
  }
}

inline void append(const Column& column, double value, bool big_endian, std::string& bytes) {
  const std::string type = column.type + std::to_string(column.size);
  if (type == "F4") append_as<float>(value, big_endian, bytes);
  if (type == "F8") append_as<double>(value, big_endian, bytes);
  if (type == "I1") append_as<std::int8_t>(value, big_endian, bytes);
  if (type == "I2") append_as<std::int16_t>(value, big_endian, bytes);
  if (type == "I4") append_as<std::int32_t>(value, big_endian, bytes);
  if (type == "I8") append_as<std::int64_t>(value, big_endian, bytes);
  if (type == "U1") append_as<std::uint8_t>(value, big_endian, bytes);
  if (type == "U2") append_as<std::uint16_t>(value, big_endian, bytes);
  if (type == "U4") append_as<std::uint32_t>(value, big_endian, bytes);
  if (type == "U8") append_as<std::uint64_t>(value, big_endian, bytes);
}

// LZF: repeats of three bytes or more are taken from where the same three bytes stood last.
inline std::string compressed_lzf(std::string_view bytes) {
  std::string out;
  std::string literal;
  const auto flush = [&] {
    for (std::size_t i = 0; i < literal.size(); i += 32) {
      const std::string part = literal.substr(i, 32);
      out.push_back(static_cast<char>(part.size() - 1));
      out += part;
    }
    literal.clear();
  };
  std::map<std::string_view, std::size_t> last;
  for (std::size_t i = 0; i < bytes.size();) {
    std::size_t length = 0;
    std::size_t back = 0;
    if (i + 3 <= bytes.size()) {
      const auto known = last.find(bytes.substr(i, 3));
      if (known != last.end() && i - known->second <= 8192) {
        back = i - known->second;
        while (i + length < bytes.size() && length < 264 &&
               bytes[known->second + length] == bytes[i + length]) {
          ++length;
        }
      }
      last[bytes.substr(i, 3)] = i;
    }
    if (length < 3) {
      literal.push_back(bytes[i++]);
      continue;
    }
    flush();
    const std::size_t code = length - 2;
    const std::size_t high = (back - 1) >> 8U;
    out.push_back(static_cast<char>((code < 7 ? code : 7) << 5U | high));
    if (code >= 7) out.push_back(static_cast<char>(code - 7));
    out.push_back(static_cast<char>((back - 1) & 255U));
    i += length;
  }
  flush();
  return out;
}

inline std::size_t count_of(const std::vector<Column>& columns) {
  return columns.front().values.size();
}

// `data`: ascii, binary or binary_compressed. `width` 0: not organised.
inline std::string pcd_file(const std::vector<Column>& columns, const std::string& data,
                            std::size_t width = 0, const std::string& viewpoint = "0 0 0 1 0 0 0") {
  const std::size_t count = count_of(columns);
  if (width == 0) width = count;
  std::ostringstream head;
  head << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS";
  for (const Column& column : columns) head << " " << column.name;
  head << "\nSIZE";
  for (const Column& column : columns) head << " " << column.size;
  head << "\nTYPE";
  for (const Column& column : columns) head << " " << column.type;
  head << "\nCOUNT";
  for (std::size_t i = 0; i < columns.size(); ++i) head << " 1";
  head << "\nWIDTH " << width << "\nHEIGHT " << count / width << "\nVIEWPOINT " << viewpoint
       << "\nPOINTS " << count << "\nDATA " << data << "\n";
  std::string body;
  if (data == "ascii") {
    std::ostringstream text;
    text.precision(9);
    for (std::size_t i = 0; i < count; ++i) {
      for (const Column& column : columns) text << column.values[i] << " ";
      text << "\n";
    }
    body = text.str();
  } else if (data == "binary") {
    for (std::size_t i = 0; i < count; ++i) {
      for (const Column& column : columns) append(column, column.values[i], false, body);
    }
  } else {
    std::string plain;
    for (const Column& column : columns) {
      if (column.name == "_") continue;
      for (const double value : column.values) append(column, value, false, plain);
    }
    const std::string packed = compressed_lzf(plain);
    append_as<std::uint32_t>(static_cast<double>(packed.size()), false, body);
    append_as<std::uint32_t>(static_cast<double>(plain.size()), false, body);
    body += packed;
  }
  return head.str() + body;
}

// `format`: ascii, binary_little_endian or binary_big_endian.
inline std::string ply_file(const std::vector<Column>& columns, const std::string& format) {
  const std::map<std::string, std::string> types = {
      {"F4", "float"}, {"F8", "double"}, {"I1", "char"},   {"I2", "short"},
      {"I4", "int"},   {"U1", "uchar"},  {"U2", "ushort"}, {"U4", "uint"}};
  std::ostringstream text;
  text.precision(9);
  text << "ply\nformat " << format << " 1.0\ncomment made for a test\nelement vertex "
       << count_of(columns) << "\n";
  for (const Column& column : columns) {
    text << "property " << types.at(column.type + std::to_string(column.size)) << " " << column.name
         << "\n";
  }
  text << "element face 0\nproperty list uchar int vertex_indices\nend_header\n";
  std::string body;
  for (std::size_t i = 0; i < count_of(columns); ++i) {
    for (const Column& column : columns) {
      if (format == "ascii") {
        text << column.values[i] << " ";
      } else {
        append(column, column.values[i], format == "binary_big_endian", body);
      }
    }
    if (format == "ascii") text << "\n";
  }
  return text.str() + body;
}

// x, y and z of points as columns.
inline std::vector<Column> columns_of(const std::vector<Vector3>& points) {
  std::vector<Column> columns = {{"x", 'F', 4, {}}, {"y", 'F', 4, {}}, {"z", 'F', 4, {}}};
  for (const Vector3& p : points) {
    for (int k = 0; k < 3; ++k) columns[static_cast<std::size_t>(k)].values.push_back(p[k]);
  }
  return columns;
}

}  // namespace prehend::test
