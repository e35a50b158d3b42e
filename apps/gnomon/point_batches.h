#pragma once

#include <cstddef>
#include <functional>
#include <istream>
#include <string>
#include <variant>
#include <vector>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/point_table.h"

namespace gnomon {

using TableRow = std::variant<PointRow, MalformedRow>;

/// Calls the function with the points' stream and its name in messages; `at` is a file name or "-" for stdin.
///
/// Throws: SceneError if the file cannot be read.
ExitCode with_points(const std::string& at, const std::function<ExitCode(std::istream&, const std::string&)>& work);

/// The next rows of the table, at most 1,024: as many are held in memory at a time. None at the end.
std::vector<TableRow> next_rows(PointTable& table);

/// The part of the points' file that has been read, from 0 to 1; negative for stdin and pipes.
double share_read(std::istream& stream, const std::string& at);

}  // namespace gnomon
