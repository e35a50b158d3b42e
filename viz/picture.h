#pragma once

#include <filesystem>
#include <stdexcept>

#include "viz/shadow_result.h"

namespace gnomon {

/// There is no X display to render on. what() tells the user what to do.
class NoDisplayError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct PictureOptions {
  int width = 1280;  ///< pixels
  int height = 960;  ///< pixels
};

/// Draws lights, blockers, receivers and volumes, umbra inside penumbra, with a legend, and writes a PNG file.
///
/// The shadows that the volumes cast on each receiver are painted on it. A receiver that has the whole scene on one
/// side ends the volumes. Walls that hide the scene from the camera are drawn as outlines. A picture is no proof:
/// these cuts are made in doubles.
///
/// A scene of the plane becomes a drawing: the clip box with its regions filled, the extremal lines, light and blocker.
///
/// Requires: result.scene is not null; width and height at least 64.
/// Throws:   NoDisplayError; std::runtime_error naming the file that could not be written; PreconditionError.
void render_scene(const ShadowResult& result, const std::filesystem::path& png, const PictureOptions& options = {});

/// Draws the same picture of a folder that write_shadow has written as vtm or vtpc.
///
/// Throws: NoDisplayError; std::runtime_error naming the file that could not be read or written; PreconditionError.
void render_result(const std::filesystem::path& directory, const std::filesystem::path& png,
                   const PictureOptions& options = {});

}  // namespace gnomon
