#include "geometry/scene/material_file.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

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

}  // namespace

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
