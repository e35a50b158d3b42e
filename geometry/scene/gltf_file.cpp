#include "geometry/scene/gltf_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "geometry/scene/file_text.h"
#include "geometry/scene/json_text.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

constexpr std::size_t largest_buffer = std::size_t{512} << 20;
constexpr std::size_t many = std::size_t{1} << 40;

constexpr int unsigned_byte = 5121, unsigned_short = 5123, unsigned_int = 5125, float_component = 5126;

/// Extensions without which a file may not be read, and that are known or change nothing here.
constexpr std::array<std::string_view, 5> known_extensions = {"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                                              "KHR_materials_unlit", "KHR_texture_transform",
                                                              "KHR_materials_specular"};

std::uint32_t four_bytes_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
  return value;
}

[[noreturn]] void refuse_container(const std::string& source, const std::string& found) {
  throw SceneError(source + ": found " + found + "; expected a glTF file: JSON, or the binary form GLB of version 2");
}

/// The chunks of a GLB file: its JSON and its bytes.
std::pair<std::string_view, std::string_view> chunks_of(std::string_view bytes, const std::string& source) {
  constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
  if (bytes.size() < 20 || four_bytes_at(bytes, 4) != 2)
    refuse_container(source, "a GLB head of another version, or cut off");
  std::string_view json, binary;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::size_t size = four_bytes_at(bytes, at);
    const std::uint32_t kind = four_bytes_at(bytes, at + 4);
    if (size > bytes.size() - at - 8) refuse_container(source, "a chunk that is cut off at byte " + std::to_string(at));
    const std::string_view chunk = bytes.substr(at + 8, size);
    if (kind == json_chunk && json.empty()) json = chunk;
    if (kind == binary_chunk && binary.empty()) binary = chunk;
    at += 8 + size;
  }
  if (json.empty()) refuse_container(source, "no chunk of JSON");
  return {json, binary};
}

int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' || c == '-' ? 62 : c == '/' || c == '_' ? 63 : -1;
}

/// The bytes that base64 stands for; nothing if it is none.
std::optional<std::string> decoded(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const int value = base64_value(c);
    if (value < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFF);
  }
  return bytes;
}

/// A relative URI as the name of a file: "%20" is a blank.
std::string file_of(std::string_view uri) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  std::string name;
  for (std::size_t k = 0; k < uri.size(); ++k) {
    const bool is_escaped = uri[k] == '%' && k + 2 < uri.size() && digit(uri[k + 1]) >= 0 && digit(uri[k + 2]) >= 0;
    name += is_escaped ? static_cast<char>(16 * digit(uri[k + 1]) + digit(uri[k + 2])) : uri[k];
    if (is_escaped) k += 2;
  }
  return name;
}

std::string bytes_of(const JsonNode& uri, const std::filesystem::path& folder) {
  const std::string text = uri.string("a URI");
  if (text.starts_with("data:")) {
    const std::size_t comma = text.find(";base64,");
    const auto bytes = comma == std::string::npos ? std::nullopt : decoded(std::string_view(text).substr(comma + 8));
    if (!bytes) uri.refuse("data that are not in base64", "\"data:application/octet-stream;base64,...\"");
    return *bytes;
  }
  const std::filesystem::path name(file_of(text));
  const bool leaves = name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end();
  if (text.find("://") != std::string::npos || leaves) {
    uri.refuse_as_unsupported(in_quotes(text), "a file beside the glTF file: no address, no absolute path, no \"..\"");
  }
  FileText file = file_text(folder / name, largest_buffer, FileKind::regular);
  if (!file.problem.empty()) uri.refuse(file.problem + " of the name " + in_quotes(text), "a file of bytes");
  return std::move(file.text);
}

std::size_t size_of_component(int component) {
  switch (component) {
    case 5120:
    case unsigned_byte:
      return 1;
    case 5122:
    case unsigned_short:
      return 2;
    case unsigned_int:
    case float_component:
      return 4;
    default:
      return 0;
  }
}

void require_known_version(const JsonNode& root) {
  const JsonNode asset = root.required("asset", "an object with the version of glTF");
  const std::string version = asset.required("version", "\"2.0\"").string("\"2.0\"");
  if (!version.starts_with("2.")) asset.refuse_as_unsupported("version " + in_quotes(version), "\"2.0\"");
  const auto required = root.optional("extensionsRequired");
  if (!required) return;
  for (const JsonNode& item : required->items("an array of names")) {
    const std::string name = item.string("the name of an extension");
    if (std::ranges::find(known_extensions, name) == known_extensions.end()) {
      item.refuse_as_unsupported("the extension " + in_quotes(name), "a file that can be read without it");
    }
  }
}

}  // namespace

std::size_t whole_number(const JsonNode& node, std::size_t limit, std::string_view expected) {
  const double value = node.number(expected);
  if (!(value >= 0 && value < static_cast<double>(limit)) || value != std::floor(value)) node.refuse_value(expected);
  return static_cast<std::size_t>(value);
}

GltfFile::GltfFile(std::string_view bytes, const std::string& source, const std::filesystem::path& folder)
    : source_(&source) {
  std::string_view json = bytes, binary;
  if (bytes.starts_with("glTF")) std::tie(json, binary) = chunks_of(bytes, source);
  document_ = std::make_shared<const nlohmann::json>(parse_json(json, source));
  root().require_object("a glTF document");
  require_known_version(root());
  for (const char* name :
       {"accessors", "buffers", "bufferViews", "cameras", "materials", "meshes", "nodes", "scenes"}) {
    const auto found = root().optional(name);
    lists_[name] = found ? found->items("an array") : std::vector<JsonNode>();
  }
  read_buffers(binary, folder);
}

