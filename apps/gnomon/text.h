#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

using TextRow = std::vector<std::string>;

/// What people read is no wider than this, in terminals, tables and the manual page.
constexpr std::size_t most_columns = 80;

/// Rows as lines of at most most_columns, cells padded so that columns stand below each other, two spaces between them.
/// Where there is no room, the last column goes on in lines below, and then the widest cells lose their middle ("...").
std::string aligned(const std::vector<TextRow>& rows, std::size_t indent);

/// The text in lines of at most most_columns, broken between words. Lines that begin at the left edge are one paragraph
/// with the next ones; a line with a gap in it, as of an option and its help, goes on below what follows the gap.
std::string in_columns(const std::string& text);

/// "scene      figure.scene.json: ...", with the text in lines below each other behind the label.
std::string labelled(const std::string& label, const std::string& text, std::size_t indent = 0);

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
