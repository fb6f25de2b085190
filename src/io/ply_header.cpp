#include "ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "text_cursor.hpp"

namespace verdigris::io {

namespace {

constexpr char remedy_header[] =
    "the header should be 'ply', 'format ...', 'element' and 'property' lines, 'end_header': export the "
    "model again";
constexpr char remedy_rows[] = "the file may have been cut off: export or download it again";

std::optional<PlyType> type_named(std::string_view name) {
  struct Named {
    std::string_view name;
    PlyType type;
  };
  static constexpr std::array names{Named{"char", PlyType::int8},      Named{"int8", PlyType::int8},
                                    Named{"uchar", PlyType::uint8},    Named{"uint8", PlyType::uint8},
                                    Named{"short", PlyType::int16},    Named{"int16", PlyType::int16},
                                    Named{"ushort", PlyType::uint16},  Named{"uint16", PlyType::uint16},
                                    Named{"int", PlyType::int32},      Named{"int32", PlyType::int32},
                                    Named{"uint", PlyType::uint32},    Named{"uint32", PlyType::uint32},
                                    Named{"float", PlyType::float32},  Named{"float32", PlyType::float32},
                                    Named{"double", PlyType::float64}, Named{"float64", PlyType::float64}};
  for (const Named& n : names)
    if (n.name == name) return n.type;
  return std::nullopt;
}

PlyType type_or_stop(std::string_view word, std::size_t offset, Faults& faults) {
  const std::optional<PlyType> type = type_named(word);
  if (!type) faults.stop(offset, fmt::format("{} is not a type of PLY", in_quotes(word)), remedy_header);
  return *type;
}

PlyFormat read_format(TextCursor& cursor, Faults& faults) {
  const std::string_view word = cursor.word();
  if (word == "ascii") return PlyFormat::text;
  if (word == "binary_little_endian") return PlyFormat::little_endian;
  if (word == "binary_big_endian") return PlyFormat::big_endian;
  faults.stop(cursor.word_offset(), fmt::format("{} is not a format of PLY", in_quotes(word)), remedy_header);
}

PlyElement read_element(TextCursor& cursor, Faults& faults) {
  PlyElement element;
  element.name = cursor.word();
  element.offset = cursor.word_offset();
  const std::string_view word = cursor.word();
  const auto rows = parse_integer(word);
  if (element.name.empty() || !rows || *rows < 0)
    faults.stop(cursor.word_offset(),
                fmt::format("the number of rows {} of an element is malformed", in_quotes(word)),
                remedy_header);
  element.rows = static_cast<std::size_t>(*rows);
  return element;
}

PlyProperty read_property(TextCursor& cursor, Faults& faults) {
  PlyProperty property;
  std::string_view word = cursor.word();
  if (word == "list") {
    property.list = true;
    word = cursor.word();
    property.count_type = type_or_stop(word, cursor.word_offset(), faults);
    if (property.count_type >= PlyType::float32)
      faults.stop(cursor.word_offset(), "a list's length is announced as a fraction", remedy_header);
    word = cursor.word();
  }
  property.type = type_or_stop(word, cursor.word_offset(), faults);
  property.name = cursor.word();
  if (property.name.empty()) faults.stop(cursor.word_offset(), "a property without a name", remedy_header);
  return property;
}

/// Least bytes that a row of `element` takes.
std::size_t least_bytes(const PlyElement& element, PlyFormat format) {
  std::size_t bytes = 0;
  for (const PlyProperty& p : element.properties)
    bytes += format == PlyFormat::text ? 2 : size_of(p.list ? p.count_type : p.type);
  return bytes;
}

void check_rows(const PlyHeader& header, Faults& faults) {
  std::size_t left = faults.text().size() - header.size + 1;  // a text's last line end may be missing
  for (const PlyElement& element : header.elements) {
    const std::size_t row = least_bytes(element, header.format);
    if (row == 0 && element.rows > 0)
      faults.stop(element.offset, fmt::format("element {} has no properties", in_quotes(element.name)),
                  remedy_header);
    if (element.rows > 0 && element.rows > left / row)
      faults.stop(element.offset,
                  fmt::format("the file is too short for the {} rows of {} it announces", element.rows,
                              in_quotes(element.name)),
                  remedy_rows);
    left -= element.rows * row;
  }
}

}  // namespace

std::size_t size_of(PlyType type) {
  static constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(Faults& faults) {
  const std::string_view text = faults.text();
  TextCursor cursor(text);
  if (cursor.word() != "ply") faults.stop(0, "the file does not begin with 'ply'", remedy_header);
  // With CR line ends the first byte after the header may happen to be LF: how the first line ends decides.
  const bool bare_cr = cursor.offset() < text.size() && text[cursor.offset()] == '\r' &&
                       !text.substr(cursor.offset()).starts_with("\r\n");
  PlyHeader header;
  bool with_format = false;
  for (cursor.next_line();; cursor.next_line()) {
    if (cursor.at_end()) faults.stop(text.size(), "the header has no 'end_header'", remedy_rows);
    const std::string_view word = cursor.word();
    if (word == "end_header") break;
    if (word.empty() || word == "comment" || word == "obj_info") continue;
    if (word == "format") {
      header.format = read_format(cursor, faults);
      with_format = true;
    } else if (word == "element") {
      header.elements.push_back(read_element(cursor, faults));
    } else if (word == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(cursor, faults));
    } else {
      faults.stop(cursor.word_offset(), fmt::format("{} does not belong in a header", in_quotes(word)),
                  remedy_header);
    }
  }
  if (!with_format) faults.stop(0, "the header does not say the format", remedy_header);
  if (bare_cr) {
    cursor.skip_rest();
    header.size = std::min(text.size(), cursor.offset() + 1);
  } else {
    cursor.next_line();
    header.size = cursor.offset();
  }
  check_rows(header, faults);
  return header;
}

}  // namespace verdigris::io
