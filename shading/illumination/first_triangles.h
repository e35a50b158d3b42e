#pragma once

/// Receivers in triangles between given lines. Private to the libraries.

#include <array>
#include <cstdint>
#include <vector>

#include "gnomon/point.h"
#include "shading/illumination/receiver_traces.h"

namespace gnomon::illumination {

/// Receivers of one plane, and what is to be an edge or a corner.
struct Outline {
  std::vector<std::vector<ExactVector>> rings;  ///< the border of each receiver, counterclockwise seen from the front
  std::vector<Trace> traces;
  std::vector<ExactVector> corners;
};

struct FirstTriangle {
  std::array<std::uint32_t, 3> corners{};  ///< counterclockwise seen from the front
  std::array<std::uint8_t, 3> orders{};    ///< of the edges from each corner to the next
  std::uint32_t receiver = 0;              ///< which of the rings it lies in
};

struct FirstTriangles {
  std::vector<Point3> points;
  std::vector<FirstTriangle> triangles;
};

/// The rings in triangles whose edges run along all borders and traces.
///
/// Requires:  the points lie in one plane but for rounding, traces and corners inside of the rings or on them.
/// Exactness: crossings are exact in two of the coordinates, then rounded; the third is that of the plane.
FirstTriangles first_triangles(const Outline& outline);

}  // namespace gnomon::illumination
