#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

using TextRow = std::vector<std::string>;

/// Rows as lines, cells padded so that columns stand below each other, two spaces between them.
std::string aligned(const std::vector<TextRow>& rows, std::size_t indent);

/// The shortest text that reads back as the same double, of at most 17 digits: for files.
std::string number_text(double value);

/// The number rounded to 6 digits: for people.
std::string rounded_text(double value);

/// "1 light", "2 lights".
std::string counted(std::size_t count, std::string_view noun);

/// The word as a POSIX shell takes it for one argument.
std::string shell_word(const std::string& word);

/// The text as a field of CSV: in double quotes where it has to be.
std::string csv_field(const std::string& text);

}  // namespace gnomon
