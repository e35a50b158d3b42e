#pragma once

#include <array>
#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <variant>

#include "apps/gnomon/table_dialect.h"

namespace gnomon {

/// A row of a table of points.
struct PointRow {
  std::size_t line = 0;                 ///< in the file, from 1
  std::string text;                     ///< its fields as written, separated by commas
  std::array<double, 3> coordinates{};  ///< z is 0 in the plane
  std::array<double, 3> normal{};       ///< not zero where the table has normals
  std::array<double, 3> eye{};          ///< not the point itself where the table has eyes
};

/// A row that is no point.
struct MalformedRow {
  std::size_t line = 0;
  std::string problem;  ///< what was found and what was expected
};

/// Points as CSV in any of its dialects, read row by row in constant memory.
///
/// A header names the columns x, y, z (in the plane x, y; for normals nx, ny, nz too), in any order and case, quoted or
/// not, among other columns, which are passed through. Fields are separated by commas, semicolons, tabs or blanks. A
/// table whose first line holds numbers has no header: three or six in that order. Empty lines, lines that begin with
/// '#', a line `sep=;`, a byte order mark, spaces around a field and any line ends are accepted.
class PointTable {
 public:
  /// Reads the header. `name` is how messages call the file.
  ///
  /// Throws: SceneError if the first line is neither a header nor a point.
  PointTable(std::istream& stream, std::string name, TableColumns columns);

  /// The names of the columns as written, separated by commas; those of the format where there is no header.
  const std::string& header() const { return header_; }

  /// True if every row has a normal.
  bool has_normals() const { return dialect_.numbers.size() >= 6; }

  /// The next row; nothing at the end.
  std::optional<std::variant<PointRow, MalformedRow>> next();

 private:
  /// Goes on to the next line that is not empty. False at the end of the stream.
  bool next_line();

  /// The line as a row.
  std::variant<PointRow, MalformedRow> row() const;

  /// False at the end of the stream. A line that is too long is cut, and `too_long_` set.
  bool read_line();

  /// Takes the line for the header, or for the first row of a table without one. False if it is neither.
  bool read_header(TableColumns columns);

  [[noreturn]] void refuse_header(TableColumns columns) const;

  std::istream& stream_;
  std::string name_;
  TableDialect dialect_;
  std::string header_;
  std::string text_;
  std::size_t line_ = 0;
  bool too_long_ = false;
  bool after_return_ = false;    ///< the last line ended with '\r'; a '\n' belongs to it
  bool row_is_waiting_ = false;  ///< the line that was read first is a row
};

}  // namespace gnomon
