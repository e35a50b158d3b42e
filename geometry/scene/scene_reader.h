#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "geometry/scene/scene.h"

namespace gnomon {

/// A scene file that cannot be read. what() is the whole message for the user: file, JSON pointer (or line and
/// column where the text is no JSON), element name if it has one, what was found, what was expected.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A scene file that makes sense, but asks for what this version cannot do.
class UnsupportedSceneError : public SceneError {
 public:
  using SceneError::SceneError;
};

/// Reads and checks a scene file.
///
/// Throws: SceneError for everything that is wrong with the file; nothing else.
Scene read_scene(const std::filesystem::path& file);

/// Reads and checks a scene from text. `source` names it in messages; mesh files are looked up in `folder`.
///
/// Throws: SceneError.
Scene parse_scene(std::string_view text, const std::string& source, const std::filesystem::path& folder);

/// The scene that is built into the program: [P93] Figure 4.22, a triangular light above a rectangular blocker, with
/// a floor.
std::string_view default_scene_text();

}  // namespace gnomon
