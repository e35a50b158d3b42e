#include "apps/gnomon/point_table.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/gnomon/text.h"
#include "geometry/scene/scene_reader.h"

namespace gnomon {
namespace {

constexpr std::size_t longest_line = 1 << 16;
constexpr std::array<std::string_view, 6> column_names = {"x", "y", "z", "nx", "ny", "nz"};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The fields between commas that are not in double quotes, without the spaces around them.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  std::size_t start = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (line[i] != ',' || quoted)) continue;
    fields.push_back(trimmed(line.substr(start, i - start)));
    start = i + 1;
  }
  return fields;
}

/// What was found, fit for a message: control characters and bytes beyond ASCII shown as \xNN, and not too long.
std::string excerpt(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text.substr(0, 40)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      result += c;
    } else {
      result += {'\\', 'x', digits[byte >> 4U], digits[byte & 15U]};
    }
  }
  return result + (text.size() > 40 ? "...\"" : "\"");
}

/// The double nearest to a decimal number; nothing for other text and for what overflows.
std::optional<double> finite_field(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) return std::nullopt;
  // Out of range means too small as well as too large.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::size_t number_count(TableColumns columns) {
  return columns == TableColumns::planar_points ? 2 : columns == TableColumns::points ? 3 : 6;
}

std::string expected_header(std::size_t numbers) {
  std::string header = "\"x";
  for (std::size_t i = 1; i < numbers; ++i) header += ',' + std::string(column_names[i]);
  return header + '"';
}

bool starts_with_names(const std::vector<std::string_view>& fields, std::size_t numbers) {
  if (fields.size() < numbers) return false;
  for (std::size_t i = 0; i < numbers; ++i) {
    if (fields[i] != column_names[i]) return false;
  }
  return true;
}

}  // namespace

PointTable::PointTable(std::istream& stream, std::string name, TableColumns columns)
    : stream_(stream), name_(std::move(name)), numbers_(number_count(columns)) {
  const std::string expected = ", expected the header " + expected_header(numbers_);
  if (!read_line()) throw SceneError(name_ + ": found an empty file" + expected);
  header_ = text_.starts_with("\xef\xbb\xbf") ? text_.substr(3) : text_;
  const std::vector<std::string_view> fields = fields_of(header_);
  columns_ = fields.size();
  const bool third_in_plane = numbers_ == 2 && columns_ > 2 && fields[2] == "z";
  if (too_long_ || third_in_plane || !starts_with_names(fields, numbers_)) {
    throw SceneError(name_ + ":1: found " + excerpt(header_) + expected);
  }
}

std::optional<std::variant<PointRow, MalformedRow>> PointTable::next() {
  do {
    if (!read_line()) return std::nullopt;
  } while (!too_long_ && trimmed(text_).empty());
  if (too_long_) return MalformedRow{line_, "found more than " + counted(longest_line, "byte") + ", expected a point"};
  const std::vector<std::string_view> fields = fields_of(text_);
  if (fields.size() != columns_) {
    return MalformedRow{line_, "found " + counted(fields.size(), "field") + ", expected " + std::to_string(columns_)};
  }
  PointRow row{line_, text_, {}, {}};
  for (std::size_t i = 0; i < numbers_; ++i) {
    const std::optional<double> value = finite_field(fields[i]);
    if (!value) {
      return MalformedRow{
          line_, std::string(column_names[i]) + ": found " + excerpt(fields[i]) + ", expected a finite number"};
    }
    (i < 3 ? row.coordinates : row.normal)[i % 3] = *value;
  }
  if (numbers_ == 6 && row.normal == std::array<double, 3>{}) {
    return MalformedRow{line_, "nx,ny,nz: found 0,0,0, expected a direction"};
  }
  return row;
}

bool PointTable::read_line() {
  using Traits = std::istream::traits_type;
  text_.clear();
  too_long_ = false;
  std::streambuf& buffer = *stream_.rdbuf();
  auto c = buffer.sbumpc();
  if (Traits::eq_int_type(c, Traits::eof())) return false;
  for (; !Traits::eq_int_type(c, Traits::eof()) && c != '\n'; c = buffer.sbumpc()) {
    if (text_.size() < longest_line) {
      text_ += Traits::to_char_type(c);
    } else {
      too_long_ = true;
    }
  }
  if (text_.ends_with('\r')) text_.pop_back();
  ++line_;
  return true;
}

}  // namespace gnomon
