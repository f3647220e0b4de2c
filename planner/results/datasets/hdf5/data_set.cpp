#include "planner/results/datasets/hdf5/data_set.h"

#include <array>

namespace prehend::hdf5 {
namespace {

constexpr std::uint64_t kMostExtents = 32;
constexpr std::size_t kMostFilters = 8;

Bytes needed(const Messages& header, MessageType type) {
  const Message* message = find(header, type);
  if (message == nullptr) throw damaged("part of its description is missing");
  return message->data;
}

ValueType whole_type(ByteCursor& cursor, std::uint64_t bits, std::size_t size) {
  const bool plain = cursor.number(2) == 0 && cursor.number(2) == 8 * size;
  if (!plain || size == 0 || size > 8) return {};
  return {ValueKind::whole, size, (bits & 1U) != 0, (bits & 8U) != 0};
}

// Only IEEE's own: sign, exponent and mantissa follow each other, the leading 1 is not stored.
ValueType real_type(ByteCursor& cursor, std::uint64_t bits, std::size_t size) {
  struct Form {
    std::size_t size;
    std::array<std::uint64_t, 7>
        numbers;  // offset, bits, exponent and mantissa (place, size), bias
  };
  constexpr std::array<Form, 3> kForms = {{{2, {0, 16, 10, 5, 0, 10, 15}},
                                           {4, {0, 32, 23, 8, 0, 23, 127}},
                                           {8, {0, 64, 52, 11, 0, 52, 1023}}}};
  std::array<std::uint64_t, 7> found{};
  constexpr std::array<std::size_t, 7> kWidths = {2, 2, 1, 1, 1, 1, 4};
  for (std::size_t i = 0; i < found.size(); ++i) found.at(i) = cursor.number(kWidths.at(i));
  const bool implied = (bits >> 4U & 3U) == 2;
  const bool vax = (bits & 0x40U) != 0;
  const std::uint64_t sign = bits >> 8U & 0xffU;
  for (const Form& form : kForms) {
    if (form.size == size && form.numbers == found && implied && !vax && sign == 8 * size - 1) {
      return {ValueKind::real, size, (bits & 1U) != 0, true};
    }
  }
  return {};
}

struct TypeHead {
  std::uint64_t kind = 0;
  std::uint64_t bits = 0;
  std::size_t size = 0;
};

TypeHead type_head(ByteCursor& cursor) {
  const std::uint64_t kind = cursor.number(1) & 0xfU;
  const std::uint64_t bits = cursor.number(3);
  return {kind, bits, cursor.number(4)};
}

ValueType type_of(const Image& image, Bytes message) {
  enum : std::uint64_t { whole = 0, real = 1, text = 3, enumeration = 8, sequence = 9 };
  ByteCursor cursor(message);
  const auto [kind, bits, size] = type_head(cursor);
  if (kind == whole) return whole_type(cursor, bits, size);
  if (kind == real) return real_type(cursor, bits, size);
  if (kind == text) {
    constexpr std::uint64_t kBlanks = 2;
    return {.kind = ValueKind::fixed_text, .size = size, .blanks = (bits & 0xfU) == kBlanks};
  }
  if (kind == enumeration) {
    const TypeHead base = type_head(cursor);
    if (base.kind != whole) return {};
    ValueType type = whole_type(cursor, base.bits, base.size);
    if (type.size != 1 || size != 1) return {};
    type.kind = ValueKind::flag;
    return type;
  }
  constexpr std::uint64_t kOfTexts = 1;
  if (kind == sequence && (bits & 0xfU) == kOfTexts && size == 8 + image.offset_size) {
    return {.kind = ValueKind::any_text, .size = size};
  }
  return {};
}

Bytes fill_of(const Messages& header, std::size_t size) {
  const Message* message = find(header, MessageType::fill_value);
  const Message* old = find(header, MessageType::old_fill_value);
  if (message == nullptr && old == nullptr) return {};
  ByteCursor cursor((message != nullptr ? message : old)->data);
  bool stored = true;
  if (message != nullptr) {
    const std::uint64_t version = cursor.number(1);
    if (version > 3) throw damaged("a fill value of a version that is not known");
    if (version == 3) {
      stored = (cursor.number(1) & 0x20U) != 0;
    } else {
      cursor.skip(2);
      stored = cursor.number(1) != 0 || version == 1;
    }
  }
  if (!stored) return {};
  const std::uint64_t length = cursor.number(4);
  // Negative: not known.
  if (length == 0 || length == 0xffffffffU) return {};
  if (length != size) throw damaged("a fill value of another size");
  return cursor.take(length);
}

std::vector<Filter> filters_of(const Messages& header) {
  const Message* message = find(header, MessageType::filters);
  std::vector<Filter> filters;
  if (message == nullptr) return filters;
  ByteCursor cursor(message->data);
  const std::uint64_t version = cursor.number(1);
  if (version != 1 && version != 2) throw damaged("filters of a version that is not known");
  const std::uint64_t count = cursor.number(1);
  if (count > kMostFilters) throw damaged("too many filters");
  if (version == 1) cursor.skip(6);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t type = cursor.number(2);
    if (type < 1 || type > 3) {
      throw not_read("is stored with a filter that is not read, number " + std::to_string(type),
                     "h5repack -f GZIP=6 OLD NEW writes a file that is");
    }
    std::uint64_t name = version == 1 ? cursor.number(2) : 0;
    cursor.skip(2);
    const std::uint64_t values = cursor.number(2);
    cursor.skip((name + 7) / 8 * 8);
    Filter& filter = filters.emplace_back();
    filter.type = static_cast<FilterType>(type);
    for (std::uint64_t v = 0; v < values; ++v) {
      const std::uint64_t value = cursor.number(4);
      if (v == 0) filter.value = value;
    }
    if (version == 1 && values % 2 == 1) cursor.skip(4);
  }
  return filters;
}

void read_chunks(const Image& image, ByteCursor& cursor, bool version_4, std::size_t rank,
                 std::size_t value_size, Layout& layout) {
  const std::uint64_t flags = version_4 ? cursor.number(1) : 0;
  if (cursor.number(1) != rank + 1) throw damaged("chunks of another number of extents");
  if (!version_4) layout.address = image.address(cursor);
  const std::uint64_t width = version_4 ? cursor.number(1) : 4;
  if (width < 1 || width > 8) throw damaged("chunks of no size");
  for (std::size_t i = 0; i < rank; ++i) layout.chunk.push_back(cursor.number(width));
  if (cursor.number(width) != value_size) throw damaged("chunks of values of another size");
  if (!version_4) return;
  const std::uint64_t index = cursor.number(1);
  layout.whole_edges = (flags & 1U) != 0;
  layout.index = static_cast<ChunkIndex>(index);
  switch (layout.index) {
    case ChunkIndex::single:
      layout.single_filtered = (flags & 2U) != 0;
      if (layout.single_filtered) {
        layout.single_size = image.length(cursor);
        layout.single_mask = cursor.number(4);
      }
      break;
    case ChunkIndex::implicit:
      break;
    case ChunkIndex::fixed_array:
      cursor.skip(1);
      break;
    case ChunkIndex::extensible_array:
      cursor.skip(5);
      break;
    case ChunkIndex::tree2:
      cursor.skip(6);
      break;
    default:
      throw damaged("an index of chunks that is not known");
  }
  layout.address = image.address(cursor);
}

Layout layout_of(const Image& image, Bytes message, std::size_t rank, std::size_t value_size) {
  ByteCursor cursor(message);
  const std::uint64_t version = cursor.number(1);
  if (version < 3 || version > 4) {
    throw not_read("is stored with version " + std::to_string(version) +
                       " of HDF5's layouts, which is not read",
                   "h5repack --high=2 OLD NEW writes a file that is");
  }
  Layout layout;
  switch (cursor.number(1)) {
    case 0:
      layout.kind = Layout::Kind::compact;
      layout.compact = cursor.take(cursor.number(2));
      break;
    case 1:
      layout.address = image.address(cursor);
      break;
    case 2:
      layout.kind = Layout::Kind::chunked;
      read_chunks(image, cursor, version == 4, rank, value_size, layout);
      break;
    case 3:
      throw not_read("must not be stored in other files",
                     "h5repack -l CONTI OLD NEW puts it into one");
    default:
      throw damaged("a layout that is not known");
  }
  return layout;
}

}  // namespace

