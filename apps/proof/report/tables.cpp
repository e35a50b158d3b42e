#include "apps/proof/report/tables.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace gnomon::report {
namespace {

std::string csv_cell(const std::string& text) {
  return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

}  // namespace

std::string markdown_table(const std::vector<Row>& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += '|';
    for (const std::string& cell : rows[i]) text += ' ' + cell + " |";
    text += '\n';
    if (i > 0) continue;
    text += "|---|";
    for (std::size_t k = 1; k < rows[0].size(); ++k) text += "--:|";
    text += '\n';
  }
  return text;
}

std::string csv(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) text += (k == 0 ? "" : ",") + csv_cell(row[k]);
    text += '\n';
  }
  return text;
}

std::string short_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), std::fabs(value) >= 100 && std::fabs(value) < 1e6 ? "%.0f" : "%.3g", value);
  return text.data();
}

std::string full_text(double value) {
  std::array<char, 64> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string time_text(double seconds) {
  if (seconds < 1e-6) return short_text(1e9 * seconds) + " ns";
  if (seconds < 1e-3) return short_text(1e6 * seconds) + " µs";
  if (seconds < 1) return short_text(1e3 * seconds) + " ms";
  return short_text(seconds) + " s";
}

std::string counted_text(std::size_t count, const std::string& noun) {
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

std::string bytes_text(std::size_t bytes) {
  return std::to_string(bytes / 1024) + " kB";
}

}  // namespace gnomon::report
