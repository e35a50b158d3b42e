#include "apps/gnomon/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

namespace gnomon {
namespace {

/// Number of characters; in UTF-8 all but the first byte of one look like 10xxxxxx.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

bool starts_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

/// The bytes of the first `count` characters.
std::size_t bytes_of(std::string_view text, std::size_t count) {
  std::size_t i = 0;
  for (; i < text.size(); ++i) {
    if (starts_character(text[i]) && count-- == 0) break;
  }
  return i;
}

/// The text with its middle left out, so that it has at most `room` characters, of which it needs four.
std::string shortened(const std::string& text, std::size_t room) {
  const std::size_t length = width(text);
  if (length <= room) return text;
  const std::size_t head = (room - 2) / 2;
  return text.substr(0, bytes_of(text, head)) + "..." + text.substr(bytes_of(text, length - (room - 3 - head)));
}

/// Words one after the other in lines of at most `room` characters. A word that is longer stays whole.
std::vector<std::string> wrapped_words(std::string_view text, std::size_t room) {
  std::vector<std::string> lines{""};
  for (std::size_t start = text.find_first_not_of(' '); start != std::string_view::npos;) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string_view word = text.substr(start, end - start);
    if (!lines.back().empty() && width(lines.back()) + 1 + width(word) > room) lines.emplace_back();
    lines.back().append(lines.back().empty() ? "" : " ").append(word);
    start = text.find_first_not_of(' ', end);
  }
  return lines;
}

std::vector<std::size_t> column_widths(const std::vector<TextRow>& rows) {
  std::vector<std::size_t> widths;
  for (const TextRow& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  return widths;
}

std::size_t sum(const std::vector<std::size_t>& widths) {
  std::size_t total = 0;
  for (const std::size_t w : widths) total += w + 2;
  return total;
}

/// Names may lose their middle, numbers must not.
bool holds_numbers(const std::vector<TextRow>& rows, std::size_t column) {
  return std::any_of(rows.begin(), rows.end(), [&](const TextRow& row) {
    return column < row.size() && !row[column].empty() &&
           (row[column][0] == '-' || (row[column][0] >= '0' && row[column][0] <= '9'));
  });
}

/// Widths with which a table fits: the last column keeps what the others leave it, at least `least_prose`, where its
/// cells have words to be broken between; then the widest column of names gives way.
std::vector<std::size_t> fitting_widths(std::vector<std::size_t> widths, const std::vector<TextRow>& rows,
                                        std::size_t room, bool last_is_prose) {
  constexpr std::size_t least_prose = 24;
  constexpr std::size_t least_cell = 8;
  if (widths.empty() || sum(widths) <= room + 2) return widths;
  if (last_is_prose) {
    const std::size_t others = sum(widths) - widths.back() - 2;
    widths.back() = std::min(widths.back(), std::max(least_prose, room - std::min(room, others)));
  }
  while (sum(widths) > room + 2) {
    std::size_t widest = widths.size();
    for (std::size_t i = 0; i < widths.size() - (last_is_prose ? 1 : 0); ++i) {
      const bool may_shrink = widths[i] > least_cell && !holds_numbers(rows, i);
      if (may_shrink && (widest == widths.size() || widths[i] > widths[widest])) widest = i;
    }
    if (widest == widths.size()) break;
    --widths[widest];
  }
  return widths;
}

/// The cells of one row, each in the lines it takes.
std::string row_text(const TextRow& row, const std::vector<std::size_t>& widths, std::size_t indent) {
  std::string text;
  std::vector<std::string> last = {row.empty() ? "" : row.back()};
  if (row.size() == widths.size() && width(last[0]) > widths.back()) last = wrapped_words(last[0], widths.back());
  for (std::size_t n = 0; n < last.size(); ++n) {
    std::string line(indent, ' ');
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      const std::string cell = n == 0 ? shortened(row[i], widths[i]) : "";
      line += cell + std::string(widths[i] - width(cell) + 2, ' ');
    }
    line += last[n];
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

bool has_words(const TextRow& row, std::size_t columns) {
  return row.size() == columns && std::count(row.back().begin(), row.back().end(), ' ') > 2;
}

/// Where an indented line goes on: below what follows its first gap, or below its beginning.
std::size_t hanging_indent(std::string_view line) {
  const std::size_t start = line.find_first_not_of(' ');
  const std::size_t gap = line.find("  ", start);
  const std::size_t after = gap == std::string_view::npos ? gap : line.find_first_not_of(' ', gap);
  return after == std::string_view::npos || after > most_columns / 2 ? start : after;
}

/// An indented line, broken where it is too long.
std::string broken_line(const std::string& line) {
  if (width(line) <= most_columns) return line + '\n';
  const std::size_t indent = hanging_indent(line);
  // What stands before the gap is kept with its blanks.
  const std::string head = line.substr(0, indent);
  std::string text;
  for (const std::string& part : wrapped_words(std::string_view(line).substr(indent), most_columns - indent)) {
    text += (text.empty() ? head : std::string(indent, ' ')) + part + '\n';
  }
  return text;
}

std::string paragraph(const std::string& words) {
  if (words.empty()) return {};
  std::string text;
  for (const std::string& line : wrapped_words(words, most_columns)) text += line + '\n';
  return text;
}

}  // namespace

std::string aligned(const std::vector<TextRow>& rows, std::size_t indent) {
  std::vector<std::size_t> widths = column_widths(rows);
  const bool last_is_prose =
      std::any_of(rows.begin(), rows.end(), [&](const TextRow& row) { return has_words(row, widths.size()); });
  widths = fitting_widths(std::move(widths), rows, most_columns - indent, last_is_prose);
  std::string text;
  for (const TextRow& row : rows) text += row_text(row, widths, indent);
  return text;
}

std::string in_columns(const std::string& text) {
  std::string result, words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool is_plain = !line.empty() && line[0] != ' ';
    if (is_plain && line.starts_with("Usage:"))
      result += paragraph(std::exchange(words, "")) + (result.empty() ? "" : "\n");
    if (is_plain) {
      words += (words.empty() ? "" : " ") + line;
      continue;
    }
    result += paragraph(std::exchange(words, ""));
    result += line.empty() ? "\n" : broken_line(line);
  }
  return result + paragraph(words);
}

std::string labelled(const std::string& label, const std::string& text, std::size_t indent) {
  constexpr std::size_t label_width = 11;
  std::string result;
  for (const std::string& line : wrapped_words(text, most_columns - indent - label_width)) {
    const std::string head = result.empty() ? label : "";
    result += std::string(indent, ' ') + head + std::string(label_width - std::min(label_width, head.size()), ' ') +
              line + '\n';
  }
  return result;
}

std::string number_text(double value) {
  // Left to itself to_chars writes 100000 as 1e+05.
  const double size = std::abs(value);
  const bool plain = size == 0 || (size >= 1e-4 && size < 1e15);
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                    plain ? std::chars_format::fixed : std::chars_format::scientific);
  return {buffer.data(), result.ptr};
}

std::string rounded_text(double value) {
  std::array<char, 32> buffer{};
  char* const end = buffer.data() + buffer.size();
  const auto digits = std::to_chars(buffer.data(), end, value, std::chars_format::general, 6).ptr;
  double rounded = value;  // what is no number stays
  std::from_chars(buffer.data(), digits, rounded);
  return number_text(rounded);
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + ' ' + std::string(noun) + (count == 1 ? "" : "s");
}

std::string shell_word(const std::string& word) {
  constexpr std::string_view harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+,=:@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace gnomon
