#include "apps/laws/flatland_claims.h"

#include <array>
#include <cmath>

#include "apps/laws/draw.h"
#include "apps/laws/flatland_cases.h"
#include "apps/laws/law_entry.h"
#include "apps/laws/planar_definition.h"

namespace gnomon::laws {
namespace {

using planar::BlockerSegment;

/// A figure moved by a random map; affine maps change no visible fraction.
FlatlandCase moved(FlatlandCase figure) {
  const double a = draw(-3, 3), b = draw(-3, 3), c = draw(-3, 3), d = draw(-3, 3);
  const bool regular = a * d != b * c;
  const double x = draw(-9, 9), y = draw(-9, 9);
  const auto map = [&](Point2& p) {
    p = regular ? Point2{x + a * p.x + b * p.y, y + c * p.x + d * p.y} : Point2{x + p.x, y + p.y};
  };
  for (Point2& p : figure.light) map(p);
  for (BlockerSegment& blocker : figure.blockers) map(blocker[0]), map(blocker[1]);
  map(figure.point);
  return figure;
}

/// A light that crosses the blocker in the middle of both, and a point beside them.
rc::Gen<FlatlandCase> crossed_lights(Domain) {
  return rc::gen::exec([] {
    const double half = draw(1, 4), wide = draw(1, 4);
    return moved({{{0, -half}, {0, half}}, {{{{-wide, 0}, {wide, 0}}}}, {double(draw(-12, 12)), double(draw(1, 12))}});
  });
}

Rational fraction(const FlatlandCase& drawn, const ExactVector& p) {
  return visible_fraction(drawn.light, drawn.blockers, p);
}

Verdict subject_agrees(const FlatlandCase& drawn, const Subject& subject) {
  const Rational f = fraction(drawn, exact(drawn.point));
  const Region region = f == 1 ? Region::lit : f == 0 ? Region::umbra : Region::penumbra;
  return verdict(subject.planar_visible_light(drawn.flatland(), drawn.point).region == region,
                 "the point's region differs");
}

/// Beside the crossing, the half light beyond the blocker is hidden and the other half is seen.
Verdict check_halves(const FlatlandCase& drawn, const Subject& subject) {
  const ExactVector a = exact(drawn.light[0]), b = exact(drawn.light[1]);
  const ExactVector middle = Rational(1, 2) * (a + b);
  const ExactVector along = exact(drawn.blockers[0][1]) - exact(drawn.blockers[0][0]);
  const ExactVector p = middle + Rational(1, 1000) * along + Rational(1, 1000000) * (b - a);
  const Point2 centre{(drawn.light[0].x + drawn.light[1].x) / 2, (drawn.light[0].y + drawn.light[1].y) / 2};
  const std::array lower{drawn.light[0], centre};
  const bool half_is_hidden = visible_fraction(lower, drawn.blockers, p) == 0;
  if (!half_is_hidden) return verdict(false, "the half light has no umbra beside the crossing");
  const ExactVector q = exact(drawn.point);
  const bool whole_has_none = fraction(drawn, p) > 0 && fraction(drawn, q) > 0;
  return whole_has_none ? subject_agrees(drawn, subject) : verdict(false, "f = 0 somewhere");
}

/// Two halves of a segment, or a folded pair, and a point in the penumbra of both that light reaches.
rc::Gen<FlatlandCase> joined_pairs(Domain) {
  return rc::gen::exec([] {
    const double wide = draw(1, 4), height = draw(1, 4), more = draw(1, 4);
    const double half_light = wide + more;
    if (once_in(2)) {
      // The lines that hold light and blocker on one side meet at the depth height * wide / more.
      const double depth = std::ceil(height * wide / more) + draw(1, 5);
      return moved({{{-half_light, height}, {half_light, height}},
                    {{{{-wide, 0}, {0, 0}}}, {{{0, 0}, {wide, 0}}}},
                    {0, -depth}});
    }
    // Both blockers leave the joint to the right of every line from the light.
    const double drop = draw(1, 4);
    return moved({{{-1, height}, {1, height}}, {{{{0, 0}, {8, 0}}}, {{{0, 0}, {8, -drop}}}}, {0, -drop - draw(0, 3)}});
  });
}

Verdict check_common_penumbra(const FlatlandCase& drawn, const Subject& subject) {
  const ExactVector p = exact(drawn.point);
  for (const BlockerSegment& blocker : drawn.blockers) {
    const Rational alone = visible_fraction(drawn.light, blocker, p);
    if (alone == 0 || alone == 1) return premise_fails();
  }
  return fraction(drawn, p) > 0 ? subject_agrees(drawn, subject) : verdict(false, "f = 0 in the common penumbra");
}

/// Three blockers at any depth that hide a third of the light each from the point.
rc::Gen<FlatlandCase> three_thirds(Domain) {
  return rc::gen::exec([] {
    FlatlandCase figure{{{-12, 16}, {12, 16}}, {}, {0, 0}};
    for (const double start : {-12.0, -4.0, 4.0}) {
      const double depth = 1.0 / (1 << draw(1, 4));
      figure.blockers.push_back({Point2{start * depth, 16 * depth}, Point2{(start + 8) * depth, 16 * depth}});
    }
    return moved(std::move(figure));
  });
}

Verdict check_pairs_do_not_suffice(const FlatlandCase& drawn, const Subject& subject) {
  const ExactVector p = exact(drawn.point);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array pair{drawn.blockers[i], drawn.blockers[(i + 1) % 3]};
    const bool thirds = visible_fraction(drawn.light, drawn.blockers[i], p) == Rational(2, 3) &&
                        visible_fraction(drawn.light, pair, p) == Rational(1, 3);
    if (!thirds) return verdict(false, "not a third each");
  }
  return fraction(drawn, p) == 0 ? subject_agrees(drawn, subject) : verdict(false, "f > 0 behind all three");
}

}  // namespace

std::vector<Law> flatland_claims() {
  return {
      law({"F3", "[P93] 4.2.2.1, refuted",
           "Shadows of the halves of a crossed light must not be united: each half has an umbra, the whole has none."},
          crossed_lights, check_halves),
      law({"F4", "[P93] 4.2.2.2, refuted",
           "The common penumbra of two joined blockers is not all umbra: light reaches it far away, and beside a "
           "fold."},
          joined_pairs, check_common_penumbra),
      law({"F5", "[P93] 4.2.3.2, refuted",
           "Pairs of blockers do not suffice: three that hide a third each leave a third in pairs, and nothing "
           "together."},
          three_thirds, check_pairs_do_not_suffice),
  };
}

}  // namespace gnomon::laws
