#include "tests/benchmarks/ratios.h"

#include <iomanip>
#include <utility>
#include <vector>

namespace gnomon::benchmarks {
namespace {

std::vector<Ratio>& all_ratios() {
  static std::vector<Ratio> ratios;
  return ratios;
}

}  // namespace

bool add_ratio(Ratio ratio) {
  all_ratios().push_back(std::move(ratio));
  return true;
}

void print_ratios(std::ostream& out, const std::map<std::string, double>& medians) {
  out << "\nRatios of this run's median CPU times\n";
  for (const Ratio& ratio : all_ratios()) {
    const auto subject = medians.find(ratio.subject);
    const auto reference = medians.find(ratio.reference);
    if (subject == medians.end() || reference == medians.end()) continue;
    const double value = ratio.scale * subject->second / reference->second;
    out << std::setw(10) << std::setprecision(3) << value << "  " << ratio.text;
    if (ratio.at_most > 0) {
      out << " (at most " << ratio.at_most << ": " << (value <= ratio.at_most ? "yes" : "NO") << ")";
    }
    out << "\n";
  }
}

}  // namespace gnomon::benchmarks
