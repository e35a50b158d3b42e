#pragma once

/// Scenes as Python has them: a document that grows, and what is made of it when it is asked.

#include <pybind11/pybind11.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/python/prepared_scene.h"

namespace gnomon::python {

class SceneValue {
 public:
  /// A scene without elements. Throws: SceneError for a dimension or a unit that there is not.
  SceneValue(int dimension, const std::string& length_unit);

  /// Throws: SceneError.
  static SceneValue read(const std::filesystem::path& file);

  /// `folder` is where mesh files are looked up. Throws: SceneError, ArgumentError.
  static SceneValue from_dict(const pybind11::dict& document, const std::filesystem::path& folder);

  const nlohmann::ordered_json& document() const { return document_; }

  /// Adds an element to one of the lists; it is checked by itself first.
  ///
  /// Throws: SceneError for an element that makes no sense, or a name that is taken: nothing is added then.
  void add(const char* list, nlohmann::ordered_json element);

  /// The scene as it is now. Throws: SceneError.
  std::shared_ptr<PreparedScene> prepared() const;

 private:
  SceneValue(nlohmann::ordered_json document, std::string source, std::filesystem::path folder);

  nlohmann::ordered_json document_;
  std::string source_;
  std::filesystem::path folder_;
  std::size_t changes_ = 0;
  mutable std::shared_ptr<PreparedScene> prepared_;  ///< none after a change
};

}  // namespace gnomon::python
