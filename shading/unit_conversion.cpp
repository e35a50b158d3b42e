#include "gnomon/irradiance.h"

#include <cmath>
#include <variant>

#include "shading/vector.h"

namespace gnomon {

Irradiance per_square_metre(const Irradiance& e, const Light& light, const LengthUnit& unit) {
  const bool is_point = std::holds_alternative<PointLight>(light);
  if (unit.top == unit.bottom || (!is_point && !std::holds_alternative<LinearLight>(light))) return e;
  if (e.value == 0 && e.error_bound == 0) return e;
  // Both are whole numbers of few digits, so their squares are exact.
  const double top = is_point ? unit.bottom * unit.bottom : unit.bottom;
  const double bottom = is_point ? unit.top * unit.top : unit.top;
  const double value = e.value * top / bottom;
  // Two roundings of the value, and as many of its bound.
  return {value, shading::with_underflow(1.001 * (e.error_bound * top / bottom) + 0x1.01p-52 * value)};
}

}  // namespace gnomon
