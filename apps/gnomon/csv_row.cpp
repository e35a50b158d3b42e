#include "apps/gnomon/csv_row.h"

#include <algorithm>

namespace gnomon {
namespace {

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 && c != '\t';
}

/// The place behind the quote that closes a field which begins with one; nothing if there is none.
std::optional<std::size_t> end_of_quotes(std::string_view row, std::size_t start) {
  for (std::size_t i = start + 1; i < row.size(); ++i) {
    if (row[i] != '"') continue;
    if (i + 1 == row.size() || row[i + 1] != '"') return i + 1;
    ++i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> csv_field_count(std::string_view row) {
  if (std::any_of(row.begin(), row.end(), is_control)) return std::nullopt;
  std::size_t start = 0;
  for (std::size_t count = 1;; ++count) {
    if (start < row.size() && row[start] == '"') {
      const std::optional<std::size_t> end = end_of_quotes(row, start);
      if (!end) return std::nullopt;
      start = *end;
    }
    const std::size_t comma = row.find(',', start);
    if (comma == std::string_view::npos) return count;
    start = comma + 1;
  }
}

}  // namespace gnomon
