#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/numbers/exact_vector.h"
#include "geometry/scene/file_text.h"
#include "geometry/scene/json_node.h"
#include "geometry/scene/json_text.h"
#include "geometry/scene/scene_elements.h"
#include "gnomon/paint_fit.h"

namespace gnomon {
namespace {

constexpr std::size_t largest_paint_file = std::size_t{64} << 20;

/// True if a point lies in a convex polygon's plane and within its sides, exactly.
bool is_on(const ConvexPolygon& polygon, const Point3& point) {
  const auto points = polygon.points();
  const auto corners = polygon.corners();
  const ExactVector p = exact(point), first = exact(points[corners[0]]);
  const ExactVector normal = cross(exact(points[corners[1]]) - first, exact(points[corners[2]]) - first);
  if (dot(normal, p - first) != 0) return false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const ExactVector a = exact(points[corners[k]]), b = exact(points[corners[(k + 1) % corners.size()]]);
    if (dot(cross(b - a, p - a), normal) < 0) return false;
  }
  return true;
}

Point3 normal_of(const ConvexPolygon& polygon) {
  const auto points = polygon.points();
  const auto corners = polygon.corners();
  const Vector3<double> n =
      cross(step(points[corners[0]], points[corners[1]]), step(points[corners[0]], points[corners[2]]));
  return {n.x, n.y, n.z};
}

/// Reads one paint file beside its scene.
class PaintReader {
 public:
  PaintReader(const JsonNode& document, const SpaceScene& scene) : document_(document), scene_(scene) {}

  Paint paint() {
    document_.require_object("an object with the keys \"gnomon_paint\", \"fit\", \"samples\"");
    document_.allow_keys({"$schema", "gnomon_paint", "fit", "lights", "exponent", "model", "samples"}, "a paint file");
    const JsonNode version = document_.required("gnomon_paint", "the version of the format, 1");
    if (!version.is_number(1)) version.refuse_value("the version of the format, 1");
    constexpr const char* fits = "\"intensities\" or \"material\"";
    const JsonNode fit = document_.required("fit", fits);
    const std::string word = fit.string(fits);
    if (word != "intensities" && word != "material") fit.refuse_value(fits);
    paint_.fit = word == "material" ? Paint::Fit::material : Paint::Fit::intensities;
    word == "material" ? read_material() : read_lights();
    read_samples();
    return paint_;
  }

 private:
  void read_lights() {
    refuse_key("exponent", "with \"fit\": \"material\"");
    refuse_key("model", "with \"fit\": \"material\"");
    std::string known;
    for (const SceneLight& light : scene_.lights) known += (known.empty() ? "" : ", ") + in_quotes(light.element);
    const std::string expected = "an array of names of lights among " + known;
    const JsonNode list = document_.required("lights", expected);
    for (const JsonNode& node : list.items(expected)) {
      const std::string name = node.string("the name of a light among " + known);
      const auto is_called = [&](const SceneLight& light) { return light.name == name || light.element == name; };
      if (std::ranges::none_of(scene_.lights, is_called)) node.refuse_value("the name of a light among " + known);
      if (std::ranges::find(paint_.lights, name) != paint_.lights.end())
        node.refuse(in_quotes(name) + " again", "each light once");
      paint_.lights.push_back(name);
    }
    if (paint_.lights.empty()) list.refuse("no light", expected);
  }

  void read_material() {
    refuse_key("lights", "with \"fit\": \"intensities\"; all lights shine on a material");
    constexpr const char* exponents = "\"free\" or a whole number from 0 to 10000";
    const JsonNode exponent = document_.required("exponent", exponents);
    if (exponent.description() != "the string \"free\"") {
      const double n = exponent.number(exponents);
      if (!(n >= 0 && n <= 10000) || n != std::floor(n)) exponent.refuse_value(exponents);
      paint_.exponent = static_cast<std::uint32_t>(n);
    }
    const auto model = document_.optional("model");
    if (!model) return;
    constexpr const char* models = "\"phong\", \"blinn\", \"phong_classic\" or \"blinn_classic\"";
    const std::string word = model->string(models);
    if (word == "blinn")
      paint_.model = ReflectionModel::blinn;
    else if (word == "phong_classic")
      paint_.model = ReflectionModel::phong_classic;
    else if (word == "blinn_classic")
      paint_.model = ReflectionModel::blinn_classic;
    else if (word != "phong")
      model->refuse_value(models);
  }

