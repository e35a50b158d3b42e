#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// What the columns of a table of points hold.
enum class TableColumns {
  planar_points,
  points,  ///< further columns, normals too, are passed over
  points_with_normals,
  views,                        ///< points with normals, and eyes
  points_perhaps_with_normals,  ///< with normals where the table has them
};

/// How a table separates its fields, and in which of them its numbers stand.
struct TableDialect {
  char separator = ',';              ///< comma, semicolon, tab, or a blank, which stands for any run of blanks
  std::size_t columns = 0;           ///< fields of every row
  std::vector<std::size_t> numbers;  ///< the columns of x, y, z, nx, ny, nz, ex, ey, ez, as many as are read
};

/// The fields of a line, as written, without the blanks around them. A separator in double quotes is part of a field.
std::vector<std::string_view> table_fields(std::string_view line, char separator);

/// The dialect of a header that names every column asked for; nothing if it does not. Names may be quoted and in upper
/// case, in any order, and further columns may stand between them.
std::optional<TableDialect> dialect_of_header(std::string_view line, TableColumns columns);

/// The dialect of a table without header, from its first row: three or six numbers, in the plane two.
std::optional<TableDialect> dialect_of_numbers(std::string_view line, TableColumns columns);

/// The double nearest to a decimal number, which may be quoted; nothing for other text and for what overflows.
std::optional<double> number_in_field(std::string_view field);

/// True for a number that is written with a comma before its decimals.
bool has_decimal_comma(std::string_view field);

/// "x,y,z" and so on: the first `count` columns.
std::string column_names(std::size_t count);
std::string_view column_name(std::size_t index);

}  // namespace gnomon
