#pragma once

#include <string>
#include <vector>

namespace gnomon::viz {

/// A block's path as one text: "volumes/lamp/table/umbra".
inline std::string joined(const std::vector<std::string>& path) {
  std::string text;
  for (const std::string& part : path) {
    if (!text.empty()) text += '/';
    text += part;
  }
  return text;
}

}  // namespace gnomon::viz
