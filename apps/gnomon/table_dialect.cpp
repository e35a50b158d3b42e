#include "apps/gnomon/table_dialect.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace gnomon {
namespace {

constexpr std::array<std::string_view, 9> names = {"x", "y", "z", "nx", "ny", "nz", "ex", "ey", "ez"};
constexpr std::array separators = {',', ';', '\t', ' '};
constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view unquoted(std::string_view field) {
  if (field.size() < 2 || field.front() != '"' || field.back() != '"') return field;
  return trimmed(field.substr(1, field.size() - 2));
}

/// Runs of blanks outside of quotes separate.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    std::size_t length = 0;
    for (bool quoted = false; length < line.size(); ++length) {
      if (line[length] == '"') quoted = !quoted;
      if (!quoted && blanks.find(line[length]) != std::string_view::npos) break;
    }
    words.push_back(line.substr(0, length));
    line.remove_prefix(length);
  }
  return words;
}

bool is_called(std::string_view field, std::string_view name) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(unquoted(field), name, {}, lower);
}

/// The one field of that name; nothing if there is none or several.
std::optional<std::size_t> column_of(const std::vector<std::string_view>& fields, std::string_view name) {
  const auto called = [&](std::string_view field) { return is_called(field, name); };
  const auto found = std::ranges::find_if(fields, called);
  if (found == fields.end() || std::ranges::count_if(fields, called) > 1) return std::nullopt;
  return static_cast<std::size_t>(found - fields.begin());
}

bool names_any_normal(const std::vector<std::string_view>& fields) {
  return std::ranges::any_of(fields, [](std::string_view field) {
    return std::any_of(names.begin() + 3, names.begin() + 6,
                       [&](std::string_view name) { return is_called(field, name); });
  });
}

/// How many numbers a row of these columns holds; nothing if it cannot be of that kind.
std::optional<std::size_t> wanted_numbers(const std::vector<std::string_view>& fields, TableColumns columns) {
  switch (columns) {
    case TableColumns::planar_points:
      return column_of(fields, "z") ? std::nullopt : std::optional<std::size_t>(2);
    case TableColumns::points:
      return 3;
    case TableColumns::points_with_normals:
      return 6;
    case TableColumns::views:
      return 9;
    case TableColumns::points_perhaps_with_normals:
      break;
  }
  return names_any_normal(fields) ? 6 : 3;
}

std::optional<TableDialect> dialect_of_names(std::string_view line, char separator, TableColumns columns) {
  const std::vector<std::string_view> fields = table_fields(line, separator);
  const std::optional<std::size_t> wanted = wanted_numbers(fields, columns);
  if (!wanted) return std::nullopt;
  TableDialect dialect{separator, fields.size(), {}};
  for (std::size_t i = 0; i < *wanted; ++i) {
    const std::optional<std::size_t> column = column_of(fields, names[i]);
    if (!column) return std::nullopt;
    dialect.numbers.push_back(*column);
  }
  return dialect;
}

/// How many of the numbers of a row without header are read; 0 if it has too many or too few.
std::size_t numbers_read(std::size_t fields, TableColumns columns) {
  if (columns == TableColumns::planar_points) return fields == 2 ? 2 : 0;
  if (columns == TableColumns::views) return fields == 9 ? 9 : 0;
  if (fields != 3 && fields != 6) return 0;
  if (columns == TableColumns::points) return 3;
  if (columns == TableColumns::points_with_normals) return fields == 6 ? 6 : 0;
  return fields;
}

}  // namespace

std::vector<std::string_view> table_fields(std::string_view line, char separator) {
  if (separator == ' ') return words_of(line);
  std::vector<std::string_view> fields;
  std::size_t start = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (line[i] != separator || quoted)) continue;
    fields.push_back(trimmed(line.substr(start, i - start)));
    start = i + 1;
  }
  return fields;
}

std::optional<TableDialect> dialect_of_header(std::string_view line, TableColumns columns) {
  for (const char separator : separators) {
    if (auto dialect = dialect_of_names(line, separator, columns)) return dialect;
  }
  return std::nullopt;
}

std::optional<TableDialect> dialect_of_numbers(std::string_view line, TableColumns columns) {
  for (const char separator : separators) {
    const std::vector<std::string_view> fields = table_fields(line, separator);
    const std::size_t read = numbers_read(fields.size(), columns);
    const auto is_number = [](std::string_view field) { return number_in_field(field).has_value(); };
    if (read == 0 || !std::ranges::all_of(fields, is_number)) continue;
    TableDialect dialect{separator, fields.size(), {}};
    for (std::size_t i = 0; i < read; ++i) dialect.numbers.push_back(i);
    return dialect;
  }
  return std::nullopt;
}

std::optional<double> number_in_field(std::string_view field) {
  std::string_view text = unquoted(field);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) return std::nullopt;
  // Out of range means too small as well as too large.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool has_decimal_comma(std::string_view field) {
  std::string text(field);
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return false;
  text[comma] = '.';
  return number_in_field(text).has_value();
}

std::string column_names(std::size_t count) {
  std::string list;
  for (std::size_t i = 0; i < count; ++i) list += (list.empty() ? "" : ",") + std::string(names[i]);
  return list;
}

std::string_view column_name(std::size_t index) {
  return names[index];
}

}  // namespace gnomon
