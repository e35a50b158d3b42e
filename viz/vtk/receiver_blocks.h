#pragma once

#include <vector>

#include "gnomon/result.h"
#include "viz/vtk/block.h"

namespace gnomon::viz {

/// The vertices of all pieces of a side, one after the other, and their visible fractions where these are known.
struct SidePoints {
  std::vector<Point3> points;
  std::vector<double> fractions;
};

SidePoints side_points(SideResult side);

/// What the leaves of a divided receiver say: light, receiver, and the area of each region. `frame` is the result they
/// belong to.
Fields receiver_fields(const ShadowResult& frame, SideResult side);

/// Adds the point array `visible_fraction`, where the fractions are known.
void add_vertex_fractions(vtkPointSet& data, const SidePoints& points);

/// Adds the block `receivers/LIGHT/NAME/faces`: triangles, counterclockwise seen from the receiver's front, with the
/// region of the face whose number is their `facet_id`.
void append_receiver_faces(std::vector<Block>& blocks, const ShadowResult& frame, SideResult side);

}  // namespace gnomon::viz
