#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "apps/gnomon/view_surfaces.h"
#include "gnomon/scene.h"
#include "gnomon/view_factors.h"

namespace gnomon {

/// What the factors from one surface add up to.
struct RowSum {
  double value = 0;
  double error_bound = 0;
};

/// Of every surface; of one alone if only its factors were asked for.
std::vector<RowSum> row_sums(const ViewFactors& factors);

/// What reaches no surface.
struct SkyFactor {
  double value = 0;
  double error_bound = 0;
};
SkyFactor sky_factor(const RowSum& sum);

/// One row for every factor that is not 0: from,to,area,factor,error_bound,bound_is; with `open`, one to `sky` for
/// every surface that was asked for.
void write_factors_csv(std::ostream& stream, const ViewSurfaces& surfaces, const ViewFactors& factors,
                       const std::optional<std::uint32_t>& from, bool open);

nlohmann::ordered_json factors_json(const Scene& scene, const ViewSurfaces& surfaces, const ViewFactors& factors,
                                    const std::optional<std::uint32_t>& from, double bound);

/// For people: how many pairs, how exact, and how far row sums are from 1.
std::string factors_summary(const ViewFactors& factors, const std::optional<std::uint32_t>& from, double bound);

/// The dense matrix of factors, and of their bounds beside it as `NAME_bound.npy`, as NumPy reads them: version 1.0 of
/// its format, doubles, little-endian, row by row.
void write_npy(const std::filesystem::path& file, const ViewFactors& factors);

/// F.npy -> F_bound.npy
std::filesystem::path bound_file(const std::filesystem::path& file);

}  // namespace gnomon
