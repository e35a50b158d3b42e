#pragma once

#include <vector>

#include "gnomon/receiver_mesh.h"
#include "gnomon/result.h"
#include "viz/vtk/block.h"

namespace gnomon::viz {

/// The pieces of a side as they are drawn, all their points one after the other, and the visible fractions of these
/// where they are known.
struct SideDrawing {
  std::vector<MeshDrawing> pieces;
  std::vector<Point3> points;
  std::vector<double> fractions;
  std::vector<Irradiance> irradiance;
  std::vector<RadianceRgb> radiance;
  double chord_error = 0;
  bool chords_cross = false;
};

SideDrawing side_drawing(SideResult side);

/// What the leaves of a divided receiver say: light, receiver, and the area of each region. `frame` is the result they
/// belong to. Where arcs are drawn as chords, how far these are from them at most.
Fields receiver_fields(const ShadowResult& frame, SideResult side, const SideDrawing& drawing);

/// Adds the point arrays `visible_fraction`, `irradiance`, `irradiance_error_bound`, `radiance` and
/// `radiance_error_bound`, those that are known.
void add_point_arrays(vtkPointSet& data, const SideDrawing& drawing);

/// Adds the block `receivers/LIGHT/NAME/faces`: triangles, counterclockwise seen from the receiver's front, with the
/// region of the face whose number is their `facet_id`.
void append_receiver_faces(std::vector<Block>& blocks, const ShadowResult& frame, SideResult side,
                           const SideDrawing& drawing);

/// Adds the block `receivers/LIGHT/NAME/irradiance`: triangles, counterclockwise seen from the receiver's front, with
/// the point arrays irradiance and irradiance_error_bound.
void append_painted_receiver(std::vector<Block>& blocks, const ShadowResult& frame, const PaintedReceiver& painted);

}  // namespace gnomon::viz
