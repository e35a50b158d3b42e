#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

class vtkFieldData;

namespace gnomon::viz {

/// A named list of numbers or texts that says something of a whole block or result.
struct Field {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::string>> values;
};

using Fields = std::vector<Field>;

/// Adds the fields as arrays of one component.
void add_field_data(vtkFieldData& data, const Fields& fields);

/// The fields as the `FieldData` element of VTK's XML files; doubles read back unchanged.
std::string field_data_xml(const Fields& fields);

}  // namespace gnomon::viz
