#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace gnomon {

/// Number of fields that readers of CSV (RFC 4180, as spreadsheets and Python read it) find in a row that is written
/// with commas: a double quote opens a quoted field only where the field begins, and "" inside of one is a quote.
/// Nothing if a quoted field does not end, which would swallow the rows below, or if the row holds control characters.
std::optional<std::size_t> csv_field_count(std::string_view row);

}  // namespace gnomon