  void refuse_key(const char* key, const std::string& only) {
    if (const auto node = document_.optional(key)) node->refuse(node->description(), "none, but " + only);
  }

  void read_samples() {
    constexpr const char* expected = "an array of samples, at least one";
    const JsonNode list = document_.required("samples", expected);
    const std::vector<JsonNode> items = list.items(expected);
    if (items.empty()) list.refuse("no sample", expected);
    for (const JsonNode& node : items) read_sample(node);
  }

  void read_sample(const JsonNode& node) {
    node.require_object("a sample: an object with \"at\"");
    const bool is_material = paint_.fit == Paint::Fit::material;
    if (is_material) {
      node.allow_keys({"at", "normal", "eye", "radiance", "between"}, "a sample of a material");
    } else {
      node.allow_keys({"at", "normal", "irradiance"}, "a sample of irradiance");
    }
    PaintSample sample;
    const JsonNode at = node.required("at", "a point");
    sample.point = point3(at);
    sample.normal = normal(node, at, sample.point);
    if (is_material) {
      sample.eye = point3(node.required("eye", "where the eye is"));
      if (sample.eye == sample.point) node.required("eye", "").refuse("the point itself", "another place");
    }
    read_wanted(node, is_material ? "radiance" : "irradiance", sample);
    paint_.samples.push_back(std::move(sample));
  }

  Point3 normal(const JsonNode& node, const JsonNode& at, const Point3& point) {
    if (const auto given = node.optional("normal")) {
      const Point3 n = point3(*given);
      if (n == Point3{}) given->refuse("the zero vector", "a normal");
      return n;
    }
    for (const SceneReceiver& receiver : scene_.receivers) {
      if (receiver.shape.is_flat() && is_on(receiver.shape, point)) return normal_of(receiver.shape);
    }
    at.refuse("a point on no receiver, and no \"normal\"", "a point exactly on a receiver, or a normal");
  }

  void read_wanted(const JsonNode& node, const char* key, PaintSample& sample) {
    const auto wanted = node.optional(key), between = node.optional("between");
    if (wanted && between) between->refuse("bounds beside " + std::string(key), "one of them");
    if (between) {
      constexpr const char* expected = "an array of the least and the largest";
      const std::vector<JsonNode> ends = between->items(expected);
      if (ends.size() != 2) between->refuse_value(expected);
      sample.least = colours(ends[0]);
      sample.most = colours(ends[1]);
      for (std::size_t c = 0; c < sample.least.size(); ++c) {
        if (!(sample.least[c] <= sample.most[c])) between->refuse("a least number above the largest", expected);
      }
      return;
    }
    sample.wanted = colours(node.required(key, "a number, or three of red, green and blue"));
  }

  /// One number or three, in all samples alike.
  std::vector<double> colours(const JsonNode& node) {
    constexpr const char* expected = "a number of at least 0, or three of red, green and blue, as in the first sample";
    std::vector<double> values;
    if (node.description().starts_with("an array")) {
      for (const JsonNode& item : node.items(expected)) values.push_back(number(item, expected));
      if (values.size() != 3) node.refuse_value(expected);
    } else {
      values.push_back(number(node, expected));
    }
    if (!has_channels_) paint_.channels = static_cast<std::uint32_t>(values.size());
    has_channels_ = true;
    if (values.size() != paint_.channels) node.refuse_value(expected);
    return values;
  }

  static double number(const JsonNode& node, const char* expected) {
    const double value = node.number(expected);
    if (!(value >= 0) || !std::isfinite(value)) node.refuse_value(expected);
    return value;
  }

  const JsonNode& document_;
  const SpaceScene& scene_;
  Paint paint_;
  bool has_channels_ = false;
};

}  // namespace

Paint parse_paint(std::string_view text, const std::string& source, const SpaceScene& scene) {
  const nlohmann::json document = parse_json(text, source);
  return PaintReader(JsonNode(document, source), scene).paint();
}

Paint read_paint(const std::filesystem::path& file, const SpaceScene& scene) {
  const FileText text = file_text(file, largest_paint_file);
  if (!text.problem.empty()) throw SceneError(file.string() + ": found " + text.problem + "; expected a paint file");
  return parse_paint(text.text, file.string(), scene);
}

}  // namespace gnomon
