#pragma once

/// Work that threads share: the only place in the libraries where threads are started.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <vector>

namespace gnomon {

/// Runs `work(i, worker)` for all i below n, each once, on at most `threads` threads, this one among them. Calls with
/// the same `worker`, a number below `threads`, follow one another, so memory may be kept for each. With one thread the
/// order is ascending.
///
/// Requires: no call depends on another.
/// Throws:   what a call throws, one of them if several do; others may have run by then.
template <class Work>
void for_all(std::size_t n, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next = 0;
  const auto run = [&](std::size_t worker) {
    for (std::size_t i = next++; i < n; i = next++) work(i, worker);
  };
  std::vector<std::future<void>> helpers;
  for (std::size_t worker = 1; worker < std::min<std::size_t>(threads, n); ++worker) {
    helpers.push_back(std::async(std::launch::async, run, worker));
  }
  run(0);
  for (std::future<void>& helper : helpers) helper.get();
}

}  // namespace gnomon
