#include "apps/gnomon/point_table.h"

#include <string_view>
#include <utility>
#include <vector>

#include "apps/gnomon/csv_row.h"
#include "apps/gnomon/text.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

constexpr std::size_t longest_line = 1 << 16;

/// Rows are repeated in the result, where such a quote would run the fields, or the rows, together.
constexpr const char* quote_trouble =
    ", expected double quotes around whole fields, closed and doubled inside, and no control characters";

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
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

/// The line with commas between its fields. Who writes commas gets back what was written.
std::string with_commas(const std::string& line, char separator) {
  if (separator == ',') return line;
  std::string row;
  bool first = true;
  for (const std::string_view field : table_fields(line, separator)) {
    const std::string text(field);
    row += (std::exchange(first, false) ? "" : ",") + (field.starts_with('"') ? text : csv_field(text));
  }
  return row;
}

bool is_utf16(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

std::string wanted_columns(TableColumns columns) {
  if (columns == TableColumns::planar_points) return column_names(2);
  if (columns == TableColumns::views) return column_names(9);
  return column_names(columns == TableColumns::points_with_normals ? 6 : 3);
}

std::string wanted_count(TableColumns columns) {
  if (columns == TableColumns::planar_points) return "two";
  if (columns == TableColumns::views) return "nine";
  return columns == TableColumns::points_with_normals ? "six" : "three or six";
}

/// A header or a first row, in the words of messages.
std::string expected_header(TableColumns columns) {
  return ", expected the header \"" + wanted_columns(columns) +
         "\", its names separated by commas, semicolons, tabs or " + "blanks, or a first row of " +
         wanted_count(columns) + " numbers";
}

}  // namespace

PointTable::PointTable(std::istream& stream, std::string name, TableColumns columns)
    : stream_(stream), name_(std::move(name)) {
  while (true) {
    if (!next_line()) throw SceneError(name_ + ": found an empty file" + expected_header(columns));
    if (is_utf16(text_)) throw SceneError(name_ + ": found text in UTF-16, expected UTF-8");
    // Spreadsheets say there how they separate; the header shows it anyway.
    if (text_.starts_with("sep=")) continue;
    if (read_header(columns)) return;
    if (!text_.starts_with('#')) refuse_header(columns);
  }
}

bool PointTable::read_header(TableColumns columns) {
  const std::string_view names = std::string_view(text_).substr(text_.starts_with('#') ? 1 : 0);
  if (too_long_) return false;
  if (const auto dialect = dialect_of_header(names, columns)) {
    dialect_ = *dialect;
    header_ = with_commas(std::string(names), dialect_.separator);
    if (csv_field_count(header_) == dialect_.columns) return true;
    throw SceneError(name_ + ':' + std::to_string(line_) + ": found " + excerpt(text_) + quote_trouble);
  }
  const auto dialect = dialect_of_numbers(text_, columns);
  if (!dialect) return false;
  dialect_ = *dialect;
  header_ = column_names(dialect_.columns);
  return row_is_waiting_ = true;
}

void PointTable::refuse_header(TableColumns columns) const {
  std::string found = ": found " + excerpt(text_);
  for (const char separator : {';', '\t', ' '}) {
    const std::vector<std::string_view> fields = table_fields(text_, separator);
    if (fields.size() > 1 && has_decimal_comma(fields[0])) found += ", numbers with decimal commas";
    if (found.ends_with("commas")) break;
  }
  throw SceneError(name_ + ':' + std::to_string(line_) + found + expected_header(columns));
}

std::optional<std::variant<PointRow, MalformedRow>> PointTable::next() {
  do {
    if (!std::exchange(row_is_waiting_, false) && !next_line()) return std::nullopt;
  } while (!too_long_ && text_.starts_with('#'));
  if (too_long_) return MalformedRow{line_, "found more than " + counted(longest_line, "byte") + ", expected a point"};
  return row();
}

std::variant<PointRow, MalformedRow> PointTable::row() const {
  const std::vector<std::string_view> fields = table_fields(text_, dialect_.separator);
  if (fields.size() != dialect_.columns) {
    return MalformedRow{line_,
                        "found " + counted(fields.size(), "field") + ", expected " + std::to_string(dialect_.columns)};
  }
  PointRow point{line_, with_commas(text_, dialect_.separator), {}, {}, {}};
  for (std::size_t i = 0; i < dialect_.numbers.size(); ++i) {
    const std::string_view field = fields[dialect_.numbers[i]];
    const std::optional<double> value = number_in_field(field);
    if (!value) {
      return MalformedRow{line_, std::string(column_name(i)) + ": found " + excerpt(field) + ", expected " +
                                     (has_decimal_comma(field) ? "a decimal point, not a comma" : "a finite number")};
    }
    (i < 3 ? point.coordinates : i < 6 ? point.normal : point.eye)[i % 3] = *value;
  }
  if (has_normals() && point.normal == std::array<double, 3>{}) {
    return MalformedRow{line_, "nx,ny,nz: found 0,0,0, expected a direction"};
  }
  if (dialect_.numbers.size() == 9 && point.eye == point.coordinates) {
    return MalformedRow{line_, "ex,ey,ez: found the point x,y,z itself, expected an eye elsewhere"};
  }
  if (csv_field_count(point.text) != dialect_.columns) {
    return MalformedRow{line_, "found " + excerpt(text_) + quote_trouble};
  }
  return point;
}

bool PointTable::next_line() {
  do {
    if (!read_line()) return false;
    if (line_ == 1 && text_.starts_with("\xef\xbb\xbf")) text_.erase(0, 3);
  } while (!too_long_ && without_blanks(text_).empty());
  return true;
}

bool PointTable::read_line() {
  using Traits = std::istream::traits_type;
  text_.clear();
  too_long_ = false;
  std::streambuf& buffer = *stream_.rdbuf();
  auto c = buffer.sbumpc();
  if (std::exchange(after_return_, false) && c == '\n') c = buffer.sbumpc();
  if (Traits::eq_int_type(c, Traits::eof())) return false;
  for (; !Traits::eq_int_type(c, Traits::eof()) && c != '\n' && c != '\r'; c = buffer.sbumpc()) {
    if (text_.size() < longest_line) {
      text_ += Traits::to_char_type(c);
    } else {
      too_long_ = true;
    }
  }
  after_return_ = c == '\r';
  ++line_;
  return true;
}

}  // namespace gnomon
