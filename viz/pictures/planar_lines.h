#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/shadow_volume.h"
#include "viz/pictures/picture_geometry.h"
#include "viz/pictures/picture_source.h"

namespace gnomon::viz {

struct Segment {
  Point3 start;
  Point3 end;
};

/// The two-point cells of a block, those of one facet kind or all.
std::vector<Segment> segments_of(const PictureBlock& block, std::optional<FacetKind> kind = {});

/// True for the lines that bound the regions behind all blockers together or, where these are not known, for the
/// extremal lines of every pair.
bool is_line_block(const PictureSource& source, const PictureBlock& block);

/// A line with a name.
struct NamedLine {
  Segment segment;  ///< its longest piece
  FacetKind kind;
  std::vector<Segment> pieces;  ///< all of them
};

/// Every separating or supporting line of a light once, by the elements that it goes through: "wall 0, tube 1".
std::map<std::string, NamedLine> named_lines(const PictureSource& source, const std::string& light);

}  // namespace gnomon::viz
