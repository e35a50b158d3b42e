#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "geometry/point.h"
#include "geometry/scene/scene.h"

namespace gnomon {

/// Points in rows parallel to the axes; x runs fastest, then y, then z.
struct PointGrid {
  std::array<std::uint32_t, 3> shape{};  ///< points along x, y, z; none is 0
  Point3 origin;
  Point3 spacing;

  /// From corner to corner of the box; a single point along an axis lies in the middle.
  static PointGrid in_box(const std::array<std::uint32_t, 3>& shape, const Box3& box);

  /// True if all points are finite and each differs from the next: steps may vanish beside large coordinates.
  bool has_distinct_points() const;

  std::size_t size() const { return std::size_t{shape[0]} * shape[1] * shape[2]; }

  /// The point of that index, in the very doubles that VTK makes of origin and spacing.
  Point3 point(std::size_t index) const;
};

/// What the points of a grid receive of one light.
struct GridValues {
  std::string suffix;  ///< of the arrays' names
  std::vector<std::uint8_t> region;
  std::vector<double> visible_fraction;
  std::vector<double> error_bound;
};

/// Writes a grid with the point arrays region, visible_fraction and error_bound of every light as VTK image data
/// (.vti); written beside the file and renamed.
///
/// Requires: as many values as points.
/// Throws:   std::runtime_error naming the file and the cause.
void write_grid(const PointGrid& grid, std::span<const GridValues> values, const Scene& scene,
                const std::filesystem::path& file);

}  // namespace gnomon
