#pragma once

#include <set>
#include <string>
#include <string_view>

namespace gnomon {

/// The materials of an MTL file that emit light: whose key Ke is followed by a number other than 0. Anything else in
/// the file is passed over, whatever it is.
std::set<std::string> emitting_materials(std::string_view text);

}  // namespace gnomon
