#include "viz/pictures/plane_name.h"

#include <vtkCellData.h>

#include "gnomon/shadow_volume.h"

namespace gnomon::viz {
namespace {

std::string index_text(const PictureBlock& block, const char* array, vtkIdType cell) {
  vtkDataArray* values = block.data->GetCellData()->GetArray(array);
  return values == nullptr ? "?" : std::to_string(static_cast<int>(values->GetComponent(cell, 0)));
}

}  // namespace

std::string plane_name(const PictureBlock& volume, vtkIdType cell) {
  vtkDataArray* kinds = volume.data->GetCellData()->GetArray("facet_kind");
  if (kinds == nullptr || volume.path.size() < 3) return {};
  const std::string& light = volume.path[1];
  const std::string& blocker = volume.path[2];
  const std::string edge = "edge " + index_text(volume, "edge_index", cell) + " of ";
  const std::string vertex = ", vertex " + index_text(volume, "vertex_index", cell) + " of ";
  switch (static_cast<FacetKind>(kinds->GetComponent(cell, 0))) {
    case FacetKind::blocker_face:
      return "face of " + blocker;
    case FacetKind::separating_blocker_plane:
      return "separating plane: " + edge + blocker + vertex + light;
    case FacetKind::separating_light_plane:
      return "separating plane: " + edge + light + vertex + blocker;
    case FacetKind::supporting_blocker_plane:
      return "supporting plane: " + edge + blocker + vertex + light;
    case FacetKind::clip_box:
      return "clip box";
    case FacetKind::light_plane:
      return "plane of " + light;
  }
  return {};
}

}  // namespace gnomon::viz
