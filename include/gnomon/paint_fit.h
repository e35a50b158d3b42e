#pragma once

/// @file
/// From painted brightness to intensities of lights and to materials.
///
///     #include <gnomon/paint_fit.h>
///     int main() {
///       using namespace gnomon;
///       const FitRow rows[] = {{.columns = {1, 0}, .wanted = 2}, {.columns = {1, 1}, .wanted = 5}};
///       const LinearFit fit = least_squares(rows, 2, {});  // x, y >= 0 with x = 2, x + y = 5
///       return fit.values[0] == 2 && fit.values[1] == 3 && fit.rank == 2 ? 0 : 1;
///     }

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gnomon/reflection.h"
#include "gnomon/scene.h"

namespace gnomon {

/// A sample: the sum of all columns times their unknowns is wanted to be `wanted`, or to lie from `least` to `most`.
struct FitRow {
  std::vector<double> columns;
  double wanted = 0;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// Unknowns that fit samples best.
struct LinearFit {
  bool is_feasible = true;        ///< false: no unknowns lie within all bounds
  std::vector<double> values;     ///< correctly rounded
  std::vector<double> residuals;  ///< of each row: the sum less what is wanted; of bounds, by how much they fail
  std::uint32_t rank = 0;         ///< how many columns are independent, roundings of 1e-12 apart
  bool ill_conditioned = false;   ///< a column is a sum of the others up to 1e-6 of its length
  std::vector<std::uint32_t> undetermined;  ///< those columns
  std::vector<std::uint32_t>
      conflict;  ///< where not feasible: rows that exclude each other, one more than unknowns at most
};

/// The unknowns, none below 0 or above `most`, of least Σ (residual)².
///
/// Exactness: rational arithmetic for the doubles given: a set of unknowns at their bounds is right, not likely.
/// Cost:      the active sets of a few unknowns, one after the other; with more than 3 those of [LH74].
LinearFit least_squares(std::span<const FitRow> rows, std::uint32_t unknowns, std::optional<double> most);

/// Unknowns from 0 to 1 with all rows within their bounds, the first as small as can be, then the second as large as
/// can be.
///
/// Returns: not feasible with a conflict of rows whose bounds exclude each other, from Farkas' multipliers.
/// After:   [P93] 5.3.6, without its penalties.
LinearFit within_bounds(std::span<const FitRow> rows, std::uint32_t unknowns);

/// A painted point.
struct PaintSample {
  Point3 point;
  Point3 normal;
  Point3 eye = {};             ///< of materials
  std::vector<double> wanted;  ///< one number, or three of colours; empty if bounds are given
  std::vector<double> least, most;
};

/// A task: intensities of lights from irradiance, or a material from radiance.
struct Paint {
  enum class Fit { intensities, material };
  Fit fit = Fit::intensities;
  std::vector<std::string> lights = {};        ///< of intensities
  std::optional<std::uint32_t> exponent = {};  ///< of materials; none: free
  ReflectionModel model = ReflectionModel::phong;
  std::vector<PaintSample> samples = {};
  std::uint32_t channels = 1;  ///< 1 or 3
};

/// What came out: of each channel a fit.
struct PaintFit {
  std::vector<LinearFit> channels;
  std::uint32_t exponent = 0;                           ///< of materials
  std::uint32_t least_exponent = 0, most_exponent = 0;  ///< that fit as well, up to 1e-9 of what is wanted
};

/// Fits the lights of a scene, or the material of its surfaces, to paint.
///
/// Throws: UnsupportedSceneError for samples with bounds beside samples without.
PaintFit fitted(const Paint& paint, const SpaceScene& scene);

/// Reads a paint file; names in it are those of the scene.
///
/// Throws: SceneError.
Paint read_paint(const std::filesystem::path& file, const SpaceScene& scene);
Paint parse_paint(std::string_view text, const std::string& source, const SpaceScene& scene);

}  // namespace gnomon
