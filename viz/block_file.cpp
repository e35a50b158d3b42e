#include "viz/block_file.h"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <stdexcept>

#include "viz/file_name.h"
#include "viz/quiet_vtk.h"

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

vtkSmartPointer<vtkPolyData> read_surface(const std::filesystem::path& file) {
  const QuietVtk quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError || !quiet.words().empty()) {
    throw std::runtime_error("cannot read " + file.string() + ": " + quiet.words());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(reader->GetOutput());
  return data;
}

}  // namespace gnomon::viz
