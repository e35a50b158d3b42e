#pragma once

#include <cstddef>
#include <functional>

namespace gnomon {

/// How many threads that is: 0 asks for one per processor.
unsigned thread_count(unsigned asked);

/// Runs `work(i, worker)` for all i below n, each once, on at most `threads` threads, this one among them. Calls with
/// the same `worker`, a number below `threads`, follow one another, so memory may be kept for each. With one thread the
/// order is ascending.
///
/// Requires: no call depends on another.
/// Throws:   what a call throws, one of them if several do; others may have run by then.
void for_all(std::size_t n, unsigned threads, const std::function<void(std::size_t i, std::size_t worker)>& work);

}  // namespace gnomon