bool is_data_set(const Messages& header) {
  return find(header, MessageType::dataspace) != nullptr &&
         find(header, MessageType::layout) != nullptr;
}

Extents extents_of(const Image& image, const Messages& header) {
  ByteCursor cursor(needed(header, MessageType::dataspace));
  const std::uint64_t version = cursor.number(1);
  if (version != 1 && version != 2) throw damaged("extents of a version that is not known");
  const std::uint64_t rank = cursor.number(1);
  const std::uint64_t flags = cursor.number(1);
  const std::uint64_t kind = cursor.number(1);
  if (version == 1) cursor.skip(4);
  if (rank > kMostExtents) throw damaged("too many extents");
  Extents extents;
  constexpr std::uint64_t kNone = 2;
  extents.none = version == 2 && kind == kNone;
  for (std::uint64_t i = 0; i < rank; ++i) extents.sizes.push_back(image.length(cursor));
  extents.most = extents.sizes;
  if ((flags & 1U) == 0) return extents;
  for (std::size_t& most : extents.most) {
    const std::uint64_t value = image.length(cursor);
    most = value == kNowhere >> (64 - 8 * image.length_size) ? kNowhere : value;
  }
  for (std::size_t i = 0; i < rank; ++i) {
    if (extents.most[i] < extents.sizes[i]) throw damaged("extents above the largest ones");
  }
  return extents;
}

DataSet data_set_of(const Image& image, const Messages& header) {
  if (find(header, MessageType::external_files) != nullptr) {
    throw not_read("must not be stored in other files",
                   "h5repack -l CONTI OLD NEW puts it into one");
  }
  DataSet data;
  data.type = type_of(image, needed(header, MessageType::datatype));
  data.extents = extents_of(image, header);
  // What has another type is refused by those who ask for its values.
  if (data.type.kind == ValueKind::other) return data;
  data.layout = layout_of(image, needed(header, MessageType::layout), data.extents.sizes.size(),
                          data.type.size);
  data.filters = filters_of(header);
  data.fill = fill_of(header, data.type.size);
  return data;
}

}  // namespace prehend::hdf5
