#include "viz/vtk/xml.h"

#include <cstdint>

namespace gnomon::viz {
namespace {

/// Number of bytes of the character that begins with this one; 0 if none does.
std::size_t length_from(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

/// A character of several bytes as its number; 0 if the bytes are not one, or one that XML cannot hold.
std::uint32_t wide_character(std::string_view bytes) {
  std::uint32_t number = static_cast<unsigned char>(bytes[0]) & (0xffU >> (bytes.size() + 1));
  for (const char c : bytes.substr(1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0U) != 0x80U) return 0;
    number = number << 6U | (byte & 0x3fU);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = number >= 0xd800 && number < 0xe000;
  const bool is_none = number == 0xfffe || number == 0xffff || number > 0x10ffff;
  return number < least[bytes.size()] || is_surrogate || is_none ? 0 : number;
}

/// The first character of a text that is not empty, as it is written; it is taken from the text.
std::string escaped_character(std::string_view& text) {
  constexpr const char* replacement = "\xef\xbf\xbd";
  const auto byte = static_cast<unsigned char>(text.front());
  const std::size_t length = length_from(byte);
  if (length > 1 && length <= text.size() && wide_character(text.substr(0, length)) != 0) {
    const std::string character(text.substr(0, length));
    text.remove_prefix(length);
    return character;
  }
  text.remove_prefix(1);
  const bool is_control = byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r';
  if (length != 1 || is_control) return replacement;
  const bool is_special = byte < 0x20 || byte == '&' || byte == '<' || byte == '>' || byte == '"' || byte == '\'';
  return is_special ? "&#" + std::to_string(byte) + ";" : std::string(1, static_cast<char>(byte));
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  while (!text.empty()) escaped += escaped_character(text);
  return escaped;
}

}  // namespace gnomon::viz
