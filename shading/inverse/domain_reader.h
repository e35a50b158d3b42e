#pragma once

#include <string_view>

#include "geometry/scene/json_node.h"
#include "gnomon/light_design.h"

namespace gnomon::inverse {

/// Reads where a variable may be: an object with a "shape". What the shape asks of its vertices holds then.
///
/// Throws: SceneError.
DesignDomain read_domain(const JsonNode& node);

/// The number, if it is finite. Throws: SceneError.
double finite(const JsonNode& node, std::string_view expected);

}  // namespace gnomon::inverse
