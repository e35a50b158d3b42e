#pragma once

namespace gnomon {

/// A point of space. Coordinates are finite doubles in the scene's length unit, and are meant exactly.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend bool operator==(const Point3&, const Point3&) = default;
};

/// A point of the plane. Coordinates as in Point3.
struct Point2 {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point2&, const Point2&) = default;
};

/// A closed box with sides parallel to the axes.
struct Box3 {
  Point3 min;
  Point3 max;

  friend bool operator==(const Box3&, const Box3&) = default;
};

/// A closed box of the plane with sides parallel to the axes.
struct Box2 {
  Point2 min;
  Point2 max;

  friend bool operator==(const Box2&, const Box2&) = default;
};

}  // namespace gnomon
