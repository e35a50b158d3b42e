#pragma once

#include <cstdint>

namespace gnomon {

/// Index of a vertex or an edge in the file's order; edge i runs from vertex i to vertex i + 1, cyclically.
/// The types differ so that a light's vertex is never taken for a blocker's.
enum class LightVertex : std::uint32_t {};
enum class LightEdge : std::uint32_t {};
enum class BlockerVertex : std::uint32_t {};
enum class BlockerEdge : std::uint32_t {};

/// The bare number, for array access and output.
template <class Index>
constexpr std::uint32_t number(Index index) {
  return static_cast<std::uint32_t>(index);
}

}  // namespace gnomon
