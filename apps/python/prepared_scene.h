#pragma once

/// A scene that was read, made ready for questions from many threads.

#include <pybind11/pybind11.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "apps/gnomon/light_groups.h"
#include "gnomon/irradiance.h"
#include "gnomon/light_parts.h"
#include "gnomon/reflection.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"

namespace gnomon::python {

/// Objects that one thread at a time may use, kept for the next question.
template <class Worker>
class Pool {
 public:
  /// Workers as many as there are threads; `make` makes those that are missing.
  template <class Make>
  std::vector<std::unique_ptr<Worker>> take(unsigned count, const Make& make) {
    std::vector<std::unique_ptr<Worker>> taken;
    {
      const std::lock_guard lock(mutex_);
      while (taken.size() < count && !idle_.empty()) {
        taken.push_back(std::move(idle_.back()));
        idle_.pop_back();
      }
    }
    while (taken.size() < count) taken.push_back(make());
    return taken;
  }

  void give_back(std::vector<std::unique_ptr<Worker>> workers) {
    const std::lock_guard lock(mutex_);
    for (auto& worker : workers) idle_.push_back(std::move(worker));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Worker>> idle_;
};

/// Some lights of a scene of space: by which names results call them, and who answers.
struct AskedLights {
  std::vector<LightGroup> groups;
  std::vector<const SceneLight*> parts;
  pybind11::tuple names;
  Pool<std::vector<PartsVisibility>> visibilities;  ///< of every group
  Pool<std::vector<LightIrradiance>> irradiances;   ///< of every part
  Pool<std::vector<LightReflection>> reflections;   ///< of every part
};

/// What is made of a scene once.
class PreparedScene {
 public:
  explicit PreparedScene(Scene scene);

  const Scene& scene() const { return scene_; }
  /// Throws: UnsupportedError for a scene of the plane.
  const SpaceScene& space(const char* subject) const;

  /// Bodies and obstacles of a scene of space; made when first asked for, without the interpreter's lock.
  const SceneBodies& bodies();
  const PreparedObstacles& obstacles();

  /// The lights of that name, all without one. Requires: a scene of space; the interpreter's lock.
  /// Throws: UsageError for a name that the scene does not have.
  AskedLights& lights(const std::string& name);

 private:
  void make_ready();

  Scene scene_;
  std::mutex mutex_;
  std::unique_ptr<SceneBodies> bodies_;
  std::unique_ptr<PreparedObstacles> obstacles_;
  std::atomic<bool> is_ready_ = false;  ///< both of these are made
  std::map<std::string, std::unique_ptr<AskedLights>, std::less<>> lights_;
};

}  // namespace gnomon::python
