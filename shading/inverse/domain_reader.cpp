#include "shading/inverse/domain_reader.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/orientation.h"
#include "geometry/scene/scene_elements.h"
#include "shading/inverse/whole.h"

namespace gnomon::inverse {
namespace {

std::vector<Point3> points(const JsonNode& node, std::string_view expected) {
  std::vector<Point3> result;
  for (const JsonNode& item : node.items(expected)) result.push_back(point3(item));
  return result;
}

/// Reads a domain's vertices and checks what its shape asks of them.
class DomainReader {
 public:
  explicit DomainReader(const JsonNode& node) : node_(node) {}

  DesignDomain domain() {
    constexpr const char* shapes =
        "a domain's shape among \"everywhere\", \"box\", \"polytope\", \"polygon\", \"segment\", \"polyline\", "
        "\"directions\", of a scale \"interval\"";
    node_.require_object("a domain: an object with a \"shape\"");
    const JsonNode shape = node_.required("shape", shapes);
    const std::string word = shape.string(shapes);
    if (word == "everywhere") return plain(DomainShape::everywhere);
    if (word == "box") return box();
    if (word == "polytope") return polytope();
    if (word == "polygon") return polygon();
    if (word == "interval") return interval();
    if (word == "segment") return line(DomainShape::segment, 2, 2);
    if (word == "polyline") return line(DomainShape::polyline, 2, 1000);
    if (word == "directions") return directions();
    shape.refuse_value(shapes);
  }

 private:
  DesignDomain plain(DomainShape shape) {
    node_.allow_keys({"shape"}, "a domain without bounds");
    return {shape, {}};
  }

  DesignDomain box() {
    node_.allow_keys({"shape", "min", "max"}, "a box");
    const JsonNode least = node_.required("min", "the box's least x, y, z");
    const JsonNode most = node_.required("max", "the box's largest x, y, z");
    const Point3 a = point3(least), b = point3(most);
    if (a.x >= b.x || a.y >= b.y || a.z >= b.z) most.refuse_value("numbers above those of \"min\"");
    return {DomainShape::box, {a, b}};
  }

  /// Of scales, along the x-axis.
  DesignDomain interval() {
    node_.allow_keys({"shape", "min", "max"}, "an interval");
    const double least = finite(node_.required("min", "the least scale"), "a number above 0");
    const JsonNode most = node_.required("max", "the largest scale");
    const double largest = finite(most, "a number above \"min\"");
    if (!(least > 0)) node_.required("min", "").refuse_value("a number above 0");
    if (!(largest > least)) most.refuse_value("a number above \"min\"");
    return {DomainShape::segment, {{least, 0, 0}, {largest, 0, 0}}};
  }

  std::vector<Point3> vertices(std::string_view what) {
    node_.allow_keys({"shape", "vertices"}, what);
    return points(node_.required("vertices", "an array of points"), "an array of points");
  }

  DesignDomain polytope() {
    const std::vector<Point3> v = vertices("a polytope");
    bool has_volume = false;
    for (std::size_t k = 3; k < v.size() && !has_volume; ++k) {
      for (std::size_t i = 1; i + 1 < k && !has_volume; ++i) {
        for (std::size_t j = i + 1; j < k && !has_volume; ++j)
          has_volume = exact_orientation(v[0], v[i], v[j], v[k]) != 0;
      }
    }
    if (!has_volume) list().refuse("points without a volume between them", "at least 4 points, not all in one plane");
    return {DomainShape::polytope, v};
  }

  DesignDomain polygon() {
    const std::vector<Point3> v = vertices("a polygon");
    const auto defect = ConvexPolygon::defect(v);
    if (defect)
      list().refuse("vertices that are no convex polygon with an area", "a convex polygon, such as a ceiling");
    if (!ConvexPolygon::from_points(v).is_flat()) {
      list().refuse("vertices that are not exactly in one plane", "a flat polygon");
    }
    return {DomainShape::polygon, v};
  }

  DesignDomain line(DomainShape shape, std::size_t least, std::size_t most) {
    const std::vector<Point3> v = vertices("a line");
    if (v.size() < least || v.size() > most) {
      list().refuse_value(most == 2 ? "an array of 2 points" : "an array of 2 to 1000 points");
    }
    for (std::size_t k = 1; k < v.size(); ++k) {
      if (v[k] == v[k - 1]) list().refuse("the same point twice at " + std::to_string(k), "points that differ");
    }
    return {shape, v};
  }

  DesignDomain directions() {
    if (!node_.optional("vertices")) return plain(DomainShape::directions);
    const std::vector<Point3> v = vertices("a cone of directions");
    bool has_inside = false;
    for (std::size_t k = 0; k < v.size(); ++k) {
      if (v[k] == Point3{}) list().refuse("the zero vector at " + std::to_string(k), "directions");
      for (std::size_t i = 0; i < k; ++i) {
        for (std::size_t j = 0; j < i; ++j) has_inside = has_inside || exact_orientation({}, v[j], v[i], v[k]) != 0;
      }
    }
    if (!has_inside || !is_pointed(v)) {
      list().refuse("directions without a cone between them", "at least 3 directions that a plane holds on one side");
    }
    return {DomainShape::directions, v};
  }

  /// True if some plane through the origin has all directions strictly on one side.
  static bool is_pointed(const std::vector<Point3>& rays) {
    std::vector<Whole> generators = {{0, 0, 0, 1}};
    for (const Point3& ray : rays) generators.push_back(whole_direction(ray));
    const auto planes = hull_half_spaces(generators);
    ExactVector sum;
    for (const Whole& plane : planes.value_or(std::vector<Whole>{})) sum = sum + normal_of(plane);
    return std::ranges::all_of(rays, [&](const Point3& ray) { return dot(sum, exact(ray)) < 0; });
  }

  JsonNode list() const { return node_.required("vertices", "an array of points"); }

  const JsonNode& node_;
};

}  // namespace

DesignDomain read_domain(const JsonNode& node) {
  return DomainReader(node).domain();
}

double finite(const JsonNode& node, std::string_view expected) {
  const double value = node.number(expected);
  if (!std::isfinite(value)) node.refuse_value(expected);
  return value;
}

}  // namespace gnomon::inverse
