#pragma once

#include <string>
#include <string_view>

namespace gnomon::viz {

/// A name as part of a path: letters, digits, '-', '_' and inner dots stay, every other byte becomes %XX.
/// Different names give different parts; a part is at most 200 bytes long (longer ones end in a hash of the name).
std::string file_name(std::string_view name);

}  // namespace gnomon::viz
