#include "apps/python/bindings.h"

PYBIND11_MODULE(_gnomon, module) {
  using namespace gnomon::python;
  module.doc() = "Exact shadow geometry: the compiled part of the package gnomon.";
  module.attr("__version__") = GNOMON_VERSION;
  bind_errors(module);
  SceneClass scene(module, "Scene");
  bind_scene(scene);
  bind_points(module, scene);
  bind_radiance(module, scene);
  bind_receivers(module, scene);
  bind_pair(module, scene);
  bind_view_factors(module, scene);
  bind_place(scene);
  bind_illumination(module, scene);
  bind_partition(module, scene);
}
