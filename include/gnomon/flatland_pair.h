#pragma once

/// @file
/// The plane: one light and one segment, and the lines that touch both.
///
///     #include <gnomon/flatland_pair.h>
///     int main() {
///       using namespace gnomon;
///       const Point2 light[] = {{-1, 4}, {1, 4}}, wall[] = {{-1, 2}, {1, 2}};
///       const planar::Pair pair = planar::Pair::from_points(light, wall);
///       const bool is_dark = planar::region_of(pair, {0, 1}) == Region::umbra;
///       return is_dark && planar::extremal_lines(pair).front().contact == Contact::separating ? 0 : 1;
///     }

#include <array>
#include <cstdint>
#include <span>

#include "gnomon/names.h"
#include "gnomon/pair.h"
#include "gnomon/point.h"

namespace gnomon::planar {

/// One light and one blocker of the plane: a point or linear light, and an opaque closed segment.
///
/// Ends are named as vertices are elsewhere: LightVertex and BlockerVertex 0 and 1, in the order given. A point light
/// has the end 0 alone. Lights of the plane have no back.
class Pair {
 public:
  /// Requires: one or two light points, two blocker points; the two points of a segment differ; all are finite.
  /// Throws:   PreconditionError.
  static Pair from_points(std::span<const Point2> light, std::span<const Point2> blocker);

  bool has_point_light() const { return light_size_ == 1; }

  /// The ends of the light: one or two points.
  std::span<const Point2> light() const { return {light_.data(), light_size_}; }

  /// The ends of the blocker.
  const std::array<Point2, 2>& blocker() const { return blocker_; }

  const Point2& light_end(LightVertex end) const { return light_[number(end)]; }
  const Point2& blocker_end(BlockerVertex end) const { return blocker_[number(end)]; }

 private:
  Pair() = default;

  std::array<Point2, 2> light_{};
  std::array<Point2, 2> blocker_{};
  std::uint32_t light_size_ = 1;
};

/// The blocker's other end.
constexpr BlockerVertex other_end(BlockerVertex end) {
  return end == BlockerVertex{0} ? BlockerVertex{1} : BlockerVertex{0};
}

/// How the two stand to each other, in the words of space; the blocker's line takes the part of its plane:
///
///   coplanar                     the light lies on the blocker's line
///   both_cross                   light and blocker cross each other, both in their insides
///   light_crosses_blocker_plane  the light has points strictly on both sides of the blocker's line
///   touching                     the light reaches the blocker's line with one end
///   standard                     the light lies strictly on one side of the blocker's line
///
/// The first that holds is the pair's position. As a light of the plane has no back, its own line decides nothing: a
/// blocker that reaches across it is in standard position, and blocker_crosses_light_plane and behind_light do not
/// occur. A point light is in standard position or on the blocker's line.
///
/// Exactness: signs of orientation determinants of input points.
/// After:     [P93] §4.2.2.1.
Position pair_position(const Pair& pair);

/// The line through one end of the blocker that touches the light, named by input elements alone.
struct ExtremalLine {
  Contact contact;
  BlockerVertex blocker_end;
  LightVertex light_end;

  friend bool operator==(const ExtremalLine&, const ExtremalLine&) = default;
};

/// The extremal lines of a pair in standard position: separating at the blocker's ends 0 and 1 ("Min b" in [P93]),
/// then supporting at its ends 0 and 1 ("Max b").
///
/// Requires:   pair_position(pair) == Position::standard.
/// Degenerate: a line that holds the whole light (a point light, or an end of the blocker on the light's line) is both
///             separating and supporting and is listed with each contact, named by light end 0.
/// Exactness:  signs of orientation determinants of input points; nothing is constructed.
/// Throws:     PreconditionError.
/// After:      [P93] §4.2.2.1.
std::array<ExtremalLine, 4> extremal_lines(const Pair& pair);

/// The region of a point, by the definition of the visible fraction: a point is blocked from a point of the light if
/// the open segment between them meets the blocker. Lights of the plane have no back, so no point is unlit.
///
/// Degenerate: what hides a part of length zero of a linear light does not count; it hides a point light. A point on
///             the blocker sees a light that is not on the blocker's line.
/// Exactness:  signs of orientation determinants of input points and the point itself, in every position.
/// After:      [P93] §4.2.2.1, properties 1 to 4.
Region region_of(const Pair& pair, const Point2& point);

}  // namespace gnomon::planar
