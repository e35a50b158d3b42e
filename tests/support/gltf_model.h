#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += at + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

/// A glTF document in the making: one buffer, an accessor and a view for each list that is added.
class GltfModel {
 public:
  nlohmann::json document = {{"asset", {{"version", "2.0"}}},
                             {"accessors", nlohmann::json::array()},
                             {"bufferViews", nlohmann::json::array()}};
  std::string bytes;

  /// Returns the accessor's index.
  template <class Value>
  std::size_t add(const std::vector<Value>& values, int component, const std::string& type, std::size_t components) {
    while (bytes.size() % 4 != 0) bytes += '\0';
    document["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * sizeof(Value)}});
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
    document["accessors"].push_back({{"bufferView", document["bufferViews"].size() - 1},
                                     {"componentType", component},
                                     {"count", values.size() / components},
                                     {"type", type}});
    return document["accessors"].size() - 1;
  }
  std::size_t points(const std::vector<float>& values) { return add(values, 5126, "VEC3", 3); }

  /// A mesh of one primitive. Returns its index.
  std::size_t mesh(nlohmann::json primitive) {
    document["meshes"].push_back({{"primitives", {std::move(primitive)}}});
    return document["meshes"].size() - 1;
  }

  void node(nlohmann::json node) { document["nodes"].push_back(std::move(node)); }

  /// With the buffer in the document.
  std::string text() const {
    nlohmann::json whole = document;
    whole["buffers"] = {
        {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
    return whole.dump();
  }

  /// With the buffer in a file of that name.
  std::string text_with_buffer(const std::string& uri) const {
    nlohmann::json whole = document;
    whole["buffers"] = {{{"byteLength", bytes.size()}, {"uri", uri}}};
    return whole.dump();
  }

  std::string binary() const {
    nlohmann::json whole = document;
    whole["buffers"] = {{{"byteLength", bytes.size()}}};
    std::string json = whole.dump(), data = bytes;
    json.resize((json.size() + 3) / 4 * 4, ' ');
    data.resize((data.size() + 3) / 4 * 4, '\0');
    const auto number = [](std::size_t value) {
      std::string four;
      for (int k = 0; k < 4; ++k) four += static_cast<char>(value >> (8 * k) & 0xFF);
      return four;
    };
    return "glTF" + number(2) + number(28 + json.size() + data.size()) + number(json.size()) + "JSON" + json +
           number(data.size()) + std::string("BIN\0", 4) + data;
  }
};

}  // namespace gnomon
