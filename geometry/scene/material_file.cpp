#include "geometry/scene/material_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace gnomon {
namespace {

bool emits(std::istringstream& numbers) {
  std::string word;
  while (numbers >> word) {
    if (std::strtod(word.c_str(), nullptr) > 0) return true;
  }
  return false;
}

/// The words that are left on the line, with single blanks between them.
std::string rest_of(std::istringstream& line) {
  std::string text, word;
  while (line >> word) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// Lines of a text, with any kind of line ends and without comments.
std::vector<std::string> lines_of(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  std::string plain(text);
  std::replace(plain.begin(), plain.end(), '\r', '\n');
  std::istringstream stream(plain);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line.substr(0, line.find('#')));
  return lines;
}

/// One, or three, finite numbers from 0 on, and nothing else.
std::optional<std::array<double, 3>> channels(std::istringstream& words) {
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (*end != 0 || !std::isfinite(numbers.back()) || numbers.back() < 0) return std::nullopt;
  }
  if (numbers.size() == 1) return std::array{numbers[0], numbers[0], numbers[0]};
  return numbers.size() == 3 ? std::optional(std::array{numbers[0], numbers[1], numbers[2]}) : std::nullopt;
}

}  // namespace

MaterialFile material_file(std::string_view text) {
  MaterialFile file;
  FileMaterial* material = nullptr;
  for (const std::string& line : lines_of(text)) {
    std::istringstream words(line);
    std::string keyword;
    if (!(words >> keyword)) continue;
    if (keyword == "newmtl") {
      material = &file.materials[rest_of(words)];
      continue;
    }
    const auto numbers = channels(words);
    if (!material || !numbers) {
      ++file.passed_over[keyword];
    } else if (keyword == "Ke") {
      material->emission = numbers;
    } else if (keyword == "Kd") {
      material->diffuse = numbers;
    } else if (keyword == "Ks") {
      material->specular = numbers;
    } else if (keyword == "Ns") {
      material->exponent = (*numbers)[0];
    } else {
      ++file.passed_over[keyword];
    }
  }
  return file;
}

std::set<std::string> emitting_materials(std::string_view text) {
  std::set<std::string> emitting;
  std::string material;
  std::string plain(text);
  std::replace(plain.begin(), plain.end(), '\r', '\n');
  std::istringstream lines(plain);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "newmtl") material = rest_of(words);
    if (keyword == "Ke" && emits(words)) emitting.insert(material);
  }
  return emitting;
}

}  // namespace gnomon
