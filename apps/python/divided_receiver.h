#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "gnomon/receiver_mesh.h"

namespace gnomon::python {

/// A receiver, or a flat piece of one, divided by what it receives of a light.
struct DividedReceiver {
  std::string light, receiver, side;
  ReceiverMesh mesh;
  std::vector<double> fractions;                             ///< of every vertex, where they were asked for
  std::shared_ptr<const std::vector<std::string>> blockers;  ///< names of the convex blockers that events number
};

/// The class gnomon.DividedReceiver.
void bind_divided_receiver(pybind11::module_& module);

}  // namespace gnomon::python
