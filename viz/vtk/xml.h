#pragma once

#include <string>
#include <string_view>

namespace gnomon::viz {

/// The text as the value of an XML attribute, or as text of an element, of HTML too. What XML cannot hold (control
/// characters, bytes that are not UTF-8, U+FFFE and U+FFFF) becomes U+FFFD.
std::string xml_escaped(std::string_view text);

}  // namespace gnomon::viz
