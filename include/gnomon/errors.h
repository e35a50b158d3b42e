#pragma once

/// @file
/// Errors, each named by its cause; a scene file has its own, in scene.h.
///
///     #include <gnomon/convex_polygon.h>
///     #include <gnomon/errors.h>
///     int main() {
///       try {
///         gnomon::ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}});
///       } catch (const gnomon::PreconditionError&) {
///         return 0;  // two points are no polygon
///       }
///       return 1;
///     }

#include <stdexcept>

namespace gnomon {

/// A function was called although what its doc block requires does not hold: a mistake of the caller, not of the data.
class PreconditionError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// A folder does not hold the whole result of one run of ours; what() names the file, and says what is wrong with it.
class ResultError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace gnomon
