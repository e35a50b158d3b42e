#include "viz/vtk/field_data.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <iomanip>
#include <limits>
#include <sstream>

#include "viz/vtk/xml.h"

namespace gnomon::viz {
namespace {

template <class Array, class Values>
void add_array(vtkFieldData& data, const std::string& name, const Values& values) {
  vtkNew<Array> array;
  array->SetName(name.c_str());
  for (const auto& value : values) array->InsertNextValue(value);
  data.AddArray(array);
}

struct ArrayAdder {
  vtkFieldData& data;
  const std::string& name;

  void operator()(const std::vector<double>& values) const { add_array<vtkDoubleArray>(data, name, values); }
  void operator()(const std::vector<std::int32_t>& values) const { add_array<vtkIntArray>(data, name, values); }
  void operator()(const std::vector<std::string>& values) const { add_array<vtkStringArray>(data, name, values); }
};

struct XmlValues {
  std::ostream& out;

  void operator()(const std::vector<double>& values) const { numbers("Float64", values); }
  void operator()(const std::vector<std::int32_t>& values) const { numbers("Int32", values); }
  // VTK writes texts as the codes of their bytes, each text closed by a zero.
  void operator()(const std::vector<std::string>& values) const {
    out << "type=\"String\" NumberOfTuples=\"" << values.size() << "\" format=\"ascii\">";
    for (const std::string& text : values) {
      for (const char c : text) out << ' ' << static_cast<int>(static_cast<unsigned char>(c));
      out << " 0";
    }
  }

  template <class Values>
  void numbers(const char* type, const Values& values) const {
    out << "type=\"" << type << "\" NumberOfTuples=\"" << values.size() << "\" format=\"ascii\">";
    for (const auto value : values) out << ' ' << value;
  }
};

}  // namespace

void add_field_data(vtkFieldData& data, const Fields& fields) {
  for (const Field& field : fields) std::visit(ArrayAdder{data, field.name}, field.values);
}

std::string field_data_xml(const Fields& fields) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(std::numeric_limits<double>::max_digits10) << "  <FieldData>\n";
  for (const Field& field : fields) {
    const char* element = std::holds_alternative<std::vector<std::string>>(field.values) ? "Array" : "DataArray";
    out << "    <" << element << " Name=\"" << xml_escaped(field.name) << "\" ";
    std::visit(XmlValues{out}, field.values);
    out << " </" << element << ">\n";
  }
  out << "  </FieldData>\n";
  return out.str();
}

}  // namespace gnomon::viz
