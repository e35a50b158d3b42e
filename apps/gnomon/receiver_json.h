#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "viz/vtk/discontinuity_result.h"

namespace gnomon {

/// What of a receiver's mesh is told as JSON beside its areas.
struct MeshParts {
  bool faces = false;
  bool edges = false;
  bool polygons = false;

  bool any() const { return faces || edges || polygons; }
};

/// The parts of a list like "faces,polygons"; none of an empty one.
///
/// Throws: UsageError for any other word.
MeshParts mesh_parts(const std::string& list);

/// Sums over the pieces of a side.
struct SideCounts {
  double area = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t vertices = 0;
  std::size_t regions = 0;
};

SideCounts counts_of(SideResult side);

/// The result as JSON of schema gnomon/receivers/1. A receiver of one facet has its mesh as "mesh", one of several a
/// list of them as "meshes", each with the name of its facet.
nlohmann::ordered_json receivers_json(const DiscontinuityResult& result, const MeshParts& parts);

}  // namespace gnomon
