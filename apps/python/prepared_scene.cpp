#include "apps/python/prepared_scene.h"

#include <pybind11/stl.h>

#include <utility>

#include "apps/gnomon/commands.h"

namespace gnomon::python {

namespace py = pybind11;

PreparedScene::PreparedScene(Scene scene) : scene_(std::move(scene)) {}

const SpaceScene& PreparedScene::space(const char* subject) const {
  if (const auto* space = std::get_if<SpaceScene>(&scene_)) return *space;
  throw UnsupportedError(facts(scene_).source + ": " + subject +
                         " in scenes of dimension 2 is not available in this version");
}

void PreparedScene::make_ready() {
  if (is_ready_) return;
  const py::gil_scoped_release release;
  const std::lock_guard lock(mutex_);
  if (is_ready_) return;
  bodies_ = std::make_unique<SceneBodies>(scene_bodies(std::get<SpaceScene>(scene_)));
  obstacles_ = std::make_unique<PreparedObstacles>(bodies_->obstacles);
  is_ready_ = true;
}

const SceneBodies& PreparedScene::bodies() {
  make_ready();
  return *bodies_;
}

const PreparedObstacles& PreparedScene::obstacles() {
  make_ready();
  return *obstacles_;
}

AskedLights& PreparedScene::lights(const std::string& name) {
  const auto known = lights_.find(name);
  if (known != lights_.end()) return *known->second;
  const auto& space = std::get<SpaceScene>(scene_);
  auto asked = std::make_unique<AskedLights>();
  asked->groups = chosen_groups(space, name);
  asked->parts = parts_of(asked->groups);
  asked->names = py::tuple(py::cast(names_of(asked->groups)));
  return *lights_.emplace(name, std::move(asked)).first->second;
}

}  // namespace gnomon::python
