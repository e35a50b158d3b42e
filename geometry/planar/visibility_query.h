#pragma once

#include <optional>
#include <vector>

#include "geometry/numbers/kernel.h"
#include "geometry/planar/viewpoint.h"
#include "gnomon/flatland.h"

namespace gnomon::planar {

/// One question to a LightVisibility, from an input point or a constructed one.
class VisibilityQuery {
 public:
  /// Both must outlive the query.
  VisibilityQuery(const LightVisibility& visibility, const Viewpoint& from);

  VisibleLight visible_light() const;

  /// The visible share of the light, exactly.
  Rational fraction() const;

  /// Where a named end lies along the light, exactly.
  /// Requires: a linear light; a blocker's end lies between the viewpoint and the light's line, or on this line.
  Rational place(const EventPoint& name) const;

  /// The same with an error bound, evaluated exactly only if doubles do not tell.
  IntervalEnd named_end(const EventPoint& name) const;

 private:
  using End = LightVisibility::End;

  /// Where a hidden interval begins or ends: bounds of its place, and its end; no end where it leaves the light's line.
  struct Bound {
    double low = 0;
    double high = 0;
    const End* end = nullptr;
    EventPoint name;
  };
  struct Hidden {
    Bound start;
    Bound stop;
  };

  bool is_below(const End& end) const;
  Bound bound_of(const End& end) const;
  std::optional<Hidden> hidden_by(const LightVisibility::Piece& piece) const;
  std::optional<Hidden> hidden_between(const LightVisibility::Piece& piece) const;
  int compare(const Bound& a, const Bound& b) const;
  bool comes_after(const Bound& a, const Bound& b) const;
  IntervalEnd interval_end(const Bound& bound) const;

  VisibleLight off_the_line() const;
  VisibleLight of_point_light() const;
  VisibleLight from_gaps(const Bound& low, const Bound& high, std::vector<Hidden>& inner) const;

  const LightVisibility& visibility_;
  const Viewpoint& from_;
  int side_ = 0;  ///< of the light's line
  double x_ = 0, y_ = 0, height_ = 0, height_error_ = 0;
};

/// What a viewpoint on a linear light's line sees of it, `blockers` being those that meet this line.
VisibleLight visible_along_line(const LightVisibility& visibility, std::span<const std::uint32_t> blockers,
                                const Viewpoint& from);

/// True if the open segment between the viewpoint and a point meets a blocker.
bool is_blocked(const Viewpoint& from, const Point2& light, const BlockerSegment& blocker);

}  // namespace gnomon::planar
