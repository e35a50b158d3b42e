#pragma once

#include <array>
#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <variant>

namespace gnomon {

/// A row of a table of points.
struct PointRow {
  std::size_t line = 0;                 ///< in the file, from 1
  std::string text;                     ///< as written, without the end of the line
  std::array<double, 3> coordinates{};  ///< z is 0 in the plane
  std::array<double, 3> normal{};       ///< not zero where normals are asked for
};

/// A row that is no point.
struct MalformedRow {
  std::size_t line = 0;
  std::string problem;  ///< what was found and what was expected
};

/// What the first columns of a table hold.
enum class TableColumns { planar_points, points, points_with_normals };

/// Points as CSV, read row by row in constant memory: a header `x,y,z` (in the plane `x,y`; with normals
/// `x,y,z,nx,ny,nz`), then a point a line.
/// Further columns are allowed behind the coordinates; they are passed over, and a comma in double quotes is part of a
/// field there. Spaces around a field, empty lines, a byte order mark and either kind of line end are accepted.
class PointTable {
 public:
  /// Reads the header. `name` is how messages call the file.
  ///
  /// Throws: SceneError if the header is another one.
  PointTable(std::istream& stream, std::string name, TableColumns columns);

  /// The header as written.
  const std::string& header() const { return header_; }

  /// The next row; nothing at the end.
  std::optional<std::variant<PointRow, MalformedRow>> next();

 private:
  /// False at the end of the stream. A line that is too long is cut, and `too_long_` set.
  bool read_line();

  std::istream& stream_;
  std::string name_;
  std::size_t numbers_;  ///< in the first columns
  std::string header_;
  std::size_t columns_ = 0;
  std::string text_;
  std::size_t line_ = 0;
  bool too_long_ = false;
};

}  // namespace gnomon
