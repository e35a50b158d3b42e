#include "viz/vtk/image_files.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <stdexcept>

#include "viz/vtk/quiet_vtk.h"
#include "viz/vtk/staged_folder.h"

namespace gnomon::viz {
namespace {

/// Rows from the bottom, as VTK has them.
template <class Array, class Values>
vtkSmartPointer<vtkDataArray> upright(const Values& values, std::size_t components, std::size_t width,
                                      std::size_t height) {
  const auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(static_cast<int>(components));
  array->SetNumberOfTuples(static_cast<vtkIdType>(width * height));
  const std::size_t row = width * components;
  for (std::size_t j = 0; j < height; ++j) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>((height - 1 - j) * row);
    std::copy(from, from + static_cast<std::ptrdiff_t>(row), array->GetPointer(static_cast<vtkIdType>(j * row)));
  }
  return array;
}

vtkSmartPointer<vtkDataArray> upright(const PixelArray& pixels, std::size_t width, std::size_t height) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&pixels.values)) {
    return upright<vtkDoubleArray>(*numbers, pixels.components, width, height);
  }
  return upright<vtkIntArray>(std::get<std::vector<std::int32_t>>(pixels.values), pixels.components, width, height);
}

template <class Writer>
void write_staged(Writer& writer, const std::filesystem::path& file) {
  const QuietVtk quiet;
  StagedFolder folder(file.parent_path());
  writer.SetFileName(folder.add(file.filename().string()).temporary.c_str());
  writer.Write();
  if (writer.GetErrorCode() != vtkErrorCode::NoError || !quiet.words().empty()) {
    throw std::runtime_error("cannot write " + file.string() + ": " + quiet.words());
  }
  folder.publish();
}

}  // namespace

void write_pixels(const std::filesystem::path& file, std::uint32_t width, std::uint32_t height,
                  std::span<const PixelArray> arrays, const Fields& fields) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(static_cast<int>(width) + 1, static_cast<int>(height) + 1, 1);
  for (const PixelArray& pixels : arrays) {
    const auto array = upright(pixels, width, height);
    array->SetName(pixels.name.c_str());
    data->GetCellData()->AddArray(array);
  }
  add_field_data(*data->GetFieldData(), fields);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4();
  write_staged(*writer, file);
}

void write_png(const std::filesystem::path& file, std::uint32_t width, std::uint32_t height,
               std::span<const std::uint8_t> levels) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(static_cast<int>(width), static_cast<int>(height), 1);
  data->GetPointData()->SetScalars(upright<vtkUnsignedCharArray>(levels, 3, width, height));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  write_staged(*writer, file);
}

}  // namespace gnomon::viz
