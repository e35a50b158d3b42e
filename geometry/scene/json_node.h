#pragma once

#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// A value of the scene file and where it stands. Whatever is asked of it and does not hold is refused with file, JSON
/// pointer, element name, what was found and what was expected.
class JsonNode {
 public:
  /// The whole document. Both arguments outlive the node.
  JsonNode(const nlohmann::json& document, const std::string& source) : value_(&document), source_(&source) {}

  /// The same node, spoken of as an element: `light "lamp"`.
  JsonNode as_element(std::string title) const;

  /// The value of a key of this object.
  JsonNode required(std::string_view key, std::string_view expected) const;
  std::optional<JsonNode> optional(std::string_view key) const;

  /// The items of this array.
  std::vector<JsonNode> items(std::string_view expected) const;

  void require_object(std::string_view expected) const;

  /// Refuses every key of this object that is not listed. `what` names the object: "a point light".
  void allow_keys(std::span<const std::string_view> keys, std::string_view what) const;
  void allow_keys(std::initializer_list<std::string_view> keys, std::string_view what) const {
    allow_keys(std::span(keys.begin(), keys.size()), what);
  }

  std::string string(std::string_view expected) const;
  bool boolean(std::string_view expected) const;
  double number(std::string_view expected) const;

  bool is_number(int value) const;

  /// The value in words: `the string "lamp"`, `the number 3`, `an array of 4`.
  std::string description() const;

  [[noreturn]] void refuse(std::string_view found, std::string_view expected) const;
  /// The same for what makes sense, but is not available: UnsupportedSceneError.
  [[noreturn]] void refuse_as_unsupported(std::string_view found, std::string_view expected) const;
  [[noreturn]] void refuse_value(std::string_view expected) const { refuse(description(), expected); }

 private:
  JsonNode child(const nlohmann::json& value, const std::string& token) const;
  std::string message(std::string_view found, std::string_view expected) const;

  const nlohmann::json* value_;
  const std::string* source_;
  std::string pointer_;
  std::string element_;
};

/// The shortest decimal number that reads back as the same double.
std::string shortest(double value);

/// The number for people: 6 digits.
std::string few_digits(double value);

/// Words in quotes, separated by commas.
std::string listed(std::span<const std::string_view> words);

}  // namespace gnomon
