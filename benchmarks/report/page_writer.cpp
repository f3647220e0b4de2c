#include "benchmarks/report/page_writer.h"

#include <array>
#include <cmath>
#include <utility>

#include "sim/base/formatted.h"

namespace prehend::bench {
namespace {

// Three digits, without an exponent for what people read without.
std::string three_digits(double value) {
  const double size = std::abs(value);
  if (size == 0.0) return "0";
  if (size >= 999.5 && size < 1e7) return formatted("%.0f", value);
  return formatted("%.3g", value);
}

// A bar would end the cell.
void append_cell(const std::string& words, std::string& text) {
  for (const char letter : words) {
    if (letter == '|') text += '\\';
    text += letter;
  }
}

std::string row_text(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& words : cells) {
    text += ' ';
    append_cell(words, text);
    text += " |";
  }
  text += '\n';
  return text;
}

}  // namespace

std::string value_text(double value, const std::string& unit) {
  if (!is_time(unit)) {
    const std::string number = three_digits(value);
    if (unit == "1") return number;
    return formatted("%s %s", number.c_str(), unit == "1/s" ? "/s" : unit.c_str());
  }
  const double seconds =
      value * (unit == "ns" ? 1e-9 : (unit == "us" ? 1e-6 : (unit == "ms" ? 1e-3 : 1.0)));
  constexpr std::array<std::pair<double, const char*>, 3> kUnits = {
      {{1.0, " s"}, {1e-3, " ms"}, {1e-6, " µs"}}};
  for (const auto& [factor, name] : kUnits) {
    if (std::abs(seconds) >= 0.9995 * factor) return three_digits(seconds / factor) + name;
  }
  return three_digits(1e9 * seconds) + " ns";
}

void PageWriter::heading(int level, const std::string& words) {
  if (!text_.empty()) text_ += "\n";
  text_.append(static_cast<std::size_t>(level), '#').append(" ").append(words).append("\n");
}

void PageWriter::paragraph(const std::string& words) {
  text_.append("\n").append(words).append("\n");
}

void PageWriter::table(const std::vector<std::string>& headings,
                       const std::vector<std::vector<std::string>>& rows) {
  if (rows.empty()) return;
  text_ += '\n';
  text_ += row_text(headings);
  text_ += '|';
  for (std::size_t i = 0; i < headings.size(); ++i) text_ += i == 0 ? "---|" : "--:|";
  text_ += '\n';
  for (const std::vector<std::string>& row : rows) text_ += row_text(row);
}

void PageWriter::picture(const std::string& name, const std::string& words,
                         const std::string& svg) {
  if (svg.empty()) return;
  const std::string file = name + ".svg";
  text_.append("\n![").append(words).append("](").append(file).append(")\n");
  pictures_.push_back({file, svg});
}

std::vector<PageFile> PageWriter::files() && {
  std::vector<PageFile> files = std::move(pictures_);
  files.push_back({"results.md", std::move(text_)});
  return files;
}

}  // namespace prehend::bench
