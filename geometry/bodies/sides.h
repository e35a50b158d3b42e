#pragma once

namespace gnomon {

/// On which sides of a plane points lie.
struct Sides {
  bool positive = false;
  bool zero = false;
  bool negative = false;

  void add(int sign) {
    positive = positive || sign > 0;
    zero = zero || sign == 0;
    negative = negative || sign < 0;
  }
  bool cross() const { return positive && negative; }
  bool all_zero() const { return !positive && !negative; }
  bool all_positive() const { return positive && !zero && !negative; }
  bool strictly_on_one_side() const { return !zero && positive != negative; }
};

/// The sides of some points, whose signs `side_of` tells. Once points lie on both sides, no more is asked.
template <class Points, class SideOf>
Sides sides(const Points& points, const SideOf& side_of) {
  Sides result;
  for (const auto& p : points) {
    result.add(side_of(p));
    if (result.cross()) break;
  }
  return result;
}

}  // namespace gnomon
