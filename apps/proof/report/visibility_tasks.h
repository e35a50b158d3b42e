#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/proof/report/measurement.h"

namespace gnomon::report {

/// A part of the report that is measured in one go.
struct Task {
  std::string name;
  std::function<std::vector<Measurement>()> measure;
};

/// How much work to put in.
enum class Effort { quick, full };

/// Visible fraction and irradiance at points below a square light, behind n random triangles: one task per n.
///
/// Measurements of the tasks "visible_fraction" and "irradiance" by the methods exact, gnomon, plain_doubles,
/// embree_regular, embree_jittered, embree_stratified, embree_packets and polygon_set_2.
std::vector<Task> visibility_tasks(Effort effort);

}  // namespace gnomon::report
