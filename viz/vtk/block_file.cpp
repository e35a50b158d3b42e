#include "viz/vtk/block_file.h"

#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "gnomon/errors.h"
#include "viz/vtk/file_name.h"
#include "viz/vtk/quiet_vtk.h"

namespace gnomon::viz {
namespace {

// Raw appended blocks packed with LZ4 are written some twenty times faster than VTK's default (zlib, base64).
template <class Writer>
void write_with(vtkPointSet& data, const StagedFile& file) {
  const QuietVtk quiet;
  vtkNew<Writer> writer;
  writer->SetInputDataObject(&data);
  writer->SetFileName(file.temporary.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4();
  const int done = writer->Write();
  const unsigned long error = writer->GetErrorCode();
  if (done == 1 && error == vtkErrorCode::NoError && quiet.words().empty()) return;
  const std::string why = error != vtkErrorCode::NoError ? vtkErrorCode::GetStringFromErrorCode(error) : quiet.words();
  throw std::runtime_error("cannot write " + file.target.string() + ": " + why);
}

bool refers_to_points(vtkCellArray* cells, vtkIdType points) {
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    if (!std::all_of(ids, ids + size, [&](vtkIdType id) { return id >= 0 && id < points; })) return false;
  }
  return true;
}

/// VTK believes what a file says of itself. Empty if it is sound.
std::string defect_of(vtkPolyData& data) {
  const vtkIdType points = data.GetNumberOfPoints();
  for (vtkCellArray* cells : {data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()}) {
    if (!cells->IsValid() || !refers_to_points(cells, points)) return "a cell has a point that is not there";
  }
  vtkCellData& arrays = *data.GetCellData();
  for (int i = 0; i < arrays.GetNumberOfArrays(); ++i) {
    if (arrays.GetAbstractArray(i)->GetNumberOfTuples() != data.GetNumberOfCells()) {
      return "an array does not have a number for each cell";
    }
  }
  return {};
}

}  // namespace

std::string block_file_name(const Block& block) {
  std::string path = "shadow";
  for (const std::string& part : block.path) path.append("/").append(file_name(part));
  return path + (vtkPolyData::SafeDownCast(block.data) != nullptr ? ".vtp" : ".vtu");
}

void write_data(vtkPointSet& data, const StagedFile& file) {
  if (vtkPolyData::SafeDownCast(&data) != nullptr) {
    write_with<vtkXMLPolyDataWriter>(data, file);
  } else {
    write_with<vtkXMLUnstructuredGridWriter>(data, file);
  }
}

namespace {

std::string failure_to_read(const std::filesystem::path& file) {
  return "cannot read " + file.string() + ": ";
}

template <class Data, class Reader>
vtkSmartPointer<Data> read_block(const std::filesystem::path& file) {
  const std::string start = failure_to_read(file);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored))) {
    throw ResultError(start + "there is no regular file");
  }
  const QuietVtk quiet;
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError || !quiet.words().empty()) {
    throw ResultError(start + quiet.words());
  }
  auto data = vtkSmartPointer<Data>::New();
  data->ShallowCopy(reader->GetOutput());
  return data;
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_surface(const std::filesystem::path& file) {
  auto data = read_block<vtkPolyData, vtkXMLPolyDataReader>(file);
  if (const std::string defect = defect_of(*data); !defect.empty()) throw ResultError(failure_to_read(file) + defect);
  return data;
}

vtkSmartPointer<vtkPointSet> read_solid(const std::filesystem::path& file) {
  return read_block<vtkUnstructuredGrid, vtkXMLUnstructuredGridReader>(file);
}

}  // namespace gnomon::viz
