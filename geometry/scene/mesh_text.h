#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/scene/mesh_formats.h"

namespace gnomon {

/// A mesh file that consists of lines of words.
class MeshLines {
 public:
  MeshLines(std::string_view text, const MeshSource& source) : rest_(text), source_(source) {}

  /// Goes on to the next line that holds a word. Returns false at the end. What follows a '#' is a comment.
  bool next();

  const std::vector<std::string_view>& words() const { return words_; }

  /// The word as a finite double, nearest to the decimal number.
  double number(std::size_t word) const;
  std::int64_t integer(std::size_t word) const;

  /// The three words from `first` as a point.
  Point3 point(std::size_t first) const { return {number(first), number(first + 1), number(first + 2)}; }

  /// What is left after the current line.
  std::string_view rest() const { return rest_; }

  [[noreturn]] void refuse(std::string_view found, std::string_view expected) const;

 private:
  std::string_view word(std::size_t index, std::string_view expected) const;

  std::string_view rest_;
  const MeshSource& source_;
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
};

/// The whole word as an integer, or nothing.
std::optional<std::int64_t> integer_of(std::string_view word);

/// The word in quotes for messages, printable and cut where it gets long.
std::string word_text(std::string_view word);

/// Refuses vertex numbers that are out of range.
void require_indices(const PolygonSoup& soup, const MeshSource& source);

}  // namespace gnomon
