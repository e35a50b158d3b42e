#pragma once

/// Scenes that tests of pictures share.

#include <array>
#include <string>

#include "gnomon/scene.h"

namespace gnomon::test_support {

inline const std::string image_materials = R"("materials": [
  {"name": "chalk", "diffuse": 0.8, "ambient": 0.5},
  {"name": "lacquer", "diffuse": [0.4, 0.2, 0.1], "specular": 0.4, "exponent": 20},
  {"name": "brass", "model": "blinn", "diffuse": 0.1, "specular": [0.6, 0.5, 0.2], "exponent": 30},
  {"name": "old", "model": "phong_classic", "diffuse": 0.3, "specular": 0.9, "exponent": 9}],)";

inline std::string image_scene(const std::string& lights) {
  return R"({"gnomon": 1, "dimension": 3, "ambient_radiance": 0.25, )" + image_materials + R"(
    "camera": {"eye": [3, -7, 4], "look_at": [0, 0, 0.5], "fov": 30, "width": 24, "height": 18},
    "lights": [)" +
         lights + R"(],
    "blockers": [
      {"name": "box", "shape": "polytope", "material": "lacquer", "vertices": [[-1,-1,0], [0,-1,0], [0,0,0], [-1,0,0],
        [-1,-1,1], [0,-1,1], [0,0,1], [-1,0,1]]},
      {"name": "board", "shape": "polygon", "material": "brass", "vertices": [[0.5,-1,0.2], [1.5,-0.8,0.9], [1,0.5,0.7]]},
      {"name": "arrow", "shape": "concave_polygon", "material": "old",
       "vertices": [[-1,1,0.2], [2,1,0.2], [0.5,1,0.7], [0.5,1,1.7]]}],
    "receivers": [
      {"name": "floor", "shape": "polygon", "material": "chalk", "vertices": [[-4,-4,0], [4,-4,0], [4,4,0], [-4,4,0]]}]})";
}

/// An area light, a linear light between flaps, and everything together.
inline const std::array<std::string, 3> image_lights = {
    R"({"name": "lamp", "shape": "polygon", "vertices": [[-1,-2,3], [-1,0,3], [1,0,3.5], [1,-2,3.5]], "radiance": 2})",
    R"({"name": "tube", "shape": "segment", "vertices": [[-2,-2,3], [2,-1,2]], "intensity_per_length": 3,
        "color": [1, 0.8, 0.5], "emission": {"profile": "cosine", "exponent": 2}, "flaps": {"angle": 50}})",
    R"({"name": "lamp", "shape": "polygon", "vertices": [[2,-2,3], [2,1,2], [3,0,3]], "two_sided": true},
       {"name": "tube", "shape": "segment", "vertices": [[-3,0,0.5], [-3,0,3]]},
       {"name": "bulb", "shape": "point", "position": [0,-4,3], "intensity": 9},
       {"name": "sun", "shape": "direction", "direction": [1,2,-2], "irradiance": 0.5})"};

}  // namespace gnomon::test_support
