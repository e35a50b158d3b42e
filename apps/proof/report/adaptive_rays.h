#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/proof/report/visibility_tasks.h"

namespace gnomon::report {

/// Adaptive shadow rays to a square light, beside as many stratified ones.
struct AdaptiveRow {
  std::size_t triangles = 0;
  std::size_t start = 0;      ///< cells along a side that the light is parted in first
  double rays = 0;            ///< for a point, on the average
  double rms = 0;             ///< of visible fractions
  double missed = 0;          ///< share of points whose region is told wrong: blockers, or gaps, that no ray met
  double stratified_rms = 0;  ///< the same of as many stratified rays
  double stratified_missed = 0;
};

/// A cell is parted in four where the rays to its corners do not agree, down to 1/256 of the light's side.
/// After: Kok and Jansen 1991, as [P93] §4.4.1 tells it.
std::vector<AdaptiveRow> adaptive_rays(Effort effort);

std::string adaptive_rays_section(const std::vector<AdaptiveRow>& rows);

}  // namespace gnomon::report
