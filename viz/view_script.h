#pragma once

#include <string_view>

namespace gnomon::viz {

/// The text of view.py, the ParaView script that lies beside every result.
std::string_view view_script();

}  // namespace gnomon::viz
