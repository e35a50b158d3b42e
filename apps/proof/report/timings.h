#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "apps/proof/report/stopwatch.h"
#include "apps/proof/report/visibility_tasks.h"

namespace gnomon::report {

/// What one thing of a size takes, where nothing but the time, the memory or a count is asked.
struct Timing {
  std::string task;
  std::size_t size = 0;    ///< vertices per polygon, facets, triangles, receivers, points: the task says
  Seconds seconds{};       ///< for all of it
  std::size_t count = 0;   ///< of faces that came of it, or of points left to the exact level
  std::size_t memory = 0;  ///< bytes by which the process grew; 0 where that is not asked
};

/// Timings that are measured in one go.
struct TimingTask {
  std::string name;
  std::function<std::vector<Timing>()> measure;
};

/// The scenes of the benchmarks that have targets, as far as other parts of the report do not measure them.
///
/// Tasks: "exact_planes" and "plain_planes" of n by n vertices (all extremal planes, and the same walk in plain
/// doubles), "meshes" (occlusion and umbra of n by n vertices), "solid_meshes" (of a solid of n facets), "mesh_parts"
/// (of n triangles one by one), "lambert_quad" (a square in full view), "random_points" (n points behind random
/// triangles; the count is of those that the exact level has to answer), "set_up" (n triangles, up to the first
/// answer), those of reflection_timings and reflection_peers; and in full, each once: "sphere_picture" (of Table I, n
/// by n pixels), "hexagon_stacks" and "square_stacks" (n receivers; the count is of faces).
std::vector<TimingTask> timing_tasks(Effort effort);

/// What one evaluation takes of what a floor reflects, bounds included, nothing hidden; the size is the exponent.
/// Tasks: "point_diffuse", "point_phong", "line_diffuse", "line_phong", "line_blinn", "lamp_lambert", "lamp_phong",
/// "lamp_blinn".
std::vector<Timing> reflection_timings(Effort effort);

}  // namespace gnomon::report
