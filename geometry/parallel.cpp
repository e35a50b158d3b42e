#include "geometry/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace gnomon {

unsigned thread_count(unsigned asked) {
  return asked != 0 ? asked : static_cast<unsigned>(std::max(1, tbb::this_task_arena::max_concurrency()));
}

void for_all(std::size_t n, unsigned threads, const std::function<void(std::size_t, std::size_t)>& work) {
  const std::size_t workers = std::min<std::size_t>(threads, n);
  if (workers < 2) {
    for (std::size_t i = 0; i < n; ++i) work(i, 0);
    return;
  }
  // Calls differ much in what they cost, so each worker takes the next one. The arena is new, so that whoever waits
  // here takes up no call of a loop around this one.
  std::atomic<std::size_t> next = 0;
  const auto run = [&](std::size_t worker) {
    for (std::size_t i = next++; i < n; i = next++) work(i, worker);
  };
  tbb::task_arena arena(static_cast<int>(workers));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, workers, run, tbb::simple_partitioner()); });
}

}  // namespace gnomon
