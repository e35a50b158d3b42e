#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viz/pictures/picture_camera.h"
#include "viz/pictures/picture_items.h"
#include "viz/pictures/picture_legend.h"
#include "viz/pictures/planar_drawing.h"

namespace gnomon::viz {

/// A scene in space as one HTML page that turns with the mouse and needs neither a network nor another file. three.js
/// and its OrbitControls are read from where the package libjs-three puts them, or from the folder that the
/// environment's GNOMON_THREE_JS names, and become part of the page.
///
/// Throws: std::runtime_error telling what to install, if three.js is not there.
std::string html_page(const PictureScene& scene, const PictureView& view, const Legend& legend,
                      const std::vector<PictureLabel>& labels);

/// A drawing of the plane as one HTML page that moves with the mouse; lines and elements say their names under it.
/// `lights` are those among which its reader chooses.
std::string html_page(const PlanarDrawing& drawing, const Legend& legend, const std::vector<std::string>& lights);

/// The text of page.html, with {{places}} for what a page shows.
std::string_view page_template();

/// The texts of the scripts of every page, and of those of space and of the plane.
std::string_view page_panel_script();
std::string_view page_space_script();
std::string_view page_plane_script();

/// Where three.js was found when this was built, or else where Debian's package libjs-three puts it.
std::string_view three_js_folder();

}  // namespace gnomon::viz
