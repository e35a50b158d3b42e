#include "shading/reflection/paired_moments.h"

#include <span>

#include "shading/pair.h"

namespace gnomon::shading {
namespace {

/// Two numbers with bounds. Exact zeros come out as numbers that are off by next to nothing, which final_bound knows.
struct BoundedPair {
  Pair value{};
  Pair error{};

  BoundedPair() = default;
  BoundedPair(const Pair& v, const Pair& e) : value(v), error(e) {}
  BoundedPair(const Bounded& a, const Bounded& b) : value{a.value, b.value}, error{a.error, b.error} {}
};

/// At least what products lose where they underflow; sums of as many as there are do not come to what final_bound adds.
constexpr double lost = 0x1p-1000;

BoundedPair product(const BoundedPair& a, const BoundedPair& b) {
  const Pair value = a.value * b.value;
  return {value, magnitude(a.value) * b.error + (magnitude(b.value) + b.error) * a.error + unit * magnitude(value) +
                     Pair{lost, lost}};
}

BoundedPair sum(const BoundedPair& a, const BoundedPair& b) {
  const Pair value = a.value + b.value;
  return {value, a.error + b.error + unit * magnitude(value)};
}

/// ArcMoments of two arcs.
class PairedMoments {
 public:
  PairedMoments(const ArcAxis<Bounded>& a, const ArcAxis<Bounded>& b, int first)
      : start_square_(a.start * a.start, b.start * b.start),
        end_square_(a.end * a.end, b.end * b.end),
        square_(a.square, b.square),
        order_(first) {
    const bool is_even = first == 0;
    const auto value = [&](const ArcAxis<Bounded>& x) { return is_even ? x.angle : x.end_slope - x.start_slope; };
    value_ = {value(a), value(b)};
    start_ = {a.start_slope * (is_even ? a.start : a.start * a.start),
              b.start_slope * (is_even ? b.start : b.start * b.start)};
    end_ = {a.end_slope * (is_even ? a.end : a.end * a.end), b.end_slope * (is_even ? b.end : b.end * b.end)};
  }

  const BoundedPair& value() const { return value_; }

  /// As `folded`; what an error hangs on comes last, for the next step waits for it.
  void step() {
    order_ += 2;
    const double over = 1.0 / order_, share = (order_ - 1) * over;
    const BoundedPair rise = sum(end_, {-start_.value, start_.error});
    const Pair factor = share * square_.value, factor_off = share * square_.error;
    const Pair first = factor * value_.value, second = over * rise.value, value = first + second;
    const Pair rounded = unit * (4 * magnitude(first) + 2 * magnitude(second) + magnitude(value));
    const Pair other = factor_off * magnitude(value_.value) + over * rise.error + rounded + Pair{lost, lost};
    value_ = {value, (magnitude(factor) + factor_off) * value_.error + other};
    start_ = product(start_, start_square_);
    end_ = product(end_, end_square_);
  }

 private:
  BoundedPair start_square_, end_square_, square_;
  int order_;
  BoundedPair value_, start_, end_;
};

}  // namespace

ArcSums<Bounded> arc_sums(const std::vector<Arc<Bounded>>& arcs, const Vector3<Bounded>& w, int order) {
  std::vector<BoundedPair> sums(static_cast<std::size_t>((order + 1) / 2));
  ArcSums<Bounded> result;
  result.last.reserve(arcs.size() + 1);
  for (std::size_t i = 0; i < arcs.size(); i += 2) {
    const bool is_alone = i + 1 == arcs.size();
    const Arc<Bounded>&a = arcs[i], &b = arcs[is_alone ? i : i + 1];
    const BoundedPair heights(dot(w, a.axis), is_alone ? Bounded(0.0) : dot(w, b.axis));
    PairedMoments moments(arc_axis(a, w), arc_axis(b, w), (order + 1) % 2);
    for (BoundedPair& known : sums) {
      known = sum(known, product(heights, moments.value()));
      moments.step();
    }
    const auto& [value, error] = moments.value();
    for (std::size_t lane = 0; lane < (is_alone ? 1 : 2); ++lane) result.last.push_back({value[lane], error[lane]});
  }
  result.sums.reserve(sums.size());
  for (const auto& [value, error] : sums) {
    result.sums.push_back(Bounded(value[0], error[0]) + Bounded(value[1], error[1]));
  }
  return result;
}

}  // namespace gnomon::shading
