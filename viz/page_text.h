#pragma once

#include <string_view>

namespace gnomon::viz {

/// The text of page.html, with {{places}} for what a page shows.
std::string_view page_template();

/// The texts of the scripts of every page, and of those of space and of the plane.
std::string_view page_panel_script();
std::string_view page_space_script();
std::string_view page_plane_script();

/// Where three.js was found when this was built, or else where Debian's package libjs-three puts it.
std::string_view three_js_folder();

}  // namespace gnomon::viz
