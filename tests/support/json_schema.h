#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace gnomon {

/// What becomes of keys that an object's schema does not list, where it says nothing of further ones.
enum class UnlistedKeys { allowed, refused };

/// The first reason why a document does not follow a schema, with its place as a JSON pointer; empty if it does.
///
/// Knows what the project's schemas are written in: type, const, enum, properties, required, additionalProperties,
/// items, anyOf, oneOf, $ref within the document, bounds of numbers, lengths, counts, and patterns.
///
/// Throws: std::invalid_argument for a schema that uses another keyword.
std::string schema_violation(const nlohmann::json& document, const nlohmann::json& schema,
                             UnlistedKeys unlisted = UnlistedKeys::allowed);

}  // namespace gnomon
