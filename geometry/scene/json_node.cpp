#include "geometry/scene/json_node.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "geometry/scene/json_text.h"
#include "gnomon/scene.h"

namespace gnomon {

JsonNode JsonNode::as_element(std::string title) const {
  JsonNode node = *this;
  node.element_ = std::move(title);
  return node;
}

JsonNode JsonNode::child(const nlohmann::json& value, const std::string& token) const {
  JsonNode node = *this;
  node.value_ = &value;
  node.pointer_ += "/" + token;
  return node;
}

JsonNode JsonNode::required(std::string_view key, std::string_view expected) const {
  const auto found = value_->find(key);
  if (found == value_->end()) child(*value_, pointer_token(key)).refuse("no such key", expected);
  return child(*found, pointer_token(key));
}

std::optional<JsonNode> JsonNode::optional(std::string_view key) const {
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return child(*found, pointer_token(key));
}

std::vector<JsonNode> JsonNode::items(std::string_view expected) const {
  if (!value_->is_array()) refuse_value(expected);
  std::vector<JsonNode> nodes;
  nodes.reserve(value_->size());
  for (const nlohmann::json& item : *value_) nodes.push_back(child(item, std::to_string(nodes.size())));
  return nodes;
}

void JsonNode::require_object(std::string_view expected) const {
  if (!value_->is_object()) refuse_value(expected);
}

void JsonNode::allow_keys(std::span<const std::string_view> keys, std::string_view what) const {
  for (const auto& [key, value] : value_->items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    child(value, pointer_token(key))
        .refuse("the unknown key " + in_quotes(key), std::string(what) + " with keys among " + listed(keys));
  }
}

std::string JsonNode::string(std::string_view expected) const {
  if (!value_->is_string()) refuse_value(expected);
  return value_->get<std::string>();
}

bool JsonNode::boolean(std::string_view expected) const {
  if (!value_->is_boolean()) refuse_value(expected);
  return value_->get<bool>();
}

double JsonNode::number(std::string_view expected) const {
  if (!value_->is_number()) refuse_value(expected);
  return value_->get<double>();
}

bool JsonNode::is_number(int value) const {
  return value_->is_number() && *value_ == value;
}

std::string JsonNode::description() const {
  if (value_->is_string()) return "the string " + in_quotes(value_->get_ref<const std::string&>());
  if (value_->is_number_unsigned()) return "the number " + std::to_string(value_->get<std::uint64_t>());
  if (value_->is_number_integer()) return "the number " + std::to_string(value_->get<std::int64_t>());
  if (value_->is_number()) return "the number " + shortest(value_->get<double>());
  if (value_->is_array()) return "an array of " + std::to_string(value_->size());
  if (value_->is_object()) return "an object";
  if (value_->is_boolean()) return value_->get<bool>() ? "true" : "false";
  return "null";
}

std::string JsonNode::message(std::string_view found, std::string_view expected) const {
  std::string text = *source_ + ": " + (pointer_.empty() ? "the whole document" : pointer_) + ": ";
  if (!element_.empty()) text += element_ + ": ";
  return text.append("found ").append(found).append("; expected ").append(expected);
}

void JsonNode::refuse(std::string_view found, std::string_view expected) const {
  throw SceneError(message(found, expected));
}

void JsonNode::refuse_as_unsupported(std::string_view found, std::string_view expected) const {
  throw UnsupportedSceneError(message(found, expected));
}

std::string few_digits(double value) {
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 6).ptr;
  return {digits.data(), end};
}

std::string shortest(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string listed(std::span<const std::string_view> words) {
  std::string result;
  for (const std::string_view word : words) result += (result.empty() ? "\"" : ", \"") + std::string(word) + '"';
  return result;
}

}  // namespace gnomon
