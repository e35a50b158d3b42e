#include "apps/proof/report/stopwatch.h"

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <string>

namespace gnomon::report {
namespace {

double clock_seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A line "KEY:  123 kB" of /proc/self/status, in bytes; 0 if there is none.
std::size_t status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(key + ":")) return 1024 * std::stoul(line.substr(key.size() + 1));
  }
  return 0;
}

}  // namespace

double thread_seconds() {
  return clock_seconds(CLOCK_THREAD_CPUTIME_ID);
}

Seconds seconds_of(std::vector<double> runs) {
  std::sort(runs.begin(), runs.end());
  return {runs[runs.size() / 2], runs.front(), runs.back()};
}

Seconds time_per_result(const std::function<void()>& pass, std::size_t results, const Care& care) {
  const double start = thread_seconds();
  pass();
  const double once = std::max(thread_seconds() - start, 1e-7);
  const auto repeats = static_cast<std::size_t>(std::max(1.0, care.seconds / once));
  std::vector<double> runs;
  for (std::size_t run = 0; run < care.runs; ++run) {
    const double before = thread_seconds();
    for (std::size_t i = 0; i < repeats; ++i) pass();
    runs.push_back((thread_seconds() - before) / static_cast<double>(repeats * results));
  }
  return seconds_of(std::move(runs));
}

std::size_t memory_growth(const std::function<void()>& work) {
  // What was freed before goes back to the system; the highest mark starts anew from here.
  malloc_trim(0);
  { std::ofstream("/proc/self/clear_refs") << 5; }
  const std::size_t before = status_bytes("VmRSS");
  work();
  const std::size_t highest = status_bytes("VmHWM");
  return highest > before ? highest - before : 0;
}

}  // namespace gnomon::report
