#include "geometry/scene/mesh_facets.h"

#include <utility>

#include "geometry/scene/polygon_examination.h"

namespace gnomon {
namespace {

/// How many facets are of a kind, and the first of them.
struct Tally {
  std::size_t count = 0;
  std::string first;

  void add(const PolygonSoup& soup, std::size_t facet) {
    if (count++ == 0) first = facet_place(soup, facet);
  }

  /// "3 facets (the first: line 7, facet 0) are bent"
  std::string text(const std::string& one, const std::string& several) const {
    if (count == 1) return "a facet (" + first + ") " + one;
    return std::to_string(count) + " facets (the first: " + first + ") " + several;
  }
};

class FacetCheck {
 public:
  FacetCheck(const PolygonSoup& soup, const MeshSource& source) : soup_(soup), source_(source) {}

  CheckedFacets run(const std::string& length_unit) {
    for (std::size_t f = 0; f < soup_.facets.size(); ++f) check(f);
    if (repeats_.count > 0) add_doubt(repeats_.text("repeats", "repeat"), " a neighbouring vertex, which counts once");
    if (without_area_.count > 0) add_doubt(without_area_.text("has", "have"), " no area: left out");
    if (spikes_.count > 0) add_doubt(spikes_.text("runs", "run"), " along an edge and back, which bounds nothing");
    const auto deviation = [&](double most) {
      return "; the largest deviation from a plane is " + few_digits(most) + " " + length_unit;
    };
    if (rounded_.count > 0) {
      add_doubt(rounded_.text("is", "are"), " not exactly coplanar and counts as rounded" + deviation(most_rounded_));
    }
    if (bent_.count > 0) add_doubt(bent_.text("is", "are"), " bent and taken as triangles" + deviation(most_bent_));
    return std::move(result_);
  }

 private:
  void check(std::size_t f) {
    const Ring facet = without_repeats(soup_.vertices, soup_.facets[f]);
    if (facet.size() < soup_.facets[f].size()) repeats_.add(soup_, f);
    const std::vector<Point3> points = points_of_rings(soup_.vertices, {&facet, 1});
    if (points.size() < 3 || (points.size() == 3 && !polygon_plane(points))) return without_area_.add(soup_, f);
    if (points.size() > 3 && !is_polygon(f, points)) return without_area_.add(soup_, f);
    result_.facets.push_back(facet);
    result_.numbers.push_back(static_cast<std::uint32_t>(f));
  }

  /// False if the facet has no area.
  bool is_polygon(std::size_t f, const std::vector<Point3>& points) {
    const PolygonExamination polygon = examined_polygon(points, whole_ring(points.size()));
    if (!polygon.has_area) return false;
    if (polygon.refusal) {
      std::string place = facet_place(soup_, f);
      if (polygon.refusal->vertex) place += ", corner " + std::to_string(*polygon.refusal->vertex);
      source_.refuse(place, polygon.refusal->found, polygon.refusal->expected);
    }
    if (polygon.rings.size() == 1 && polygon.rings[0].size() < points.size()) spikes_.add(soup_, f);
    if (polygon.plane.flatness == Flatness::rounded) note(rounded_, most_rounded_, f, polygon.plane.deviation);
    if (polygon.plane.flatness == Flatness::bent) note(bent_, most_bent_, f, polygon.plane.deviation);
    return true;
  }

  void note(Tally& tally, double& most, std::size_t f, double deviation) {
    tally.add(soup_, f);
    most = std::max(most, deviation);
  }

  void add_doubt(const std::string& subject, const std::string& rest) { result_.doubts.push_back(subject + rest); }

  const PolygonSoup& soup_;
  const MeshSource& source_;
  CheckedFacets result_;
  Tally repeats_, without_area_, spikes_, rounded_, bent_;
  double most_rounded_ = 0;
  double most_bent_ = 0;
};

}  // namespace

CheckedFacets checked_facets(const PolygonSoup& soup, const MeshSource& source, const std::string& length_unit) {
  return FacetCheck(soup, source).run(length_unit);
}

}  // namespace gnomon
