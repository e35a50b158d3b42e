#include <algorithm>
#include <optional>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/division_plan.h"
#include "apps/python/bindings.h"
#include "apps/python/divided_receiver.h"
#include "apps/python/long_work.h"

namespace gnomon::python {
namespace {

/// Divides all receivers of a plan by one light. The interpreter's lock is not held.
std::vector<DividedReceiver> divided_by(const DivisionPlan& plan, const SceneLight& light, bool with_fractions,
                                        unsigned threads) {
  std::vector<ConvexPolygon> shapes;
  for (const std::uint32_t r : plan.receivers) shapes.push_back(plan.space->receivers[r].shape);
  const auto names = std::make_shared<const std::vector<std::string>>(plan.bodies.names);
  const ReceiverDivision division(light.shape, plan.bodies.obstacles.blockers, shapes, threads,
                                  plan.bodies.obstacles.enclosures);
  const unsigned for_each = std::max(1U, threads / static_cast<unsigned>(std::max<std::size_t>(1, shapes.size())));
  std::vector<std::optional<DividedReceiver>> made(shapes.size());
  for_all(shapes.size(), threads, [&](std::size_t i, std::size_t) {
    const SceneReceiver& receiver = plan.space->receivers[plan.receivers[i]];
    const auto r = static_cast<std::uint32_t>(i);
    made[i] = DividedReceiver{light.name, receiver.name, receiver.side, division.mesh(r, for_each), {}, names};
    if (with_fractions) made[i]->fractions = division.visible_fractions(r, made[i]->mesh, for_each);
  });
  std::vector<DividedReceiver> result;
  for (auto& one : made) result.push_back(std::move(*one));
  return result;
}

py::list receivers(const SceneValue& value, const std::string& receiver, const std::string& light, bool with_fractions,
                   unsigned threads) {
  const std::shared_ptr<PreparedScene> scene = value.prepared();
  const unsigned workers = checked_threads(threads);
  const DivisionPlan plan = division_plan(scene->scene(), {light, receiver}, DivisionOf::receivers);
  if (!plan.refusal.empty()) throw UnsupportedError(plan.space->source + ": " + plan.refusal);
  for (const std::string& sentence : plan.left_out) warn(sentence);
  py::list result;
  for (const std::uint32_t l : plan.lights) {
    std::vector<DividedReceiver> made;
    {
      const py::gil_scoped_release release;
      made = divided_by(plan, plan.space->lights[l], with_fractions, workers);
    }
    for (DividedReceiver& one : made) result.append(py::cast(std::move(one)));
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return result;
}

}  // namespace

void bind_receivers(py::module_& module, SceneClass& scene) {
  bind_divided_receiver(module);
  scene.def("receivers", &receivers, py::arg("receiver") = "", py::kw_only(), py::arg("light") = "",
            py::arg("fractions") = false, py::arg("threads") = 0,
            R"(The receivers of the scene, each divided by what it receives of each light.

receiver, light: only those of that name. fractions: also the visible fraction at every
vertex. threads: 0 is one per processor.
Returns a list of DividedReceiver, light by light; a receiver of several flat pieces has
one for each. Raises UnsupportedError, with the program's sentence, where nothing can be
divided; lights that are left out beside others are told by a SceneWarning.)");
}

}  // namespace gnomon::python
