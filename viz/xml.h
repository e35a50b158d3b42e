#pragma once

#include <string>
#include <string_view>

namespace gnomon::viz {

/// The text as the value of an XML attribute.
inline std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '&' || c == '<' || c == '>' || c == '"' || byte < 32) {
      escaped += "&#" + std::to_string(byte) + ";";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

}  // namespace gnomon::viz
