#pragma once

namespace gnomon {

/// Irradiance on a receiver [W/m²].
/// Exactness: |value - exact| is at most `error_bound`, which includes every rounding.
struct Irradiance {
  double value = 0;
  double error_bound = 0;
};

}  // namespace gnomon
