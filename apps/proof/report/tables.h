#pragma once

#include <string>
#include <vector>

namespace gnomon::report {

using Row = std::vector<std::string>;

/// Rows as a table of Markdown, the first as its head; the first column to the left, the others to the right.
std::string markdown_table(const std::vector<Row>& rows);

/// Rows as CSV.
/// Requires: no cell holds a double quote or a line break.
std::string csv(const std::vector<Row>& rows);

/// Three digits: "0.00123", "1.2e-16".
std::string short_text(double value);

/// The shortest text that reads back as the same double.
std::string full_text(double value);

/// Three digits and a unit: "1.23 µs".
std::string time_text(double seconds);

/// "1 triangle", "4 triangles".
std::string counted_text(std::size_t count, const std::string& noun);

/// "12 kB".
std::string bytes_text(std::size_t bytes);

}  // namespace gnomon::report
