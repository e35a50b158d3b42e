#pragma once

/// @file
/// Points, boxes, exact numbers, and the units that lengths are measured in.
///
///     #include <gnomon/point.h>
///     int main() {
///       const gnomon::Box3 room{{0, 0, 0}, {3, 4, 2.5}};
///       const gnomon::LengthUnit inch = gnomon::length_unit_named("in").value();
///       return room.max.z == 2.5 && inch.top / inch.bottom == 0.0254 ? 0 : 1;
///     }

#include <array>
#include <optional>
#include <string>
#include <string_view>

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

/// A rational number: correctly rounded to the nearest double, and exactly, as text ("3/2").
struct ExactNumber {
  double nearest = 0;
  std::string exact = "0";
};

/// A unit of length: `top` / `bottom` metres, exactly.
struct LengthUnit {
  std::string_view name;
  double top = 1;
  double bottom = 1;
};

/// The units that scene files may use. An inch is 0.0254 m, a foot 0.3048 m.
inline constexpr std::array<LengthUnit, 6> length_units{
    {{"mm", 1, 1000}, {"cm", 1, 100}, {"m", 1, 1}, {"km", 1000, 1}, {"in", 127, 5000}, {"ft", 381, 1250}}};

/// The unit of that name; nothing if there is none.
inline std::optional<LengthUnit> length_unit_named(std::string_view name) {
  for (const LengthUnit& unit : length_units) {
    if (unit.name == name) return unit;
  }
  return std::nullopt;
}

}  // namespace gnomon
