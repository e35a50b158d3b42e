#include "apps/proof/report/adaptive_rays.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "apps/proof/report/draws.h"
#include "apps/proof/report/embree_rays.h"
#include "apps/proof/report/tables.h"
#include "apps/proof/report/triangle_scenes.h"
#include "gnomon/visibility.h"

namespace gnomon::report {
namespace {

constexpr std::uint32_t finest = 256;  ///< cells along the light's side

/// The light of triangle scenes: the square of side 1 at the height 4.
class LampSampler {
 public:
  explicit LampSampler(const TriangleScene& scene) : rays_(scene.blockers) {}

  bool is_hidden(const Point3& p, double s, double t) {
    ++cast_;
    return rays_.is_hidden(p, {s - 0.5 - p.x, t - 0.5 - p.y, 4 - p.z});
  }
  std::size_t cast() const { return cast_; }

 private:
  EmbreeRays rays_;
  std::size_t cast_ = 0;
};

/// One point's rays: to corners of cells, none twice.
class AdaptiveLook {
 public:
  AdaptiveLook(LampSampler& lamp, const Point3& p) : lamp_(lamp), p_(p) {}

  /// The visible share of a cell.
  double share(std::uint32_t s, std::uint32_t t, std::uint32_t size) {
    const int hidden =
        hidden_at(s, t) + hidden_at(s + size, t) + hidden_at(s, t + size) + hidden_at(s + size, t + size);
    if (hidden == 0 || hidden == 4 || size == 1) return 1 - hidden / 4.0;
    const std::uint32_t half = size / 2;
    return (share(s, t, half) + share(s + half, t, half) + share(s, t + half, half) + share(s + half, t + half, half)) /
           4;
  }

 private:
  int hidden_at(std::uint32_t s, std::uint32_t t) {
    const auto [entry, is_new] = known_.try_emplace({s, t}, 0);
    if (is_new) entry->second = lamp_.is_hidden(p_, 1.0 * s / finest, 1.0 * t / finest) ? 1 : 0;
    return entry->second;
  }

  LampSampler& lamp_;
  Point3 p_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> known_;
};

double adaptive_fraction(LampSampler& lamp, const Point3& p, std::size_t start) {
  AdaptiveLook look(lamp, p);
  const auto size = static_cast<std::uint32_t>(finest / start);
  double sum = 0;
  for (std::uint32_t s = 0; s < finest; s += size) {
    for (std::uint32_t t = 0; t < finest; t += size) sum += look.share(s, t, size);
  }
  return sum / static_cast<double>(start * start);
}

double stratified_fraction(LampSampler& lamp, const Point3& p, std::size_t k, Draws& draws) {
  std::size_t seen = 0;
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) {
      const double s = (static_cast<double>(i) + draws.between(0, 1)) / static_cast<double>(k);
      const double t = (static_cast<double>(j) + draws.between(0, 1)) / static_cast<double>(k);
      seen += lamp.is_hidden(p, s, t) ? 0 : 1;
    }
  }
  return static_cast<double>(seen) / static_cast<double>(k * k);
}

bool is_of_region(double fraction, Region region) {
  return region == (fraction == 0 ? Region::umbra : fraction == 1 ? Region::lit : Region::penumbra);
}

/// Sums of errors over points.
struct SampledErrors {
  double squares = 0, missed = 0;

  void add(double fraction, const Visibility& exact) {
    squares += (fraction - exact.fraction) * (fraction - exact.fraction);
    missed += is_of_region(fraction, exact.region) ? 0 : 1;
  }
};

AdaptiveRow adaptive_row(const TriangleScene& scene, std::size_t start) {
  LightVisibility visibility(scene.light, PreparedObstacles({scene.blockers, {}}));
  LampSampler lamp(scene);
  std::vector<Visibility> exact;
  SampledErrors adaptive, stratified;
  for (const Point3& p : scene.points) {
    exact.push_back(visibility.at(p));
    adaptive.add(adaptive_fraction(lamp, p, start), exact.back());
  }
  const auto points = static_cast<double>(scene.points.size());
  const double rays = static_cast<double>(lamp.cast()) / points;
  const auto k = static_cast<std::size_t>(std::lround(std::sqrt(rays)));
  Draws draws(24);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    stratified.add(stratified_fraction(lamp, scene.points[i], k, draws), exact[i]);
  }
  return {scene.blockers.size(),
          start,
          rays,
          std::sqrt(adaptive.squares / points),
          adaptive.missed / points,
          std::sqrt(stratified.squares / points),
          stratified.missed / points};
}

}  // namespace

std::vector<AdaptiveRow> adaptive_rays(Effort effort) {
  std::vector<AdaptiveRow> rows;
  for (const std::size_t n : {std::size_t{16}, std::size_t{64}, std::size_t{1024}}) {
    const TriangleScene scene = triangle_scene(n, effort == Effort::quick ? 64 : 512);
    for (const std::size_t start : {std::size_t{1}, std::size_t{4}, std::size_t{16}}) {
      rows.push_back(adaptive_row(scene, start));
    }
  }
  return rows;
}

std::string adaptive_rays_section(const std::vector<AdaptiveRow>& rows) {
  if (rows.empty()) return {};
  std::vector<Row> table = {{"triangles", "cells at first", "rays for a point", "rms of fractions", "regions wrong",
                             "stratified: rms", "regions wrong"}};
  for (const AdaptiveRow& row : rows) {
    table.push_back({std::to_string(row.triangles), std::to_string(row.start * row.start), short_text(row.rays),
                     short_text(row.rms), short_text(row.missed), short_text(row.stratified_rms),
                     short_text(row.stratified_missed)});
  }
  return "\n## Adaptive shadow rays, and what they miss\n\n"
         "Rays go to the corners of cells of a square light, and a cell is parted in four where they do not agree (Kok "
         "and\nJansen; [P93] §4.4.1), down to 1/256 of its side; beside as many stratified rays. A blocker that no "
         "corner "
         "sees is\nmissed for good: the errors do not fall with the depth, and the share of points stays high whose "
         "region "
         "is told\nwrong, lit for penumbra mostly. Rays are Embree's, in floats; the exact level's answers are the "
         "truth.\n\n" +
         markdown_table(table) + "\n";
}

}  // namespace gnomon::report
