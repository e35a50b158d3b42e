#include "viz/vtk/generation.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <bit>
#include <cstdint>

namespace gnomon::viz {
namespace {

constexpr const char* field_name = "generation";

/// FNV-1a, the same on every machine.
class Digest {
 public:
  void add(std::uint64_t number) {
    for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<unsigned char>(number >> shift));
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(std::int32_t number) { add(static_cast<std::uint64_t>(number)); }
  void add(const std::string& text) {
    add(std::uint64_t{text.size()});
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
  }
  template <class Value>
  void add(const std::vector<Value>& values) {
    add(std::uint64_t{values.size()});
    for (const Value& value : values) add(value);
  }

  std::string text() const {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string result;
    for (int shift = 60; shift >= 0; shift -= 4) result += digits[(value_ >> shift) & 15U];
    return result;
  }

 private:
  void add_byte(unsigned char byte) { value_ = (value_ ^ byte) * 1099511628211U; }

  std::uint64_t value_ = 14695981039346656037U;
};

void add_shape(Digest& digest, vtkPointSet& data) {
  digest.add(static_cast<std::uint64_t>(data.GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    double p[3];
    data.GetPoint(i, p);
    for (const double x : p) digest.add(x);
  }
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    data.GetCellPoints(i, points);
    digest.add(static_cast<std::uint64_t>(data.GetCellType(i)));
    for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k) digest.add(static_cast<std::uint64_t>(points->GetId(k)));
  }
}

}  // namespace

std::string generation(std::span<const Block> blocks) {
  Digest digest;
  for (const Block& block : blocks) {
    if (block.path.front() != "scene") continue;
    digest.add(block.path);
    for (const Field& field : block.fields) std::visit([&](const auto& values) { digest.add(values); }, field.values);
    add_shape(digest, *block.data);
  }
  return digest.text();
}

void mark_generation(std::span<const Block> blocks, const std::string& generation) {
  const Fields field = {{field_name, std::vector<std::string>{generation}}};
  for (const Block& block : blocks) add_field_data(*block.data->GetFieldData(), field);
}

Fields root_fields(const ShadowResult& result, const std::string& generation) {
  Fields fields = result_fields(result);
  fields.push_back({field_name, std::vector<std::string>{generation}});
  return fields;
}

std::string generation_of(vtkPointSet& leaf) {
  auto* texts = vtkStringArray::SafeDownCast(leaf.GetFieldData()->GetAbstractArray(field_name));
  return texts != nullptr && texts->GetNumberOfValues() > 0 ? std::string(texts->GetValue(0)) : std::string();
}

}  // namespace gnomon::viz
