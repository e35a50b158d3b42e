#pragma once

#include <string_view>

namespace gnomon::viz {

/// The text of page.html, with {{places}} for what a page shows.
std::string_view page_template();

/// The text of page.js, the page's own script.
std::string_view page_script();

/// Where three.js was found when this was built, or else where Debian's package libjs-three puts it.
std::string_view three_js_folder();

}  // namespace gnomon::viz
