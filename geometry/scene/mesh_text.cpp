#include "geometry/scene/mesh_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "geometry/scene/json_text.h"

namespace gnomon {

void MeshSource::refuse(std::string_view place, std::string_view found, std::string_view expected) const {
  const std::string where = file.empty() ? "" : "in " + in_quotes(file) + ", ";
  node.refuse(where + std::string(place) + ", " + std::string(found), expected);
}

std::string facet_place(const PolygonSoup& soup, std::size_t facet) {
  const std::string number = "facet " + std::to_string(facet);
  return soup.lines.empty() ? number : "line " + std::to_string(soup.lines[facet]) + ", " + number;
}

MeshLines::MeshLines(std::string_view text, const MeshSource& source, std::size_t lines_before)
    : rest_(text), source_(source), line_(lines_before), taken_(lines_before) {
  if (lines_before > 0) return;
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    source.refuse("line 1", "text in UTF-16", "plain text (ASCII or UTF-8)");
  }
  constexpr std::string_view mark = "\xef\xbb\xbf";
  has_mark_ = text.starts_with(mark);
  if (has_mark_) rest_.remove_prefix(mark.size());
}

std::string_view MeshLines::take_line() {
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end);
  ++taken_;
  if (rest_.empty()) return line;
  const bool both = rest_.starts_with("\r\n");
  if (first_end_ == LineEnd::unknown) {
    first_end_ = both ? LineEnd::both : rest_[0] == '\r' ? LineEnd::carriage_return : LineEnd::line_feed;
  }
  has_returns_ = has_returns_ || rest_[0] == '\r';
  // Behind the head of a binary file whose lines end with CR, a line feed is the first byte of the numbers.
  rest_.remove_prefix(both && first_end_ != LineEnd::carriage_return ? 2 : 1);
  return line;
}

bool MeshLines::add_words(std::string_view line) {
  constexpr std::string_view blanks = " \t\v\f";
  line = line.substr(0, line.find('#'));
  for (std::size_t start = line.find_first_not_of(blanks); start != std::string_view::npos;
       start = line.find_first_not_of(blanks)) {
    line.remove_prefix(start);
    const std::size_t length = std::min(line.find_first_of(blanks), line.size());
    words_.push_back(line.substr(0, length));
    line.remove_prefix(length);
  }
  if (!backslash_continues_ || words_.empty() || !words_.back().ends_with('\\')) return false;
  words_.back().remove_suffix(1);
  if (words_.back().empty()) words_.pop_back();
  return has_continued_ = true;
}

bool MeshLines::next() {
  words_.clear();
  while (words_.empty() && !rest_.empty()) {
    line_ = taken_ + 1;
    while (add_words(take_line()) && !rest_.empty()) continue;
  }
  return !words_.empty();
}

std::string MeshLines::words_from(std::size_t first) const {
  std::string text;
  for (std::size_t i = first; i < words_.size(); ++i) text += (text.empty() ? "" : " ") + std::string(words_[i]);
  return text;
}

std::string MeshLines::doubt() const {
  std::string found;
  const auto add = [&](bool is_there, std::string_view what) {
    if (is_there) found.append(found.empty() ? "" : ", ").append(what);
  };
  add(has_mark_, "a byte-order mark");
  add(has_returns_, "carriage returns at the ends of lines");
  add(has_continued_, "lines continued after a backslash");
  return found.empty() ? found : "read past " + found;
}

std::string_view MeshLines::word(std::size_t index, std::string_view expected) const {
  if (index >= words_.size()) refuse("a line of " + std::to_string(words_.size()) + " words", expected);
  return words_[index].starts_with('+') ? words_[index].substr(1) : words_[index];
}

double MeshLines::any_number(std::size_t index) const {
  const std::string_view text = word(index, "a further number");
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // Too small counts as out of range as well; its nearest double is wanted.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
    const bool comma = text.find(',') != std::string_view::npos;
    refuse(word_text(text), comma ? "a finite number, with a point before its decimals" : "a finite number");
  }
  return value;
}

double MeshLines::number(std::size_t index) const {
  const double value = any_number(index);
  if (!std::isfinite(value)) refuse(word_text(words_[index]), "a finite number");
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

std::string lower_case(std::string_view word) {
  std::string lower(word);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

void UnknownWords::add(const MeshLines& lines) {
  constexpr std::size_t most = 8;
  const std::string word = word_text(lines.words()[0]);
  if (std::find(words_.begin(), words_.end(), word) != words_.end()) return;
  has_more_ = words_.size() == most;
  if (has_more_) return;
  words_.push_back(word);
  lines_.push_back(lines.line());
}

std::vector<std::string> UnknownWords::doubts() const {
  std::vector<std::string> doubts;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    doubts.push_back("line " + std::to_string(lines_[i]) + ": lines that begin with " + words_[i] +
                     " are not known and passed over");
  }
  if (has_more_) doubts.emplace_back("lines that begin with further words are passed over as well");
  return doubts;
}

void require_indices(const PolygonSoup& soup, const MeshSource& source) {
  for (std::size_t f = 0; f < soup.facets.size(); ++f) {
    for (const std::uint32_t index : soup.facets[f]) {
      if (index < soup.vertices.size()) continue;
      source.refuse(facet_place(soup, f), "the vertex number " + std::to_string(index + soup.first_number),
                    "one of " + std::to_string(soup.vertices.size()) + " vertices, counted from " +
                        std::to_string(soup.first_number));
    }
  }
}

}  // namespace gnomon
