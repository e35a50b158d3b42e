#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "apps/proof/report/light_frame.h"
#include "apps/proof/report/visibility_answer.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::report {

/// A walk along the boundary of the visible part of an area light as it would be if doubles were real numbers: every
/// sign is that of a rounded expression, and nothing is said about errors. All blockers are visited; there is no
/// hierarchy.
class PlainVisibility {
 public:
  PlainVisibility(const AreaLight& light, std::span<const ConvexBlocker> blockers);

  /// Requires: for the irradiance, a light wholly above the receiver's horizon.
  VisibilityAnswer visible_from(const Point3& p, const Point3& normal);

 private:
  /// A blocker's corner: the foot in the light's plane, and the height.
  struct Corner {
    Point2 flat;
    double height = 0;
  };
  /// A blocker: its corners in `corners_`, and whether their shadow's order is to be found.
  struct Shape {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::vector<std::uint32_t> edges;  ///< of a solid: pairs of corners
    bool solid = false;
  };
  /// A convex polygon in the light's plane, counterclockwise, and its bounding box.
  struct Outline {
    std::vector<Point2> corners;
    Point2 low;
    Point2 high;
  };
  struct Stretch {
    double from = 0;
    double to = 1;
  };
  struct Sum {
    double area = 0;
    double arcs = 0;
    std::size_t light_pieces = 0;
    std::size_t blocker_pieces = 0;
  };
  enum class Alongside { belongs, excluded };

  void add_blocker(const ConvexBlocker& blocker);
  void project(const Shape& shape, const Point2& foot, double height);
  void clip(const Shape& shape, double height);
  void append_outline();
  static bool meets(const Outline& a, const Outline& b);
  static bool stretch_inside(const Point2& a, const Point2& b, const Outline& polygon, Alongside alongside,
                             Stretch& stretch);
  void add_uncovered(std::size_t owner, const Point2& a, const Point2& b, Stretch stretch, Sum& sum);
  void add_piece(const Point2& a, const Point2& b, Sum& sum) const;

  LightFrame frame_;
  bool two_sided_;
  Outline light_;
  double doubled_area_ = 0;
  std::vector<Corner> corners_;
  std::vector<Shape> shapes_;

  Point3 eye_;
  Point3 normal_;
  std::vector<Corner> clipped_;
  std::vector<Point2> shadow_;
  std::vector<Outline> outlines_;
  std::size_t used_ = 0;  ///< of the outlines
  std::vector<Stretch> covers_;
};

}  // namespace gnomon::report
