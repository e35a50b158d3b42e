#include "viz/vtk/surface_files.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>

#include "viz/vtk/block.h"
#include "viz/vtk/cell_arrays.h"
#include "viz/vtk/file_name.h"

namespace gnomon::viz {
namespace {

std::ostringstream exact_stream() {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  return out;
}

/// The names of the cell arrays that some surface has.
std::vector<std::string> common_arrays(std::span<const Block> blocks) {
  std::vector<std::string> all;
  for (const Block& block : blocks) {
    for (const std::string& name : names_of_cell_arrays(*block.data)) {
      if (!block.empty() && std::ranges::count(all, name) == 0) all.push_back(name);
    }
  }
  return all;
}

/// One surface keeps only the arrays that all of its parts have.
vtkSmartPointer<vtkPolyData> numbered_surface(vtkPolyData* surface, int number, std::span<const std::string> arrays) {
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface);
  add_empty_cell_arrays(*copy, arrays);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("block_id");
  numbers->SetNumberOfTuples(surface->GetNumberOfCells());
  numbers->FillValue(number);
  copy->GetCellData()->AddArray(numbers);
  return copy;
}

void write_obj_cells(std::ostream& out, const char* keyword, vtkCellArray* cells, vtkIdType offset) {
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cell->GetCurrentCell(size, points);
    out << keyword;
    for (vtkIdType i = 0; i < size; ++i) out << ' ' << offset + points[i];
    out << '\n';
  }
}

std::string obj_name(const std::vector<std::string>& path) {
  std::vector<std::string> parts;
  parts.reserve(path.size());
  for (const std::string& part : path) parts.push_back(file_name(part));
  return joined(parts);
}

/// A corner of STL's soup has no number.
using Corner = std::array<double, 3>;

void write_stl_facet(std::ostream& out, const Corner& a, const Corner& b, const Corner& c) {
  double normal[3];
  vtkTriangle::ComputeNormal(a.data(), b.data(), c.data(), normal);
  out << "facet normal " << normal[0] << ' ' << normal[1] << ' ' << normal[2] << "\n outer loop\n";
  for (const Corner& p : {a, b, c}) out << "  vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  out << " endloop\nendfacet\n";
}

}  // namespace

vtkSmartPointer<vtkPolyData> merged_surfaces(std::span<const Block> blocks, const Fields& fields) {
  vtkNew<vtkAppendPolyData> append;
  std::vector<std::string> names;
  const std::vector<std::string> arrays = common_arrays(blocks);
  for (const Block& block : blocks) {
    vtkPolyData* surface = vtkPolyData::SafeDownCast(block.data);
    if (surface == nullptr || block.empty()) continue;
    append->AddInputData(numbered_surface(surface, static_cast<int>(names.size()), arrays));
    names.push_back(joined(block.path));
  }
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  auto merged = vtkSmartPointer<vtkPolyData>::New();
  merged->ShallowCopy(append->GetOutput());
  add_field_data(*merged->GetFieldData(), fields);
  add_field_data(*merged->GetFieldData(), {{"block_names", std::move(names)}});
  return merged;
}

std::string obj_text(std::span<const Block> blocks) {
  std::ostringstream out = exact_stream();
  out << "# gnomon " GNOMON_VERSION "\n";
  vtkIdType offset = 1;
  for (const Block& block : blocks) {
    vtkPolyData* surface = vtkPolyData::SafeDownCast(block.data);
    if (surface == nullptr || block.empty()) continue;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
      std::array<double, 3> p;
      surface->GetPoint(i, p.data());
      out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    out << "g " << obj_name(block.path) << '\n';
    write_obj_cells(out, "p", surface->GetVerts(), offset);
    write_obj_cells(out, "l", surface->GetLines(), offset);
    write_obj_cells(out, "f", surface->GetPolys(), offset);
    offset += surface->GetNumberOfPoints();
  }
  return out.str();
}

std::string stl_text(vtkPolyData& surface, const std::string& name) {
  std::ostringstream out = exact_stream();
  out << "solid " << name << '\n';
  const auto cell = vtk::TakeSmartPointer(surface.GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cell->GetCurrentCell(size, points);
    std::vector<Corner> corners(static_cast<std::size_t>(size));
    for (std::size_t i = 0; i < corners.size(); ++i) surface.GetPoint(points[i], corners[i].data());
    for (std::size_t i = 2; i < corners.size(); ++i) write_stl_facet(out, corners[0], corners[i - 1], corners[i]);
  }
  out << "endsolid " << name << '\n';
  return out.str();
}

}  // namespace gnomon::viz
