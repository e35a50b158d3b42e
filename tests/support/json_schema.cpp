#include "tests/support/json_schema.h"

#include <algorithm>
#include <array>
#include <regex>
#include <stdexcept>

namespace gnomon {
namespace {

using nlohmann::json;

bool has_type(const json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

/// In characters, not bytes.
std::size_t character_count(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

class Validator {
 public:
  Validator(const json& root, UnlistedKeys unlisted) : root_(root), unlisted_(unlisted) {}

  /// Empty if the value follows the schema.
  std::string violation(const json& value, const json& schema, const std::string& place) const {
    require_known(schema);
    if (schema.contains("$ref"))
      return violation(value, root_.at(json::json_pointer(pointer_of(schema["$ref"]))), place);
    for (const auto check : {&Validator::kind, &Validator::number, &Validator::text, &Validator::list,
                             &Validator::object, &Validator::choices}) {
      const std::string found = (this->*check)(value, schema, place);
      if (!found.empty()) return found;
    }
    if (!schema.contains("not") || !violation(value, schema["not"], place).empty()) return {};
    return at(place, "is what it must not be: " + schema["not"].dump());
  }

 private:
  static std::string pointer_of(const std::string& reference) {
    if (!reference.starts_with("#/")) throw std::invalid_argument("a reference to elsewhere: " + reference);
    return reference.substr(1);
  }

  static void require_known(const json& schema) {
    constexpr std::array known = {"$schema",
                                  "$id",
                                  "$defs",
                                  "$ref",
                                  "title",
                                  "description",
                                  "default",
                                  "type",
                                  "const",
                                  "enum",
                                  "minimum",
                                  "maximum",
                                  "minLength",
                                  "maxLength",
                                  "pattern",
                                  "minItems",
                                  "maxItems",
                                  "items",
                                  "properties",
                                  "required",
                                  "additionalProperties",
                                  "anyOf",
                                  "oneOf",
                                  "not",
                                  "exclusiveMinimum",
                                  "exclusiveMaximum"};
    for (const auto& [key, value] : schema.items()) {
      if (std::find(known.begin(), known.end(), key) == known.end()) throw std::invalid_argument("keyword " + key);
    }
  }

  static std::string at(const std::string& place, const std::string& what) {
    return (place.empty() ? "the document" : place) + ": " + what;
  }

  std::string kind(const json& value, const json& schema, const std::string& place) const {
    if (schema.contains("type")) {
      const json types = schema["type"].is_array() ? schema["type"] : json::array({schema["type"]});
      const auto fits = [&](const json& type) { return has_type(value, type); };
      if (std::none_of(types.begin(), types.end(), fits)) return at(place, "is no " + types.dump());
    }
    if (schema.contains("const") && value != schema["const"]) return at(place, "is not " + schema["const"].dump());
    if (!schema.contains("enum")) return {};
    const json& list = schema["enum"];
    return std::find(list.begin(), list.end(), value) == list.end() ? at(place, "is none of " + list.dump()) : "";
  }

  std::string number(const json& value, const json& schema, const std::string& place) const {
    if (!value.is_number()) return {};
    const double x = value;
    if (schema.contains("minimum") && x < schema["minimum"].get<double>()) return at(place, "is too small");
    if (schema.contains("maximum") && x > schema["maximum"].get<double>()) return at(place, "is too large");
    if (schema.contains("exclusiveMinimum") && x <= schema["exclusiveMinimum"].get<double>())
      return at(place, "is too small");
    if (schema.contains("exclusiveMaximum") && x >= schema["exclusiveMaximum"].get<double>())
      return at(place, "is too large");
    return {};
  }

  std::string text(const json& value, const json& schema, const std::string& place) const {
    if (!value.is_string()) return {};
    const std::string& x = value.get_ref<const std::string&>();
    if (schema.contains("minLength") && character_count(x) < schema["minLength"]) return at(place, "is too short");
    if (schema.contains("maxLength") && character_count(x) > schema["maxLength"]) return at(place, "is too long");
    if (!schema.contains("pattern")) return {};
    const std::string pattern = schema["pattern"];
    return std::regex_search(x, std::regex(pattern)) ? "" : at(place, "does not match " + pattern);
  }

  std::string list(const json& value, const json& schema, const std::string& place) const {
    if (!value.is_array()) return {};
    if (schema.contains("minItems") && value.size() < schema["minItems"]) return at(place, "has too few items");
    if (schema.contains("maxItems") && value.size() > schema["maxItems"]) return at(place, "has too many items");
    if (!schema.contains("items")) return {};
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string found = violation(value[i], schema["items"], place + '/' + std::to_string(i));
      if (!found.empty()) return found;
    }
    return {};
  }

  std::string object(const json& value, const json& schema, const std::string& place) const {
    if (!value.is_object()) return {};
    for (const json& key : schema.value("required", json::array())) {
      if (!value.contains(key)) return at(place, "has no " + key.dump());
    }
    const json properties = schema.value("properties", json::object());
    const bool closed = unlisted_ == UnlistedKeys::refused && schema.contains("properties");
    const json further = schema.value("additionalProperties", json(!closed));
    for (const auto& [key, item] : value.items()) {
      const json& rule = properties.contains(key) ? properties[key] : further;
      if (rule == json(false)) return at(place, "has the unlisted key " + json(key).dump());
      if (!rule.is_object()) continue;
      const std::string found = violation(item, rule, place + '/' + key);
      if (!found.empty()) return found;
    }
    return {};
  }

  std::string choices(const json& value, const json& schema, const std::string& place) const {
    for (const char* keyword : {"anyOf", "oneOf"}) {
      if (!schema.contains(keyword)) continue;
      std::size_t fitting = 0;
      std::string reasons;
      for (const json& choice : schema[keyword]) {
        const std::string found = violation(value, choice, place);
        if (found.empty()) ++fitting;
        reasons += (reasons.empty() ? "" : " | ") + found;
      }
      if (fitting == 0) return at(place, "fits no choice: " + reasons);
      if (fitting > 1 && keyword == std::string("oneOf")) return at(place, "fits several choices");
    }
    return {};
  }

  const json& root_;
  UnlistedKeys unlisted_;
};

}  // namespace

std::string schema_violation(const json& document, const json& schema, UnlistedKeys unlisted) {
  return Validator(schema, unlisted).violation(document, schema, "");
}

}  // namespace gnomon
