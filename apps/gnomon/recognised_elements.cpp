#include "apps/gnomon/recognised_elements.h"

#include <variant>

#include "apps/gnomon/light_groups.h"
#include "geometry/scene/receiver_facets.h"
#include "shading/light_flux.h"

namespace gnomon {
namespace {

/// One element from the shape of a light or blocker; the name is added by the caller.
struct Recognise {
  RecognisedElement operator()(const PointLight&) const { return plain("point", 1); }
  RecognisedElement operator()(const DirectionalLight&) const { return plain("direction", std::nullopt); }
  RecognisedElement operator()(const LinearLight&) const { return plain("segment", 2); }
  RecognisedElement operator()(const AreaLight& light) const {
    RecognisedElement element = plain("polygon", light.polygon.points().size());
    element.two_sided = light.two_sided;
    return element;
  }
  RecognisedElement operator()(const ConvexPolygon& polygon) const { return plain("polygon", polygon.points().size()); }
  RecognisedElement operator()(const Polytope& polytope) const { return plain("polytope", polytope.vertices.size()); }
  RecognisedElement operator()(const ConcavePolygon& polygon) const {
    RecognisedElement element = plain(polygon.shape, polygon.vertices.size());
    if (polygon.rings.size() > 1) element.holes = polygon.rings.size() - 1;
    return element;
  }
  RecognisedElement operator()(const Mesh& mesh) const {
    RecognisedElement element = plain("mesh", mesh.vertices.size());
    element.facets = mesh.facets.size();
    element.closed = mesh.closed;
    return element;
  }

  static RecognisedElement plain(std::string shape, std::optional<std::size_t> vertices) {
    RecognisedElement element;
    element.shape = std::move(shape);
    element.vertices = vertices;
    return element;
  }
};

Strength strength(const std::string& shape, double value) {
  if (shape == "polygon") return {"radiance", value, "W/(m^2 sr)"};
  if (shape == "segment") return {"intensity_per_length", value, "W/(sr m)"};
  if (shape == "point") return {"intensity", value, "W/sr"};
  return {"irradiance", value, "W/m^2"};
}

RecognisedElement recognised(const SceneLight& light) {
  RecognisedElement element = std::visit(Recognise{}, light.shape);
  element.strength = strength(element.shape, light.strength);
  return element;
}

std::vector<RecognisedElement> recognised_lights(const SpaceScene& scene) {
  std::vector<RecognisedElement> list;
  for (const LightGroup& group : chosen_groups(scene, "")) {
    const SceneLight& first = *group.parts.front();
    list.push_back(recognised(first));
    RecognisedElement& element = list.back();
    element.name = group.name;
    if (first.is_part()) {
      element.shape = first.form;
      element.vertices.reset();
      element.facets = group.parts.size();
    }
    std::optional<double> flux = 0;
    for (const SceneLight* part : group.parts) {
      const auto own = light_flux(part->shape, part->strength, *length_unit_named(scene.length_unit));
      flux = own && flux ? std::optional(*flux + *own) : std::nullopt;
    }
    element.flux = flux;
  }
  return list;
}

RecognisedElement recognised(const SceneBlocker& blocker) {
  return std::visit(Recognise{}, blocker.shape);
}

RecognisedElement recognised(const PlanarLight& light) {
  RecognisedElement element = Recognise::plain(light.vertices.size() == 1 ? "point" : "segment", light.vertices.size());
  element.strength = strength(element.shape, light.strength);
  return element;
}

RecognisedElement recognised(const PlanarBlocker& blocker) {
  return Recognise::plain(blocker.vertices.size() == 2 ? "segment" : "polyline", blocker.vertices.size());
}

template <class Element>
std::vector<RecognisedElement> recognised(const std::vector<Element>& elements) {
  std::vector<RecognisedElement> list;
  for (const Element& element : elements) {
    list.push_back(recognised(element));
    list.back().name = element.name;
  }
  return list;
}

/// One receiver of the file: a polygon, or several facets, a mesh.
RecognisedElement recognised(ReceiverGroup receiver) {
  const std::size_t sides = receiver.front().side == receiver.back().side ? 1 : 2;
  const std::size_t facets = receiver.size() / sides;
  RecognisedElement element;
  element.name = receiver.front().element;
  element.shape = receiver.front().form;
  if (facets == 1) element.vertices = receiver.front().shape.points().size();
  if (facets > 1) element.facets = facets;
  if (sides == 2) element.two_sided = true;
  return element;
}

std::vector<RecognisedElement> recognised_lights(const PlaneScene& scene) {
  return recognised(scene.lights);
}

/// A receiver of the file may be several facets.
std::vector<RecognisedElement> recognised(const std::vector<SceneReceiver>& receivers) {
  std::vector<RecognisedElement> list;
  for (const ReceiverGroup receiver : receiver_elements(receivers)) list.push_back(recognised(receiver));
  return list;
}

}  // namespace

RecognisedElements recognised_elements(const Scene& scene) {
  const auto of_lists = [](const auto& some) -> RecognisedElements {
    return {recognised_lights(some), recognised(some.blockers), recognised(some.receivers)};
  };
  return std::visit(of_lists, scene);
}

}  // namespace gnomon
