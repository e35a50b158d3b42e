#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {

/// How strongly a light shines: the key of the scene file, the number, and its SI unit.
struct Strength {
  std::string quantity;
  double value = 1;
  std::string unit;
};

/// What was recognised of one light, blocker or receiver.
struct RecognisedElement {
  std::string name;
  std::string shape;                    ///< as in the scene file
  std::optional<std::size_t> vertices;  ///< all but directions
  std::optional<std::size_t> holes;     ///< polygons that have any
  std::optional<std::size_t> facets;    ///< meshes only
  std::optional<bool> closed;           ///< meshes only
  std::optional<bool> two_sided;        ///< polygon lights only
  std::optional<Strength> strength;     ///< lights only
  std::optional<double> flux;           ///< [W], lights of space but directions
};

struct RecognisedElements {
  std::vector<RecognisedElement> lights;
  std::vector<RecognisedElement> blockers;
  std::vector<RecognisedElement> receivers;
};

/// Every element of a scene, in file order.
RecognisedElements recognised_elements(const Scene& scene);

}  // namespace gnomon
