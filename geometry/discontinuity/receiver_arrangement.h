#pragma once

/// Segments on a receiver's plane, and the faces between them. Private to this folder.

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/numbers/flat_point.h"
#include "geometry/numbers/kernel.h"
#include "gnomon/point.h"

namespace gnomon::event {

/// The same, somewhere in a box.
struct FlatEnclosure {
  Interval x = 0;
  Interval y = 0;
};

/// A segment between two different points, with a number.
struct FlatSegment {
  FlatPoint start;
  FlatPoint end;
  std::uint32_t name = 0;
};

inline constexpr std::uint32_t outside = std::numeric_limits<std::uint32_t>::max();

/// The subdivision of a convex polygon by segments in it.
///
/// Exactness: exact; coordinates are evaluated where they are asked for.
class ReceiverArrangement {
 public:
  /// A piece of one or more segments, between two vertices.
  struct Edge {
    std::uint32_t source = 0;
    std::uint32_t target = 0;
    std::uint32_t left = outside;  ///< face, as one walks from source to target; `outside` beyond the polygon
    std::uint32_t right = outside;
    std::vector<std::uint32_t> names;  ///< ascending
  };
  /// An edge as it is met with the face on the left: 2 * edge forward, 2 * edge + 1 backward.
  using EdgeUse = std::uint32_t;
  struct Face {
    std::vector<std::vector<EdgeUse>> cycles;  ///< the outer one first
  };

  /// Requires: the segments' outer boundary is one convex polygon.
  explicit ReceiverArrangement(std::span<const FlatSegment> segments);
  ReceiverArrangement(ReceiverArrangement&&) noexcept;
  ReceiverArrangement& operator=(ReceiverArrangement&&) noexcept;
  ~ReceiverArrangement();

  std::size_t vertex_count() const;
  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<Face>& faces() const { return faces_; }

  FlatPoint point(std::uint32_t vertex) const;
  FlatEnclosure near_point(std::uint32_t vertex) const;

  /// A point inside a face: always the same, of doubles where intervals tell that one lies inside.
  FlatPoint inner_point(std::uint32_t face) const;
  FlatEnclosure near_inner_point(std::uint32_t face) const;

 private:
  struct Points;
  struct Inside;
  Inside inside(std::uint32_t face) const;
  std::optional<FlatEnclosure> rounded_inside(std::uint32_t face) const;

  std::unique_ptr<Points> points_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
};

}  // namespace gnomon::event
