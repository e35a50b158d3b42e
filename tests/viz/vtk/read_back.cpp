#include "tests/viz/vtk/read_back.h"

#include <vtkCell.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkVariant.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPartitionedDataSetCollectionReader.h>

#include <array>
#include <fstream>
#include <set>
#include <stdexcept>
#include <utility>

namespace gnomon {
namespace {

void collect(vtkMultiBlockDataSet* tree, const std::string& path, ReadBlocks& blocks) {
  for (unsigned int i = 0; i < tree->GetNumberOfBlocks(); ++i) {
    const std::string name = path + (path.empty() ? "" : "/") + tree->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
    vtkDataObject* block = tree->GetBlock(i);
    if (auto* branch = vtkMultiBlockDataSet::SafeDownCast(block)) {
      collect(branch, name, blocks);
    } else if (!blocks.emplace(name, vtkPointSet::SafeDownCast(block)).second) {
      throw std::runtime_error("two blocks named " + name);
    }
  }
}

using Corners = std::array<std::array<double, 3>, 3>;

/// Six times the signed volume of the tetrahedron over a triangle, with its apex at the origin.
double determinant(const Corners& c) {
  return c[0][0] * (c[1][1] * c[2][2] - c[1][2] * c[2][1]) - c[0][1] * (c[1][0] * c[2][2] - c[1][2] * c[2][0]) +
         c[0][2] * (c[1][0] * c[2][1] - c[1][1] * c[2][0]);
}

/// Six times the signed volume over a polygon.
double fan_determinant(vtkPoints& polygon) {
  double sum = 0;
  for (vtkIdType k = 2; k < polygon.GetNumberOfPoints(); ++k) {
    Corners corners;
    polygon.GetPoint(0, corners[0].data());
    polygon.GetPoint(k - 1, corners[1].data());
    polygon.GetPoint(k, corners[2].data());
    sum += determinant(corners);
  }
  return sum;
}

}  // namespace

ReadTree read_multiblock(const std::filesystem::path& file) {
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  auto* tree = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  ReadTree result;
  collect(tree, "", result.blocks);
  result.fields = tree->GetFieldData();
  return result;
}

ReadTree read_partitioned(const std::filesystem::path& file) {
  vtkNew<vtkXMLPartitionedDataSetCollectionReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  ReadTree result;
  for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i) {
    const std::string name = collection->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
    result.blocks[name] = vtkPointSet::SafeDownCast(collection->GetPartition(i, 0));
  }
  result.fields = collection->GetFieldData();
  return result;
}

nlohmann::json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  return nlohmann::json::parse(in);
}

std::string field_text(vtkFieldData* fields, const std::string& name) {
  vtkAbstractArray* array = fields->GetAbstractArray(name.c_str());
  return array == nullptr || array->GetNumberOfValues() == 0 ? "none" : array->GetVariantValue(0).ToString();
}

double enclosed_volume(vtkPointSet& triangles) {
  double sum = 0;
  for (vtkIdType i = 0; i < triangles.GetNumberOfCells(); ++i)
    sum += fan_determinant(*triangles.GetCell(i)->GetPoints());
  return sum / 6;
}

double filled_volume(vtkPointSet& cells) {
  double sum = 0;
  for (vtkIdType i = 0; i < cells.GetNumberOfCells(); ++i) {
    vtkCell* cell = cells.GetCell(i);
    for (int k = 0; k < cell->GetNumberOfFaces(); ++k) sum += fan_determinant(*cell->GetFace(k)->GetPoints());
  }
  return sum / 6;
}

bool is_closed_surface(vtkPointSet& triangles) {
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  for (vtkIdType i = 0; i < triangles.GetNumberOfCells(); ++i) {
    vtkIdList* corners = triangles.GetCell(i)->GetPointIds();
    if (corners->GetNumberOfIds() != 3) return false;
    for (vtkIdType k = 0; k < 3; ++k) {
      if (!edges.emplace(corners->GetId(k), corners->GetId((k + 1) % 3)).second) return false;
    }
  }
  for (const auto& [from, to] : edges) {
    if (!edges.contains({to, from})) return false;
  }
  return !edges.empty();
}

}  // namespace gnomon
