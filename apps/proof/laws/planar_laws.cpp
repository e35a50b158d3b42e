#include "apps/proof/laws/law_lists.h"

#include <algorithm>
#include <array>

#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/planar_cases.h"
#include "apps/proof/laws/planar_definition.h"

namespace gnomon::laws {
namespace {

using planar::ConvexPiece;
using planar::PlanarRegion;
using planar::ShadowRegions;

Rational fraction(const PlanarCase& drawn, const ExactVector& p) {
  return visible_fraction(drawn.light, drawn.blocker, p);
}

bool is_partial(const Rational& f) {
  return f != 0 && f != 1;
}

Region region_with(const Rational& f) {
  return f == 1 ? Region::lit : f == 0 ? Region::umbra : Region::penumbra;
}

/// A pair in exact coordinates.
struct Figure {
  std::vector<ExactVector> light;
  std::vector<ExactVector> blocker;

  explicit Figure(const PlanarCase& drawn) {
    for (const Point2& p : drawn.light) light.push_back(exact(p));
    for (const Point2& p : drawn.blocker) blocker.push_back(exact(p));
  }

  bool has_point_light() const { return light.size() == 1; }
  int side_of_blocker(const ExactVector& p) const { return side_of(blocker[0], blocker[1], p); }
  int side_of_light(const ExactVector& p) const { return side_of(light.front(), light.back(), p); }
  ExactVector blocker_middle() const { return Rational(1, 2) * (blocker[0] + blocker[1]); }

  /// The light's strict side of the blocker's line, 0 if it has none.
  int light_side() const {
    const int side = side_of_blocker(light.front());
    return side == side_of_blocker(light.back()) ? side : 0;
  }
  bool is_standard() const { return light_side() != 0; }
  bool is_behind(const ExactVector& p) const { return side_of_blocker(p) == -light_side(); }
  bool on_one_line() const { return side_of_blocker(light.front()) == 0 && side_of_blocker(light.back()) == 0; }
  bool blocker_line_hits() const { return !is_standard() && !on_one_line(); }
  bool end_on_light_line(std::size_t i) const { return has_point_light() || side_of_light(blocker[i]) == 0; }
};

/// A named extremal line with its papers' sides: the positive one is that without the blocker's other end. For a
/// separating line that is the light's.
struct NamedLine {
  ExactVector from;
  ExactVector to;
  int blocker_side = 0;
  bool holds_light = false;

  NamedLine(const Figure& figure, const planar::ExtremalLine& name)
      : from(figure.blocker.at(number(name.blocker_end))), to(figure.light.at(number(name.light_end))) {
    blocker_side = side_of(from, to, figure.blocker[1 - number(name.blocker_end)]);
    holds_light = figure.end_on_light_line(number(name.blocker_end));
  }

