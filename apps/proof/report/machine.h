#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gnomon::report {

/// What the figures were measured on and with: names and values, in order.
std::vector<std::pair<std::string, std::string>> machine();

}  // namespace gnomon::report
