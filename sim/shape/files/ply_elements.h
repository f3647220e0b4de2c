// PLY files (Turk 1994, "The PLY Polygon File Format"): the elements that the header declares, and
// the numbers of the body one after another. Meshes and clouds of points are read with it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/shape/files/text_scan.h"

namespace prehend {

struct PlyScalar {
  enum class Kind { unsigned_integer, signed_integer, real };
  Kind kind = Kind::real;
  std::size_t bytes = 4;
};

// One property of an element: a scalar, or a list with a count of type `count` and entries of type
// `value`.
struct PlyProperty {
  std::string name;
  std::optional<PlyScalar> count;
  PlyScalar value;
  int role = -1;  // for readers to set: what it is to them
};

struct PlyElement {
  std::string name;
  long long count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  enum class Encoding { text, little_endian, big_endian };
  Encoding encoding = Encoding::text;
  std::vector<PlyElement> elements;
  std::size_t end = 0;  // offset of the body [bytes]

  // The element of this name; null where there is none.
  const PlyElement* element(std::string_view name) const;
};

// Throws InputError, with the line number, for what is no PLY header, types that are unknown, and
// counts that exceed the bytes.
PlyHeader read_ply_header(std::string_view bytes);

// Whether the header declares a surface: faces or strips of triangles, one or more. Throws
// InputError as read_ply_header.
bool has_ply_surface(std::string_view bytes);

// Reads the scalars of the body one after another, in any encoding. Every scalar is returned as a
// double, which holds all 32-bit integers exactly. In text, values are words, and line breaks
// between them have no meaning. Bytes and header must outlive it.
class PlyBody {
 public:
  PlyBody(std::string_view bytes, const PlyHeader& header);

  // Throws InputError where the body ends, or has no number there.
  double next(const PlyScalar& scalar, const PlyElement& element);
  // The length of a list, which comes first: at most 1,000,000.
  int next_length(const PlyProperty& property, const PlyElement& element);

  [[noreturn]] void fail(const std::string& what) const;

 private:
  [[noreturn]] void too_short(const PlyElement& element) const;
  double next_word(const PlyElement& element);
  double next_binary(const PlyScalar& scalar, const PlyElement& element);

  std::string_view bytes_;
  TextScan text_;
  const PlyHeader& header_;
  std::size_t at_;
};

}  // namespace prehend
