#include "apps/gnomon/view_factor_output.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/gnomon/output_file.h"
#include "apps/gnomon/text.h"
#include "geometry/numbers/printed_bound.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

const char* kind_of_bound(bool is_proven) {
  return is_proven ? "proven" : "estimate";
}

bool is_asked(std::uint32_t surface, const std::optional<std::uint32_t>& from) {
  return !from || surface == *from;
}

double largest_bound(const ViewFactors& factors) {
  double largest = 0;
  for (const ViewFactor& f : factors.factors) largest = std::max(largest, f.error_bound);
  return largest;
}

std::string npy_head(std::size_t n) {
  std::string head =
      "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(n) + ", " + std::to_string(n) + "), }";
  // Magic, version and length take 10 bytes; blanks and a line end fill up to a multiple of 64.
  head.append(63 - (head.size() + 10) % 64, ' ');
  head += '\n';
  std::string start = "\x93NUMPY";
  start += '\x01';
  start += '\0';
  start += static_cast<char>(head.size() % 256);
  start += static_cast<char>(head.size() / 256);
  return start + head;
}

void append_double(std::string& bytes, double value) {
  auto bits = std::bit_cast<std::uint64_t>(value);
  for (int k = 0; k < 8; ++k, bits >>= 8U) bytes += static_cast<char>(bits & 0xFFU);
}

/// Row by row, so that the matrix need not be in memory as text too.
void write_matrix(const std::filesystem::path& file, const ViewFactors& factors, double ViewFactor::*value) {
  OutputFile output(file);
  const std::size_t n = factors.areas.size();
  output.stream() << npy_head(n);
  auto next = factors.factors.begin();
  for (std::uint32_t i = 0; i < n; ++i) {
    std::vector<double> row(n, 0.0);
    for (; next != factors.factors.end() && next->from == i; ++next) row[next->to] = (*next).*value;
    std::string bytes;
    for (const double x : row) append_double(bytes, x);
    output.stream() << bytes;
  }
  output.publish();
}

}  // namespace

std::vector<RowSum> row_sums(const ViewFactors& factors) {
  std::vector<RowSum> sums(factors.areas.size());
  for (const ViewFactor& f : factors.factors) {
    RowSum& sum = sums[f.from];
    sum.value += f.value;
    // Each sum may be rounded by half a unit of its last place, and is below 2.
    sum.error_bound += f.error_bound + 0x1p-52;
  }
  return sums;
}

SkyFactor sky_factor(const RowSum& sum) {
  return {std::clamp(1 - sum.value, 0.0, 1.0), sum.error_bound + 0x1p-52};
}

void write_factors_csv(std::ostream& stream, const ViewSurfaces& surfaces, const ViewFactors& factors,
                       const std::optional<std::uint32_t>& from, bool open) {
  const std::vector<RowSum> sums = row_sums(factors);
  stream << "from,to,area,factor,error_bound,bound_is\n";
  const auto write = [&](std::uint32_t i, const std::string& to, double value, double bound, bool is_proven) {
    stream << csv_field(surfaces.names[i]) << ',' << to << ',' << number_text(factors.areas[i]) << ','
           << number_text(value) << ',' << number_text(printed_error_bound(value, bound)) << ','
           << kind_of_bound(is_proven) << '\n';
  };
  auto next = factors.factors.begin();
  for (std::uint32_t i = 0; i < surfaces.names.size(); ++i) {
    bool all_proven = true;
    for (; next != factors.factors.end() && next->from == i; ++next) {
      all_proven = all_proven && next->is_proven;
      write(i, csv_field(surfaces.names[next->to]), next->value, next->error_bound, next->is_proven);
    }
    if (!open || !is_asked(i, from)) continue;
    const SkyFactor sky = sky_factor(sums[i]);
    write(i, "sky", sky.value, sky.error_bound, all_proven);
  }
}

Json factors_json(const Scene& scene, const ViewSurfaces& surfaces, const ViewFactors& factors,
                  const std::optional<std::uint32_t>& from, double bound) {
  const std::vector<RowSum> sums = row_sums(factors);
  Json list = Json::array();
  double closure = 0, closure_bound = 0;
  for (std::uint32_t i = 0; i < surfaces.names.size(); ++i) {
    if (!is_asked(i, from)) continue;
    list.push_back({{"name", surfaces.names[i]},
                    {"area", factors.areas[i]},
                    {"row_sum", sums[i].value},
                    {"error_bound", sums[i].error_bound}});
    closure = std::max(closure, std::fabs(sums[i].value - 1));
    closure_bound = std::max(closure_bound, sums[i].error_bound);
  }
  const auto proven = std::ranges::count_if(factors.factors, &ViewFactor::is_proven);
  return {{"schema", "gnomon/view_factors/1"},
          {"scene", facts(scene).source},
          {"length_unit", facts(scene).length_unit},
          {"bound", bound},
          {"largest_error_bound", largest_bound(factors)},
          {"surfaces", std::move(list)},
          {"closure_residual", closure},
          {"closure_bound", closure_bound},
          {"reciprocity_residual", factors.reciprocity_residual},
          {"factors", {{"proven", proven}, {"estimated", factors.factors.size() - static_cast<std::size_t>(proven)}}},
          {"pairs", {{"unhidden", factors.unhidden_pairs}, {"divided", factors.divided_pairs}}},
          {"evaluations", factors.evaluations}};
}

std::string factors_summary(const ViewFactors& factors, const std::optional<std::uint32_t>& from, double bound) {
  double least = HUGE_VAL, most = 0;
  const std::vector<RowSum> sums = row_sums(factors);
  for (std::uint32_t i = 0; i < sums.size(); ++i) {
    if (!is_asked(i, from)) continue;
    least = std::min(least, sums[i].value);
    most = std::max(most, sums[i].value);
  }
  const auto proven = static_cast<std::size_t>(std::ranges::count_if(factors.factors, &ViewFactor::is_proven));
  const double largest = largest_bound(factors);
  std::vector<TextRow> rows = {
      {"factors", std::to_string(factors.factors.size()) + " that are not 0; " + std::to_string(proven) +
                      " with a proven bound, " + std::to_string(factors.factors.size() - proven) + " with an estimate"},
      {"largest bound",
       rounded_text(largest) + (largest > bound ? ", more than the " + rounded_text(bound) + " asked for" : "")},
      {"row sums", rounded_text(least) + " to " + rounded_text(most)}};
  if (sums.empty()) rows.pop_back();
  return aligned(rows, 0);
}

std::filesystem::path bound_file(const std::filesystem::path& file) {
  std::filesystem::path other = file;
  other.replace_filename(file.stem().string() + "_bound" + file.extension().string());
  return other;
}

void write_npy(const std::filesystem::path& file, const ViewFactors& factors) {
  write_matrix(file, factors, &ViewFactor::value);
  write_matrix(bound_file(file), factors, &ViewFactor::error_bound);
}

}  // namespace gnomon
