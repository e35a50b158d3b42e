#pragma once

/// @file
/// Names: of regions, of contacts, and of the elements of the scene file.
///
///     #include <gnomon/names.h>
///     int main() {
///       const gnomon::BlockerEdge edge{3};  // from vertex 3 to vertex 4; no LightEdge can be taken for it
///       return number(edge) == 3 && name(gnomon::Region::umbra) == "umbra" ? 0 : 1;
///     }

#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

namespace gnomon {

/// What a point receives of a light. The numbers are those of the `region` arrays in output files.
enum class Region {
  lit = 0,       ///< all of the light is visible: f = 1
  penumbra = 1,  ///< a part of it: 0 < f < 1
  umbra = 2,     ///< none of it: f = 0
  unlit = 3,     ///< the light shows its back or its edge; takes precedence over umbra
};

/// The region's name as scripts read it.
constexpr std::string_view name(Region region) {
  constexpr std::string_view names[] = {"lit", "penumbra", "umbra", "unlit"};
  return names[static_cast<int>(region)];
}

/// How an extremal line or plane holds the light and the blocker.
///
/// After: [CF91] §3.1, [P93] §4.2.
enum class Contact {
  separating,  ///< light and blocker on opposite closed sides: bounds the occlusion ("minimum" in the papers)
  supporting,  ///< both on one closed side: bounds the umbra ("maximum" in the papers)
};

/// The contact's name as scripts read it.
constexpr std::string_view name(Contact contact) {
  return contact == Contact::separating ? "separating" : "supporting";
}

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

/// An index or none, as std::optional has it, in the room of the index alone: planes are listed by the million.
template <class Index>
class MaybeIndex {
 public:
  constexpr MaybeIndex() = default;
  constexpr MaybeIndex(Index index) : number_(number(index)) {}  // NOLINT: meant as a conversion

  constexpr bool has_value() const { return number_ != none; }
  constexpr explicit operator bool() const { return has_value(); }
  /// Requires: has_value().
  constexpr Index operator*() const { return Index{number_}; }
  /// Throws: std::bad_optional_access.
  constexpr Index value() const { return has_value() ? Index{number_} : throw std::bad_optional_access(); }

  friend constexpr auto operator<=>(const MaybeIndex&, const MaybeIndex&) = default;

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  std::uint32_t number_ = none;
};

/// The number of an element that is there; throws std::bad_optional_access if there is none.
template <class Index>
constexpr std::uint32_t number(const MaybeIndex<Index>& index) {
  return number(index.value());
}

}  // namespace gnomon