  /// +1 on the positive side, 0 on the line, -1 on the negative side.
  int side(const ExactVector& p) const { return -blocker_side * side_of(from, to, p); }
};

/// The four extremal lines in the order promised: minimum and maximum at the blocker's ends 0 and 1.
struct ExtremalFigure {
  std::vector<NamedLine> min;
  std::vector<NamedLine> max;
};

ExtremalFigure extremal_figure(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  ExtremalFigure result;
  for (const planar::ExtremalLine& line : subject.planar_extremal_lines(drawn.pair())) {
    (line.contact == Contact::separating ? result.min : result.max).emplace_back(figure, line);
  }
  return result;
}

/// True if all sides of a piece have p on their left, or, for `least` 0, on their lines.
bool holds(const ConvexPiece& piece, const ExactVector& p, int least) {
  return std::ranges::all_of(piece.sides,
                             [&](const auto& side) { return side_of(exact(side.from), exact(side.to), p) >= least; });
}

bool holds(const PlanarRegion& region, const ExactVector& p, int least) {
  return std::ranges::any_of(region.pieces, [&](const ConvexPiece& piece) { return holds(piece, p, least); });
}

/// A region against the definition: of two points with `inside` one is nowhere outside, one without nowhere inside.
bool agrees(const PlanarRegion& region, const ExactVector& p, bool inside) {
  return inside ? holds(region, p, 0) : !holds(region, p, 1);
}

/// What every law asks of the case's point.
Verdict check_point(const PlanarCase& drawn, const Subject& subject) {
  const ExactVector p = exact(drawn.point);
  const Rational f = fraction(drawn, p);
  return verdict(subject.planar_region_of(drawn.pair(), drawn.point) == region_with(f), "the point's region differs");
}

/// The first failure, if any.
Verdict all_of(std::initializer_list<Verdict> verdicts) {
  const auto fails = [](const Verdict& one) { return one.kind != Verdict::Kind::holds; };
  const auto* first = std::ranges::find_if(verdicts, fails);
  return first == verdicts.end() ? Verdict{} : *first;
}

Verdict check_lit(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  if (!figure.is_standard()) return premise_fails();
  const ExtremalFigure lines = extremal_figure(drawn, subject);
  const ExactVector p = exact(drawn.point);
  const bool beyond_min = std::ranges::any_of(
      lines.min, [&](const NamedLine& line) { return line.side(p) > 0 || (line.side(p) == 0 && !line.holds_light); });
  const bool separated = std::ranges::all_of(lines.min, [&](const NamedLine& line) {
    return std::ranges::all_of(figure.light, [&](const ExactVector& l) { return line.side(l) >= 0; });
  });
  const bool lit = fraction(drawn, p) == 1;
  return all_of({verdict(separated && lines.min.size() == 2, "a line does not separate light and blocker"),
                 verdict(lit == (!figure.is_behind(p) || beyond_min), "f = 1 elsewhere"), check_point(drawn, subject)});
}

Verdict check_shadow(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  if (!figure.is_standard()) return premise_fails();
  const ExtremalFigure lines = extremal_figure(drawn, subject);
  const ExactVector p = exact(drawn.point);
  const auto below = [&](const NamedLine& line) { return line.side(p) < 0 || (line.side(p) == 0 && line.holds_light); };
  const bool hidden = fraction(drawn, p) < 1;
  const ShadowRegions regions = subject.planar_regions(drawn.pair());
  return all_of({verdict(hidden == (figure.is_behind(p) && std::ranges::all_of(lines.min, below)), "f < 1 elsewhere"),
                 verdict(agrees(regions.occlusion, p, hidden), "the occlusion differs"),
                 verdict(agrees(regions.lit, p, !hidden), "the lit region differs")});
}

Verdict check_penumbra(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  if (!figure.is_standard()) return premise_fails();
  const ExtremalFigure lines = extremal_figure(drawn, subject);
  const ExactVector p = exact(drawn.point);
  const auto in_shadow = [&](int most) {
    return figure.is_behind(p) &&
           std::ranges::all_of(lines.min, [&](const auto& line) { return line.side(p) <= most; });
  };
  const bool beyond_max = std::ranges::any_of(lines.max, [&](const NamedLine& line) { return line.side(p) > 0; });
  const bool partial = is_partial(fraction(drawn, p));
  const bool agree = partial ? in_shadow(0) && beyond_max : !(in_shadow(-1) && beyond_max);
  return all_of({verdict(agree, "0 < f < 1 elsewhere"),
                 verdict(agrees(subject.planar_regions(drawn.pair()).penumbra, p, partial), "the penumbra differs")});
}

Verdict check_umbra(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  if (!figure.is_standard()) return premise_fails();
  const ExtremalFigure lines = extremal_figure(drawn, subject);
  const ExactVector p = exact(drawn.point);
  const auto below = [&](const NamedLine& line) { return line.side(p) <= 0; };
  const bool on_one_side = std::ranges::all_of(lines.max, [&](const NamedLine& line) {
    return std::ranges::all_of(figure.light, [&](const ExactVector& l) { return line.side(l) <= 0; });
  });
  const bool dark = fraction(drawn, p) == 0;
  const PlanarRegion umbra = subject.planar_regions(drawn.pair()).umbra;
  const bool held = figure.side_of_blocker(p) != 0 && holds(umbra, p, 0);
  return all_of({verdict(on_one_side && lines.max.size() == 2, "a line does not support light and blocker"),
                 verdict(dark == (figure.is_behind(p) && std::ranges::all_of(lines.max, below)), "f = 0 elsewhere"),
                 verdict(dark == held, "the umbra differs")});
}

/// The point, mirrored at the blocker's middle if it is not behind the blocker, and pulled toward this middle until
/// f = 0 there.
ExactVector pulled_into_umbra(const PlanarCase& drawn, const ExactVector& p) {
  const Figure figure(drawn);
  const ExactVector middle = figure.blocker_middle();
  ExactVector step = p - middle;
  if (!figure.is_behind(p)) step = Rational(-1) * step;
  while (fraction(drawn, middle + step) > 0) step = Rational(1, 2) * step;
  return middle + step;
}

Verdict check_one_umbra(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  const ExactVector p = exact(drawn.point);
  const ExactVector q = exact(drawn.other);
  if (!figure.is_standard() || figure.side_of_blocker(p) == 0 || figure.side_of_blocker(q) == 0) return premise_fails();
  const ExactVector dark_p = pulled_into_umbra(drawn, p);
  const ExactVector dark_q = pulled_into_umbra(drawn, q);
  return all_of({verdict(fraction(drawn, Rational(1, 2) * (dark_p + dark_q)) == 0, "f > 0 between two umbra points"),
                 verdict(subject.planar_regions(drawn.pair()).umbra.components <= 1, "more than one umbra")});
}

/// A point behind a blocker's end on a line through the inside of the light; which one, the point given says.
ExactVector penumbra_point(const Figure& figure, std::size_t end, const ExactVector& chosen) {
  const ExactVector& b = figure.blocker[end];
  const Rational u = 1 + CGAL::abs(Rational(chosen.x - b.x));
  const Rational v = 1 + CGAL::abs(Rational(chosen.y - b.y));
  const ExactVector l = Rational(u / (u + v)) * figure.light.front() + Rational(v / (u + v)) * figure.light.back();
  return b + v * (b - l);
}

/// At most two penumbra regions, because the points behind one end of the blocker make up one.
Verdict check_two_penumbrae(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  if (!figure.is_standard() || figure.has_point_light()) return premise_fails();
  for (const std::size_t end : {0U, 1U}) {
    if (figure.end_on_light_line(end)) continue;
    const ExactVector p = penumbra_point(figure, end, exact(drawn.point));
    const ExactVector q = penumbra_point(figure, end, exact(drawn.other));
    for (const ExactVector& one : {p, q, Rational(1, 2) * (p + q)}) {
      if (!is_partial(fraction(drawn, one))) return verdict(false, "a point behind an end is in no penumbra");
    }
  }
  return verdict(subject.planar_regions(drawn.pair()).penumbra.components <= 2, "more than two penumbrae");
}

/// The point where two lines meet, or nothing if they are parallel.
std::optional<ExactVector> meeting_point(const NamedLine& first, const NamedLine& second) {
  const ExactVector d = first.to - first.from;
  const ExactVector e = second.to - second.from;
  const Rational parallel = cross(d, e).z;
  if (parallel == 0) return std::nullopt;
  return first.from + Rational(cross(second.from - first.from, e).z / parallel) * d;
}

/// The umbra ends at the meeting point of the supporting lines, and the penumbra goes on around it.
bool ends_at(const PlanarCase& drawn, const ExactVector& tip) {
  const ExactVector onward = tip - Figure(drawn).blocker_middle();
  return fraction(drawn, tip) == 0 && is_partial(fraction(drawn, tip + Rational(1, 1000000) * onward)) &&
         is_partial(fraction(drawn, tip + Rational(1000000) * onward));
}

/// Far behind the blocker, between the supporting lines, f is still 0.
bool never_ends(const PlanarCase& drawn, const ExtremalFigure& lines) {
  const ExactVector onward = (lines.max[0].from - lines.max[0].to) + (lines.max[1].from - lines.max[1].to);
  const auto dark = [&](int exponent) {
    Rational step = 1;
    for (int i = 0; i < exponent; ++i) step *= 2;
    return fraction(drawn, Figure(drawn).blocker_middle() + step * onward) == 0;
  };
  return dark(0) && dark(20) && dark(200);
}

Verdict check_exactly_one_umbra(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  if (!figure.is_standard()) return premise_fails();
  const ExtremalFigure lines = extremal_figure(drawn, subject);
  const std::optional<ExactVector> tip = meeting_point(lines.max[0], lines.max[1]);
  const bool bounded = tip && figure.is_behind(*tip);
  const ShadowRegions regions = subject.planar_regions(drawn.pair());
  std::uint32_t penumbrae = figure.has_point_light() ? 0 : 1;
  if (!bounded && !figure.has_point_light()) {
    penumbrae = static_cast<std::uint32_t>(!figure.end_on_light_line(0)) + !figure.end_on_light_line(1);
  }
  return all_of({verdict(bounded ? ends_at(drawn, *tip) : never_ends(drawn, lines), "f says otherwise"),
                 verdict(regions.umbra.components == 1 && regions.umbra.pieces.size() == 1, "not one umbra"),
                 verdict(regions.umbra.bounded() == bounded, bounded ? "said to be unbounded" : "said to be bounded"),
                 verdict(regions.penumbra.components == penumbrae, "another number of penumbrae")});
}

Verdict check_standard(const PlanarCase& drawn, const Subject& subject) {
  return all_of({check_lit(drawn, subject), check_shadow(drawn, subject), check_penumbra(drawn, subject),
                 check_umbra(drawn, subject), check_exactly_one_umbra(drawn, subject)});
}

Verdict check_light_line_hits(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  const bool hits = figure.side_of_light(figure.blocker[0]) * figure.side_of_light(figure.blocker[1]) <= 0;
  if (figure.has_point_light() || !hits) return premise_fails();
  return check_standard(drawn, subject);
}

/// The point against all regions; what is on the blocker's line has f = 1 and counts for none.
Verdict check_regions(const PlanarCase& drawn, const Subject& subject, const ShadowRegions& regions) {
  const ExactVector p = exact(drawn.point);
  const Rational f = fraction(drawn, p);
  if (Figure(drawn).side_of_blocker(p) == 0) return check_point(drawn, subject);
  return all_of({verdict(agrees(regions.lit, p, f == 1), "the lit region differs"),
                 verdict(agrees(regions.penumbra, p, is_partial(f)), "the penumbra differs"),
                 verdict(agrees(regions.umbra, p, f == 0), "the umbra differs"),
                 verdict(agrees(regions.occlusion, p, f < 1), "the occlusion differs"), check_point(drawn, subject)});
}

/// The visible fractions beside the blocker's middle on both sides, in order.
struct Fractions {
  Rational least;
  Rational most;
};

Fractions fractions_beside_blocker(const PlanarCase& drawn, int halvings) {
  const Figure figure(drawn);
  const ExactVector edge = figure.blocker[1] - figure.blocker[0];
  ExactVector step{Rational(-edge.y), edge.x, 0};
  for (int i = 0; i < halvings; ++i) step = Rational(1, 2) * step;
  const Rational left = fraction(drawn, figure.blocker_middle() + step);
  const Rational right = fraction(drawn, figure.blocker_middle() - step);
  return {std::min(left, right), std::max(left, right)};
}

/// True if a claim holds beside the blocker, at the latest so close to it that no difference of doubles matters.
bool beside_blocker(const PlanarCase& drawn, bool (*claim)(const Fractions&)) {
  return std::ranges::any_of(std::array{20, 400, 3000},
                             [&](int halvings) { return claim(fractions_beside_blocker(drawn, halvings)); });
}

bool has_counts(const ShadowRegions& regions, std::uint32_t umbrae, std::uint32_t penumbrae) {
  return regions.umbra.components == umbrae && regions.umbra.empty() == (umbrae == 0) &&
         regions.penumbra.components == penumbrae && regions.penumbra.empty() == (penumbrae == 0);
}

/// The blocker's line meets the inside of the light.
Verdict check_crossed_light(const PlanarCase& drawn, const ShadowRegions& regions) {
  const auto partial_twice = [](const Fractions& f) { return is_partial(f.least) && is_partial(f.most); };
  return all_of({verdict(fraction(drawn, exact(drawn.point)) > 0, "f = 0 somewhere"),
                 verdict(beside_blocker(drawn, partial_twice), "no penumbra on a side"),
                 verdict(has_counts(regions, 0, 2), "another number of regions")});
}

/// The light touches the blocker's line with the end `touching`.
Verdict check_touching_light(const PlanarCase& drawn, const ShadowRegions& regions, const ExactVector& touching) {
  const Figure figure(drawn);
  const Rational to_ends = dot(figure.blocker[0] - touching, figure.blocker[1] - touching);
  const auto partial = [](const Fractions& f) { return is_partial(f.least) && f.most == 1; };
  const auto dark = [](const Fractions& f) { return f.least == 0 && f.most == 1; };
  if (to_ends > 0) {
    return all_of({verdict(fraction(drawn, exact(drawn.point)) > 0, "f = 0 somewhere"),
                   verdict(beside_blocker(drawn, partial), "no penumbra behind the blocker"),
                   verdict(has_counts(regions, 0, 1), "another number of regions")});
  }
  return all_of({verdict(beside_blocker(drawn, dark), "no umbra behind the blocker"),
                 verdict(has_counts(regions, 1, to_ends < 0 ? 2 : 1), "another number of regions")});
}

Verdict check_blocker_line_hits(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  if (!figure.blocker_line_hits()) return premise_fails();
  const ShadowRegions regions = subject.planar_regions(drawn.pair());
  const bool front_touches = figure.side_of_blocker(figure.light.front()) == 0;
  const bool back_touches = figure.side_of_blocker(figure.light.back()) == 0;
  const Verdict counts = front_touches || back_touches
                             ? check_touching_light(drawn, regions, figure.light[front_touches ? 0 : 1])
                             : check_crossed_light(drawn, regions);
  return all_of({counts, check_regions(drawn, subject, regions)});
}

Verdict check_one_line(const PlanarCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  if (!figure.on_one_line()) return premise_fails();
  const ExactVector p = exact(drawn.point);
  const ShadowRegions regions = subject.planar_regions(drawn.pair());
  const bool lit_off_the_line = figure.side_of_blocker(p) == 0 || fraction(drawn, p) == 1;
  return all_of({verdict(lit_off_the_line, "f < 1 off the line"),
                 verdict(has_counts(regions, 0, 0) && regions.lines.empty(), "regions off the line"),
                 verdict(holds(regions.lit, p, 0), "the lit region is not the plane"), check_point(drawn, subject)});
}

/// The generator of laws about pairs that stand so.
auto pairs(Stand stand) {
  return [stand](Domain domain) { return planar_cases(domain, stand); };
}

}  // namespace

std::vector<Law> planar_laws() {
  return {
      law({"P1", "[P93] 4.2.2.1",
           "f = 1 exactly in B+, Min1+ and Min2+, boundaries included, but for a line that holds the whole light."},
          pairs(Stand::apart), check_lit),
      law({"P2", "[P93] 4.2.2.1", "f < 1 exactly in the intersection of B-, Min1- and Min2-, up to its boundary."},
          pairs(Stand::apart), check_shadow),
      law({"P3", "[P93] 4.2.2.1", "0 < f < 1 exactly in the part of the shadow in Max1+ or Max2+, up to its boundary."},
          pairs(Stand::apart), check_penumbra),
      law({"P4", "[P93] 4.2.2.1",
           "f = 0 exactly in the intersection of B-, Max1- and Max2-, boundaries included but for the blocker's line."},
          pairs(Stand::apart), check_umbra),
      law({"P5", "[P93] 4.2.2.1", "There is at most one umbra region; it is convex."}, pairs(Stand::apart),
          check_one_umbra),
      law({"P6", "[P93] 4.2.2.1", "There are at most two penumbra regions."}, pairs(Stand::apart), check_two_penumbrae),
      law({"P7", "own",
           "There is exactly one umbra, bounded if and only if the supporting lines meet behind the blocker; then "
           "there is one penumbra, otherwise as many as ends of the blocker off the light's line."},
          pairs(Stand::apart), check_exactly_one_umbra),
      law({"P8", "own",
           "If the blocker's line meets the inside of the light there is no umbra, and penumbra on both its sides. "
           "If it meets one end, inside the blocker: one umbra, two penumbrae; at its end: one, one; off it: none, "
           "one."},
          pairs(Stand::blocker_line_hits), check_blocker_line_hits),
      law({"P9", "own", "If the light's line meets the blocker, P1 to P7 hold as they stand."},
          pairs(Stand::light_line_hits), check_light_line_hits),
      law({"P10", "own", "If light and blocker lie on one line, every point off it is lit."}, pairs(Stand::on_one_line),
          check_one_line),
  };
}

}  // namespace gnomon::laws
