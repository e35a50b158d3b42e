#pragma once

#include <string>

#include "gnomon/scene.h"

namespace gnomon {

/// Reads a scene file.
///
/// Throws: SceneError; for a mesh file one that tells a scene which holds it.
Scene scene_file(const std::string& file);

/// The same, with the scene's doubts as warnings: what every command but `check` begins with.
Scene scene_file_with_warnings(const std::string& file);

/// The same where lights and materials do not matter: without doubts about them.
Scene shapes_file_with_warnings(const std::string& file);

/// The same of space. Throws: UnsupportedError for a scene of the plane, in which the subject is not available.
SpaceScene space_scene_with_warnings(const std::string& file, const std::string& subject);

/// Prints the doubts as warnings: the first few, and how many more there are.
void print_doubts(const Scene& scene);

}  // namespace gnomon
