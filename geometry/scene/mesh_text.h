#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/scene/mesh_formats.h"

namespace gnomon {

/// A mesh file that consists of lines of words. A byte-order mark and all kinds of line ends are read.
class MeshLines {
 public:
  /// `lines_before`: how many lines of the file the text does not hold.
  MeshLines(std::string_view text, const MeshSource& source, std::size_t lines_before = 0);

  /// From now on a backslash at the end of a line continues it on the next one.
  void let_backslashes_continue() { backslash_continues_ = true; }

  /// Goes on to the next line that holds a word. Returns false at the end. What follows a '#' is a comment.
  bool next();

  const std::vector<std::string_view>& words() const { return words_; }

  /// The words from `first` on, with blanks between them.
  std::string words_from(std::size_t first) const;

  /// The word as a finite double, nearest to the decimal number.
  double number(std::size_t word) const;

  /// The same, with what is not finite.
  double any_number(std::size_t word) const;
  std::int64_t integer(std::size_t word) const;

  /// The three words from `first` as a point.
  Point3 point(std::size_t first) const { return {number(first), number(first + 1), number(first + 2)}; }

  /// What is left after the current line.
  std::string_view rest() const { return rest_; }

  /// The number of the current line; where lines are continued, of the first.
  std::size_t line() const { return line_; }

  [[noreturn]] void refuse(std::string_view found, std::string_view expected) const;

  /// What was read past so far that is no part of plain text, as a doubt; empty if nothing was.
  std::string doubt() const;

 private:
  std::string_view word(std::size_t index, std::string_view expected) const;

  /// Takes the next line off the text, without its end.
  std::string_view take_line();

  /// True if the line is continued on the next one.
  bool add_words(std::string_view line);

  enum class LineEnd { unknown, line_feed, both, carriage_return };

  std::string_view rest_;
  const MeshSource& source_;
  std::size_t line_ = 0;   ///< the first one of those that hang together
  std::size_t taken_ = 0;  ///< lines taken off the text
  LineEnd first_end_ = LineEnd::unknown;
  bool backslash_continues_ = false;
  bool has_mark_ = false;
  bool has_returns_ = false;
  bool has_continued_ = false;
  std::vector<std::string_view> words_;
};

/// The whole word as an integer, or nothing.
std::optional<std::int64_t> integer_of(std::string_view word);

/// The word in quotes for messages, printable and cut where it gets long.
std::string word_text(std::string_view word);

/// The word in small letters.
std::string lower_case(std::string_view word);

/// Lines whose first word no reader knows: passed over, with a doubt for each word.
class UnknownWords {
 public:
  void add(const MeshLines& lines);
  std::vector<std::string> doubts() const;

 private:
  std::vector<std::string> words_;
  std::vector<std::size_t> lines_;
  bool has_more_ = false;
};

/// Refuses vertex numbers that are out of range.
void require_indices(const PolygonSoup& soup, const MeshSource& source);

}  // namespace gnomon
