#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/scene/json_node.h"

namespace gnomon {

/// The document of a glTF 2.0 file, as text or binary (GLB), and the bytes that it names.
///
/// Buffers stand in the file itself or beside it. Whatever a number in the document leads to is looked at before it is
/// used.
class GltfFile {
 public:
  /// `source` is how messages call the file, and outlives this.
  ///
  /// Throws: SceneError, with the JSON pointer of what is wrong; UnsupportedSceneError for versions but 2, for
  ///         extensions that a reader has to know and this one does not, and for buffers elsewhere.
  GltfFile(std::string_view bytes, const std::string& source, const std::filesystem::path& folder);

  JsonNode root() const { return {*document_, *source_}; }

  /// The items of a list of the document, "nodes" say; none where it has no such list.
  const std::vector<JsonNode>& list(const std::string& name) const;

  /// The item that an index leads to.
  const JsonNode& item(const JsonNode& index, const std::string& list_name) const;

  /// The numbers of an accessor of so many components each, floats as they are, one after the other.
  std::vector<double> numbers(const JsonNode& index, std::size_t components) const;

  /// The whole numbers of an accessor of scalars.
  std::vector<std::uint32_t> indices(const JsonNode& index) const;

 private:
  struct Accessor {
    JsonNode node;
    std::size_t count = 0;
    int component = 0;  ///< as glTF numbers types
    std::string type;   ///< "SCALAR", "VEC3", ...
    const unsigned char* data = nullptr;
    std::size_t stride = 0;
  };

  void read_buffers(std::string_view binary, const std::filesystem::path& folder);
  Accessor accessor(const JsonNode& index, std::size_t components) const;
  std::string_view buffer_view(const JsonNode& index) const;

  std::shared_ptr<const nlohmann::json> document_;
  const std::string* source_;
  std::map<std::string, std::vector<JsonNode>> lists_;
  std::vector<std::string> buffers_;
};

/// A whole number from 0 to below a limit.
std::size_t whole_number(const JsonNode& node, std::size_t limit, std::string_view expected);

}  // namespace gnomon
