#include "viz/pictures/planar_lines.h"

#include <vtkCellData.h>
#include <vtkStringArray.h>

#include <algorithm>

#include "viz/vtk/vector.h"

namespace gnomon::viz {
namespace {

/// The names of the elements that a line goes through: "wall 0, tube 1".
std::string line_name(const PictureBlock& block, vtkIdType cell) {
  vtkCellData* arrays = block.data->GetCellData();
  if (auto* names = vtkStringArray::SafeDownCast(arrays->GetAbstractArray("boundary"))) {
    std::string name = names->GetValue(cell);
    name.erase(0, name.find(": ") + 2);
    for (std::size_t at = name.find(" end "); at != std::string::npos; at = name.find(" end ")) name.erase(at, 4);
    return name;
  }
  const auto index = [&](const char* array) {
    return std::to_string(static_cast<int>(arrays->GetArray(array)->GetComponent(cell, 0)));
  };
  return block.path.at(2) + ' ' + index("edge_index") + ", " + block.path.at(1) + ' ' + index("vertex_index");
}

}  // namespace

std::vector<Segment> segments_of(const PictureBlock& block, std::optional<FacetKind> kind) {
  std::vector<Segment> segments;
  vtkDataArray* kinds = block.data->GetCellData()->GetArray("facet_kind");
  for (vtkIdType i = 0; i < block.data->GetNumberOfCells(); ++i) {
    if (kind && (kinds == nullptr || static_cast<FacetKind>(kinds->GetComponent(i, 0)) != *kind)) continue;
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    block.data->GetCellPoints(i, size, points);
    if (size != 2) continue;
    double p[2][3];
    for (int k = 0; k < 2; ++k) block.data->GetPoint(points[k], p[k]);
    segments.push_back({{p[0][0], p[0][1], 0}, {p[1][0], p[1][1], 0}});
  }
  return segments;
}

bool is_line_block(const PictureSource& source, const PictureBlock& block) {
  const bool together = std::ranges::count(source.blocks, "boundaries", &PictureBlock::kind) > 0;
  return block.kind == (together ? "boundaries" : "extremal_planes");
}

std::map<std::string, NamedLine> named_lines(const PictureSource& source, const std::string& light) {
  std::map<std::string, NamedLine> lines;
  for (const PictureBlock& block : source.blocks) {
    if (!is_line_block(source, block) || block.path.at(1) != light) continue;
    vtkDataArray* kinds = block.data->GetCellData()->GetArray("facet_kind");
    const std::vector<Segment> segments = segments_of(block);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const auto cell = static_cast<vtkIdType>(i);
      const auto kind = static_cast<FacetKind>(kinds->GetComponent(cell, 0));
      if (kind != FacetKind::separating_blocker_plane && kind != FacetKind::supporting_blocker_plane) continue;
      const auto place = lines.try_emplace(line_name(block, cell), NamedLine{segments[i], kind, {}}).first;
      place->second.pieces.push_back(segments[i]);
      const Segment& known = place->second.segment;
      if (length(segments[i].end - segments[i].start) > length(known.end - known.start))
        place->second.segment = segments[i];
    }
  }
  return lines;
}

}  // namespace gnomon::viz
