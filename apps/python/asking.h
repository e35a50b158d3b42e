#pragma once

/// Questions about many points of a scene, which workers answer.

#include <exception>
#include <memory>
#include <vector>

#include "apps/python/arrays.h"
#include "apps/python/long_work.h"
#include "apps/python/prepared_scene.h"

namespace gnomon::python {

/// Calls `work(i, worker)` for all i below n with workers of the pool, and gives these back whatever happens.
template <class Worker, class Make, class Work>
void ask(Pool<Worker>& pool, std::size_t n, unsigned threads, const Make& make, const Work& work) {
  auto workers = pool.take(threads, make);
  try {
    without_lock(n, threads, [&](std::size_t i, std::size_t w) { work(i, *workers[w]); });
  } catch (...) {
    pool.give_back(std::move(workers));
    throw;
  }
  pool.give_back(std::move(workers));
}

/// The points and normals of receivers.
struct ReceiverArrays {
  Rows points, normals;

  /// Throws: ArgumentError unless there is a normal for each point, and none is zero.
  ReceiverArrays(const pybind11::object& at, const pybind11::object& facing)
      : points(at, "points", 3), normals(facing, "normals", 3) {
    normals.require_count(points);
    normals.require_directions();
  }

  std::size_t count() const { return points.count(); }
  ReceiverPoint receiver(const PreparedObstacles& obstacles, std::size_t i) const {
    return resting_point(obstacles, points.point(i), normals.point(i));
  }
};

}  // namespace gnomon::python
