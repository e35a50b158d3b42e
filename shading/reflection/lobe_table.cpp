#include "shading/reflection/lobe_table.h"

#include <map>
#include <mutex>

namespace gnomon::shading {
namespace {

/// D(s) by the recurrence.
Precise moment_to(const Precise& s, int n) {
  const Precise cosine = sqrt(Precise(1.0) - s * s);
  return arc_moment(ArcAxis<Precise>{1.0, cosine, 0.0, s, 1.0, atan2(s, cosine)}, n);
}

/// Coefficients of (1 - t²)^p in powers of t - c, from (1 - t²) f' = -2 p t f.
std::vector<Precise> power_series(const Precise& c, int n, std::size_t count) {
  const Precise rest = Precise(1.0) - c * c, twice_p = double(n - 1);
  std::vector<Precise> f = {power(sqrt(rest), n - 1)};
  for (std::size_t k = 0; k + 1 < count; ++k) {
    const Precise j = double(k);
    Precise sum = (Precise(2.0) * j - twice_p) * c * f[k];
    if (k > 0) sum = sum + (Precise(double(k) - 1) - twice_p) * f[k - 1];
    f.push_back(sum / (Precise(double(k) + 1) * rest));
  }
  return f;
}

/// At least what Taylor's polynomial about c leaves out at distances up to h. On the circle of radius r, |1 - z²| is at
/// most 1 - c² + 2 c r + r², and D no more than its value in the middle and r times the largest slope.
double remainder(double c, double h, int n, std::size_t degree) {
  double best = HUGE_VAL;
  for (double r = 2 * h; r < 64 * h; r *= 1.2) {
    const double base = 1 - c * c + 2 * c * r + r * r, q = h / r;
    const double most = c + r * std::pow(base, (n - 1) / 2.0);
    best = std::fmin(best, most * std::pow(q, double(degree) + 1) / (1 - q));
  }
  return 1.01 * best;
}

}  // namespace

LobeTable::LobeTable(int exponent) : width_(8.6 / std::sqrt(exponent) / pieces) {
  const Precise::Bits protect(160);
  for (std::size_t k = 0; k < pieces; ++k) {
    const double middle_of_piece = (double(k) + 0.5) * width_, half = width_ / 2;
    const std::vector<Precise> slopes = power_series(middle_of_piece, exponent, degree);
    Piece& piece = table_[k];
    const auto set = [&](std::size_t j, const Precise& exact) {
      const Bounded rounded = bounded(exact);
      piece.coefficients[j] = rounded.value;
      piece.error += rounded.error + 40 * unit * std::fabs(rounded.value);
    };
    set(0, moment_to(middle_of_piece, exponent));
    Precise scale = half;
    for (std::size_t j = 1; j <= degree; ++j) {
      set(j, slopes[j - 1] * scale / Precise(double(j)));
      scale = scale * Precise(half);
    }
    piece.error = 1.01 * (piece.error + remainder(middle_of_piece, half, exponent, degree));
  }
  const Bounded all = bounded(moment_to(Precise(1.0), exponent));
  const double top = pieces * width_, rest = (1 - top) * std::pow(1 - top * top, (exponent - 1) / 2.0);
  whole_ = {all.value, all.error + 1.01 * rest};
}

Bounded LobeTable::at(const Bounded& sine) const {
  const double s = std::fabs(sine.value);
  const double place = s / width_;
  if (!(place < double(pieces))) return {std::copysign(whole_.value, sine.value), whole_.error + sine.error};
  const auto k = static_cast<std::size_t>(place);
  const Piece& piece = table_[k];
  // Off by less than 4 u of s, by which D changes no more.
  const double x = (s - (double(k) + 0.5) * width_) / (width_ / 2);
  double value = piece.coefficients[degree];
  for (std::size_t j = degree; j-- > 0;) value = value * x + piece.coefficients[j];
  return {std::copysign(value, sine.value), piece.error + sine.error + 8 * unit * s};
}

const LobeTable& LobeTable::of(int exponent) {
  static std::mutex mutex;
  static std::map<int, std::unique_ptr<const LobeTable>> tables;
  thread_local const LobeTable* last = nullptr;
  thread_local int last_exponent = 0;
  if (last && last_exponent == exponent) return *last;
  const std::lock_guard lock(mutex);
  std::unique_ptr<const LobeTable>& table = tables[exponent];
  if (!table) table = std::make_unique<const LobeTable>(exponent);
  last = table.get();
  last_exponent = exponent;
  return *last;
}

Bounded quick_moment(const ArcAxis<Bounded>& axis, int k) {
  if (k < LobeTable::least_exponent) return arc_moment(axis, k);
  const LobeTable& table = LobeTable::of(k);
  const Bounded length = sqrt(axis.square);
  const Bounded rise = table.at(axis.end_slope / length) - table.at(axis.start_slope / length);
  const Bounded size = power(axis.square, k / 2);
  return (k % 2 == 1 ? size * length : size) * rise;
}

}  // namespace gnomon::shading
