#include "viz/vtk/file_name.h"

#include <cstdint>

namespace gnomon::viz {
namespace {

constexpr std::string_view hex_digits = "0123456789ABCDEF";
constexpr std::size_t longest = 200;

bool stays(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
}

// FNV-1a: the same on every machine, as file names should be.
std::string hash(std::string_view name) {
  std::uint64_t value = 14695981039346656037u;
  for (const char c : name) value = (value ^ static_cast<unsigned char>(c)) * 1099511628211u;
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += hex_digits[(value >> shift) & 15u];
  return digits;
}

}  // namespace

std::string file_name(std::string_view name) {
  if (name.empty()) return "%";
  std::string part;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool hidden = part.empty() && c == '.';
    if (stays(c) && !hidden) {
      part += c;
    } else {
      part += {'%', hex_digits[byte >> 4], hex_digits[byte & 15]};
    }
  }
  // '~' is never written above, so a shortened name cannot meet a short one.
  if (part.size() > longest) part = part.substr(0, longest - 17) + '~' + hash(name);
  return part;
}

}  // namespace gnomon::viz
