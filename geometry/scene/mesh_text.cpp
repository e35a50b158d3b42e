#include "geometry/scene/mesh_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "geometry/scene/json_text.h"

namespace gnomon {

void MeshSource::refuse(std::string_view place, std::string_view found, std::string_view expected) const {
  node.refuse("in " + in_quotes(file) + ", " + std::string(place) + ", " + std::string(found), expected);
}

bool MeshLines::next() {
  constexpr std::string_view blanks = " \t\r\v\f";
  words_.clear();
  while (words_.empty() && !rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    line = line.substr(0, line.find('#'));
    for (std::size_t start = line.find_first_not_of(blanks); start != std::string_view::npos;
         start = line.find_first_not_of(blanks)) {
      line.remove_prefix(start);
      const std::size_t length = std::min(line.find_first_of(blanks), line.size());
      words_.push_back(line.substr(0, length));
      line.remove_prefix(length);
    }
  }
  return !words_.empty();
}

std::string_view MeshLines::word(std::size_t index, std::string_view expected) const {
  if (index >= words_.size()) refuse("a line of " + std::to_string(words_.size()) + " words", expected);
  return words_[index].starts_with('+') ? words_[index].substr(1) : words_[index];
}

double MeshLines::number(std::size_t index) const {
  const std::string_view text = word(index, "a further number");
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // Too small counts as out of range as well; its nearest double is wanted.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
  if (error == std::errc::invalid_argument || end != text.data() + text.size() || !std::isfinite(value)) {
    refuse(word_text(text), "a finite number");
  }
  return value;
}

std::int64_t MeshLines::integer(std::size_t index) const {
  const std::string_view text = word(index, "a further integer");
  const std::optional<std::int64_t> value = integer_of(text);
  if (!value) refuse(word_text(text), "an integer");
  return *value;
}

void MeshLines::refuse(std::string_view found, std::string_view expected) const {
  source_.refuse("line " + std::to_string(line_), found, expected);
}

std::optional<std::int64_t> integer_of(std::string_view word) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::string word_text(std::string_view word) {
  std::string bytes(word.substr(0, 40));
  std::replace_if(
      bytes.begin(), bytes.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
  return in_quotes(bytes);
}

void require_indices(const PolygonSoup& soup, const MeshSource& source) {
  for (std::size_t f = 0; f < soup.facets.size(); ++f) {
    for (const std::uint32_t index : soup.facets[f]) {
      if (index < soup.vertices.size()) continue;
      source.refuse("facet " + std::to_string(f), "the vertex number " + std::to_string(index) + " (counted from 0)",
                    "one of " + std::to_string(soup.vertices.size()) + " vertices");
    }
  }
}

}  // namespace gnomon
