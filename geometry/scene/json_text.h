#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace gnomon {

/// Parses JSON from a source that is not trusted.
///
/// Requires: nothing; any bytes will do.
/// Returns:  a document of finite numbers, without duplicate keys, nested at most 16 levels deep.
/// Throws:   SceneError with line and column, and with the JSON pointer of the value at fault.
nlohmann::json parse_json(std::string_view text, const std::string& source);

/// The text in double quotes, with control characters escaped, and cut where it gets long.
std::string in_quotes(std::string_view text);

/// The token as it stands in a JSON pointer, printable.
std::string pointer_token(std::string_view key);

/// How messages speak of an element of a list: `light "lamp"`, or nothing if `list` is none of the lists of elements.
std::string element_title(std::string_view list, std::string_view name);

}  // namespace gnomon
