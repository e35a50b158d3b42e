#pragma once

/// What is to be an edge or a corner of meshes. Private to the libraries.

#include <cstdint>
#include <span>
#include <vector>

#include "gnomon/illumination.h"
#include "shading/illumination/first_triangles.h"
#include "shading/illumination/receiver_traces.h"

namespace gnomon::illumination {

/// The borders of receivers of one plane, and the traces up to an order. `traces` has those of each receiver, of all
/// lights. Those that end on a border do so exactly, also where vertices were rounded off their plane: they are moved
/// into it along the axis that is left out where the outline is made triangles.
Outline outline_of(std::span<const ConvexPolygon* const> receivers, std::span<const ReceiverTraces> traces,
                   std::uint8_t highest_order);

/// True of points on a receiver or outside by no more than rounding.
bool is_on(const ConvexPolygon& receiver, const Point3& p);

/// The largest distance of two corners of a box around the points.
double extent_of(std::span<const Point3> points);

/// Close to a point; off by rounding.
Point3 near_point(const ExactVector& p);

double distance(const Point3& p, const Point3& a, const Point3& b);

}  // namespace gnomon::illumination
