#include <benchmark/benchmark.h>

#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "tests/benchmarks/ratios.h"

namespace gnomon::benchmarks {
namespace {

/// Prints as Google Benchmark does on a console, and keeps the median of what it is told.
class MedianReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      failed_ = failed_ || run.error_occurred;
      const bool counts = run.run_type == Run::RT_Iteration || run.aggregate_name == "median";
      if (!counts || run.error_occurred) continue;
      const std::string& arguments = run.run_name.args;
      const std::string name = run.run_name.function_name + (arguments.empty() ? "" : "/" + arguments);
      medians_[name] = run.GetAdjustedCPUTime() * 1e9 / benchmark::GetTimeUnitMultiplier(run.time_unit);
    }
    ConsoleReporter::ReportRuns(runs);
  }

  const std::map<std::string, double>& medians() const { return medians_; }
  bool failed() const { return failed_; }

 private:
  std::map<std::string, double> medians_;
  bool failed_ = false;
};

/// Repetitions of all benchmarks are mixed, so that a slow second of the machine falls upon all alike; what the
/// command line says comes later and wins.
int run(int argc, char** argv) {
  std::vector<std::string> defaults = {"--benchmark_repetitions=5", "--benchmark_min_time=0.05",
                                       "--benchmark_enable_random_interleaving=true",
                                       "--benchmark_display_aggregates_only=true"};
  std::vector<char*> arguments = {argv[0]};
  for (std::string& argument : defaults) arguments.push_back(argument.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  MedianReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  print_ratios(std::cout, reporter.medians());
  return reporter.failed() ? 1 : 0;
}

}  // namespace
}  // namespace gnomon::benchmarks

int main(int argc, char** argv) {
  return gnomon::benchmarks::run(argc, argv);
}
