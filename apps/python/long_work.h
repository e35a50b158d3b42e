#pragma once

/// Work that Python waits for: without the interpreter's lock, and so that Ctrl-C ends it.

#include <pybind11/pybind11.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "apps/python/arrays.h"
#include "geometry/parallel.h"

namespace gnomon::python {

/// How many threads are meant, 0 being one per processor.
///
/// Throws: ArgumentError for more than the program takes.
inline unsigned checked_threads(unsigned asked) {
  if (asked <= 1024) return thread_count(asked);
  throw ArgumentError("threads: found " + std::to_string(asked) + ", expected 1 to 1024, or 0");
}

/// As many threads as pay for that many questions.
inline unsigned threads_for(std::size_t questions, unsigned asked) {
  constexpr std::size_t few = 64;
  if (asked == 0 && questions < few) return 1;
  return static_cast<unsigned>(std::min<std::size_t>(checked_threads(asked), std::max<std::size_t>(questions, 1)));
}

/// Runs `work(i, worker)` for all i below n as for_all does, without the interpreter's lock. Between batches signals
/// are looked at.
///
/// Throws: what `work` throws, error_already_set for a signal.
template <class Work>
void without_lock(std::size_t n, unsigned threads, const Work& work) {
  constexpr std::size_t batch = 16384;
  for (std::size_t first = 0; first < n; first += batch) {
    {
      const pybind11::gil_scoped_release release;
      const std::size_t count = std::min(batch, n - first);
      if (threads < 2) {
        for (std::size_t i = 0; i < count; ++i) work(first + i, std::size_t{0});
      } else {
        for_all(count, threads, [&](std::size_t i, std::size_t worker) { work(first + i, worker); });
      }
    }
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
  }
}

}  // namespace gnomon::python