void GltfFile::read_buffers(std::string_view binary, const std::filesystem::path& folder) {
  for (const JsonNode& buffer : list("buffers")) {
    const std::size_t size =
        whole_number(buffer.required("byteLength", "a number of bytes"), many, "a number of bytes");
    const auto uri = buffer.optional("uri");
    std::string bytes = uri ? bytes_of(*uri, folder) : std::string(buffers_.empty() ? binary : std::string_view());
    if (bytes.size() < size) {
      buffer.refuse("a buffer of " + std::to_string(bytes.size()) + " bytes", std::to_string(size) + " as announced");
    }
    buffers_.push_back(std::move(bytes));
  }
}

const std::vector<JsonNode>& GltfFile::list(const std::string& name) const {
  return lists_.at(name);
}

const JsonNode& GltfFile::item(const JsonNode& index, const std::string& list_name) const {
  const std::vector<JsonNode>& all = list(list_name);
  const std::string expected = "an index of one of the " + std::to_string(all.size()) + " " + list_name;
  return all[whole_number(index, all.size(), expected)];
}

std::string_view GltfFile::buffer_view(const JsonNode& index) const {
  const JsonNode view = item(index, "bufferViews");
  const std::size_t buffer =
      whole_number(view.required("buffer", "the index of a buffer"), buffers_.size(), "the index of a buffer");
  const auto offset = view.optional("byteOffset");
  const std::size_t from = offset ? whole_number(*offset, many, "a number of bytes") : 0;
  const std::size_t size = whole_number(view.required("byteLength", "a number of bytes"), many, "a number of bytes");
  if (from > buffers_[buffer].size() || size > buffers_[buffer].size() - from) {
    view.refuse("bytes beyond the end of the buffer", "at most its " + std::to_string(buffers_[buffer].size()));
  }
  return std::string_view(buffers_[buffer]).substr(from, size);
}

GltfFile::Accessor GltfFile::accessor(const JsonNode& index, std::size_t components) const {
  Accessor found{item(index, "accessors"), 0, 0, {}, nullptr, 0};
  const JsonNode& node = found.node;
  if (const auto sparse = node.optional("sparse")) sparse->refuse_as_unsupported("a sparse accessor", "a dense one");
  found.count =
      whole_number(node.required("count", "a number of elements"), std::size_t{1} << 31, "a number of elements");
  found.component =
      static_cast<int>(whole_number(node.required("componentType", "a type of numbers"), 10000, "a type of numbers"));
  found.type = node.required("type", "a type of elements").string("a type of elements");
  const std::size_t size = size_of_component(found.component) * components;
  if (size == 0) node.refuse("the component type " + std::to_string(found.component), "5120 to 5123, 5125 or 5126");
  const auto view = node.optional("bufferView");
  if (!view) node.refuse_as_unsupported("an accessor without a buffer view", "one with the index of a buffer view");
  const std::string_view bytes = buffer_view(*view);
  const auto offset = node.optional("byteOffset");
  const std::size_t from = offset ? whole_number(*offset, many, "a number of bytes") : 0;
  const auto stride = item(*view, "bufferViews").optional("byteStride");
  found.stride = stride ? whole_number(*stride, 253, "a number of bytes below 253") : size;
  const std::size_t needed = found.count == 0 ? 0 : (found.count - 1) * found.stride + size;
  if (from > bytes.size() || needed > bytes.size() - from) {
    node.refuse("elements beyond the end of the buffer view", "at most its " + std::to_string(bytes.size()) + " bytes");
  }
  found.data = reinterpret_cast<const unsigned char*>(bytes.data()) + from;
  return found;
}

std::vector<double> GltfFile::numbers(const JsonNode& index, std::size_t components) const {
  const Accessor from = accessor(index, components);
  const std::string type = components == 1 ? "SCALAR" : "VEC" + std::to_string(components);
  if (from.type != type || from.component != float_component) {
    from.node.refuse("elements of another type", "floats (5126) of the type \"" + type + "\"");
  }
  std::vector<double> all(from.count * components, 0.0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    float value = 0;
    std::memcpy(&value, from.data + i / components * from.stride + i % components * sizeof value, sizeof value);
    if (!std::isfinite(value))
      from.node.refuse("a number that is not finite at element " + std::to_string(i / components), "finite numbers");
    all[i] = value;
  }
  return all;
}

std::vector<std::uint32_t> GltfFile::indices(const JsonNode& index) const {
  const Accessor from = accessor(index, 1);
  const std::size_t size = size_of_component(from.component);
  const bool is_unsigned =
      from.component == unsigned_byte || from.component == unsigned_short || from.component == unsigned_int;
  if (from.type != "SCALAR" || !is_unsigned) {
    from.node.refuse("elements of another type", "unsigned numbers of the type \"SCALAR\"");
  }
  std::vector<std::uint32_t> all(from.count, 0);
  for (std::size_t i = 0; i < all.size(); ++i) std::memcpy(&all[i], from.data + i * from.stride, size);
  return all;
}

}  // namespace gnomon
