#pragma once

#include <map>
#include <ostream>
#include <string>

namespace gnomon::benchmarks {

/// One line of the summary: how long one benchmark takes in units of another one.
///
/// Benchmarks are named as they print themselves, arguments included: "extremal_planes/exact/256".
struct Ratio {
  std::string subject;
  std::string reference;
  double scale = 1;    ///< multiplies the ratio, e.g. by how much smaller the subject's input is
  double at_most = 0;  ///< what is aimed at; 0: nothing
  std::string text;    ///< what the number says
};

/// Asks for a line of the summary. Returns true, so that a namespace-scope constant can ask.
bool add_ratio(Ratio ratio);

/// Prints the lines whose two benchmarks were run, from median times in nanoseconds by name.
void print_ratios(std::ostream& out, const std::map<std::string, double>& medians);

}  // namespace gnomon::benchmarks
