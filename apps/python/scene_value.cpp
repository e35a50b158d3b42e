#include "apps/python/scene_value.h"

#include <utility>

#include "apps/python/document.h"
#include "geometry/scene/file_text.h"

namespace gnomon::python {
namespace {

using Json = nlohmann::ordered_json;

/// As much as the program reads.
constexpr std::size_t largest_file = std::size_t{64} << 20;

constexpr const char* of_python = "scene";

/// Reads and checks without the interpreter's lock.
std::shared_ptr<PreparedScene> prepared_from(const std::string& text, const std::string& source,
                                             const std::filesystem::path& folder) {
  const pybind11::gil_scoped_release release;
  return std::make_shared<PreparedScene>(parse_scene(text, source, folder));
}

/// A document with the same head and that element alone.
Json document_with(const Json& document, const char* list, Json element) {
  Json lone = document;
  for (const char* every : {"lights", "blockers", "receivers"}) lone[every] = Json::array();
  lone[list].push_back(std::move(element));
  return lone;
}

void require_free_name(const Json& elements, const Json& element, const std::string& title) {
  for (const Json& other : elements) {
    if (other["name"] != element["name"]) continue;
    throw SceneError(title +
                     ": found a name that an earlier element of the scene's list has, expected a name of its own");
  }
}

/// The head of a document is what is not in its lists: those may be long.
Json head_of(const Json& document) {
  Json head = Json::object();
  for (const auto& [key, value] : document.items()) {
    if (key != "lights" && key != "blockers" && key != "receivers") head[key] = value;
  }
  return head;
}

}  // namespace

SceneValue::SceneValue(Json document, std::string source, std::filesystem::path folder)
    : document_(std::move(document)), source_(std::move(source)), folder_(std::move(folder)) {
  prepared_ = prepared_from(document_.dump(), source_, folder_);
}

SceneValue::SceneValue(int dimension, const std::string& length_unit)
    : SceneValue(Json{{"gnomon", 1},
                      {"dimension", dimension},
                      {"length_unit", length_unit},
                      {"lights", Json::array()},
                      {"blockers", Json::array()},
                      {"receivers", Json::array()}},
                 of_python, ".") {}

SceneValue SceneValue::read(const std::filesystem::path& file) {
  FileText text = file_text(file, largest_file);
  if (!text.problem.empty()) throw SceneError(file.string() + ": found " + text.problem + "; expected a scene file");
  std::shared_ptr<PreparedScene> prepared = prepared_from(text.text, file.string(), file.parent_path());
  SceneValue scene(3, "m");
  scene.document_ = Json::parse(text.text);
  scene.source_ = file.string();
  scene.folder_ = file.parent_path();
  scene.prepared_ = std::move(prepared);
  return scene;
}

SceneValue SceneValue::from_dict(const pybind11::dict& document, const std::filesystem::path& folder) {
  return {json_of(document, ""), of_python, folder};
}

void SceneValue::add(const char* list, Json element) {
  const std::string title = std::string("add_") + std::string(list).substr(0, std::string(list).size() - 1);
  prepared_from(document_with(head_of(document_), list, element).dump(), title, folder_);
  Json& elements = document_[list];
  if (elements.is_null()) elements = Json::array();
  require_free_name(elements, element, title + ": \"" + element["name"].get<std::string>() + "\"");
  elements.push_back(std::move(element));
  ++changes_;
  prepared_.reset();
}

std::shared_ptr<PreparedScene> SceneValue::prepared() const {
  if (prepared_) return prepared_;
  const std::size_t changes = changes_;
  std::shared_ptr<PreparedScene> made = prepared_from(document_.dump(), source_, folder_);
  // Another thread may have added an element meanwhile; what was asked before that is answered without it.
  if (changes == changes_) prepared_ = made;
  return made;
}

}  // namespace gnomon::python
