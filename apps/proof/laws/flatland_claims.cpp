#include "apps/proof/laws/law_lists.h"

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/flatland_cases.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/planar_definition.h"

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

/// A light that crosses the blocker in the middle of both, and a point beside the blocker.
rc::Gen<FlatlandCase> crossed_lights(Domain) {
  return rc::gen::exec([] {
    const double half = draw(1, 4), wide = draw(1, 4);
    const double x = draw(-6, 6), y = draw(-6, 6);
    return moved({{{0, -half}, {0, half}}, {{{{-wide, 0}, {wide, 0}}}}, {x * wide / 4, y * half / 4}});
  });
}

Rational fraction(const FlatlandCase& drawn, std::span<const BlockerSegment> blockers) {
  return visible_fraction(drawn.light, blockers, exact(drawn.point));
}

/// The claim is false of the case, or true; unless the subject errs about the point.
Verdict judged(const FlatlandCase& drawn, const Subject& subject, bool refuted, std::string_view reason) {
  const Rational f = fraction(drawn, drawn.blockers);
  const Region region = f == 1 ? Region::lit : f == 0 ? Region::umbra : Region::penumbra;
  if (subject.planar_visible_light(drawn.flatland(), drawn.point).region != region) {
    return verdict(false, "the point's region differs");
  }
  return refuted ? refutes(reason) : Verdict{};
}

/// The claim that a point in the umbra of one half of the light is in that of the whole.
Verdict check_halves(const FlatlandCase& drawn, const Subject& subject) {
  const Point2 middle{(drawn.light[0].x + drawn.light[1].x) / 2, (drawn.light[0].y + drawn.light[1].y) / 2};
  const auto is_hidden = [&](const Point2& end) {
    return visible_fraction(std::array{end, middle}, drawn.blockers, exact(drawn.point)) == 0;
  };
  if (!is_hidden(drawn.light[0]) && !is_hidden(drawn.light[1])) return premise_fails();
  return judged(drawn, subject, fraction(drawn, drawn.blockers) > 0, "one half of the light is hidden, not the other");
}

/// Two halves of a segment, or a folded pair, and a point that may be in the penumbra of both.
rc::Gen<FlatlandCase> joined_pairs(Domain) {
  return rc::gen::exec([] {
    const double wide = draw(1, 4), height = draw(1, 4), more = draw(1, 4);
    const double half_light = wide + more;
    if (once_in(2)) {
      // The lines that hold light and blocker on one side meet at the depth height * wide / more.
      const double depth = std::ceil(height * wide / more) + draw(-1, 5);
      return moved({{{-half_light, height}, {half_light, height}},
                    {{{{-wide, 0}, {0, 0}}}, {{{0, 0}, {wide, 0}}}},
                    {0, -depth}});
    }
    // Both blockers leave the joint to the right of every line from the light.
    const double drop = draw(1, 4);
    return moved({{{-1, height}, {1, height}}, {{{{0, 0}, {8, 0}}}, {{{0, 0}, {8, -drop}}}}, {0, -drop - draw(0, 3)}});
  });
}

/// The claim that a point in the penumbra of both is in the umbra of both together.
Verdict check_common_penumbra(const FlatlandCase& drawn, const Subject& subject) {
  for (const BlockerSegment& blocker : drawn.blockers) {
    const Rational alone = fraction(drawn, std::span(&blocker, 1));
    if (alone == 0 || alone == 1) return premise_fails();
  }
  return judged(drawn, subject, fraction(drawn, drawn.blockers) > 0, "light reaches the common penumbra");
}

/// Three blockers at any depth, each hiding a third of the light from the point or from one beside it.
rc::Gen<FlatlandCase> three_thirds(Domain) {
  return rc::gen::exec([] {
    FlatlandCase figure{{{-12, 16}, {12, 16}}, {}, {0, 0}};
    for (const double start : {-12.0, -4.0, 4.0}) {
      const double depth = 1.0 / (1 << draw(1, 4));
      figure.blockers.push_back({Point2{start * depth, 16 * depth}, Point2{(start + 8) * depth, 16 * depth}});
    }
    if (once_in(4)) figure.point.x = draw(-1, 1);
    return moved(std::move(figure));
  });
}

/// The claim that a point in the umbra of all is in the umbra of two of them.
Verdict check_pairs_suffice(const FlatlandCase& drawn, const Subject& subject) {
  if (fraction(drawn, drawn.blockers) != 0) return premise_fails();
  bool two_suffice = false;
  for (std::size_t i = 0; i < 3; ++i) {
    two_suffice |= fraction(drawn, std::array{drawn.blockers[i], drawn.blockers[(i + 1) % 3]}) == 0;
  }
  return judged(drawn, subject, !two_suffice, "no two of the blockers hide the light, all three do");
}

}  // namespace

std::vector<Law> flatland_claims() {
  const FlatlandCase crossed{{{0, -1}, {0, 1}}, {{{{-1, 0}, {1, 0}}}}, {0.5, -0.25}};
  const FlatlandCase halves{{{-2, 1}, {2, 1}}, {{{{-1, 0}, {0, 0}}}, {{{0, 0}, {1, 0}}}}, {0, -3}};
  const FlatlandCase folded{{{-1, 1}, {1, 1}}, {{{{0, 0}, {8, 0}}}, {{{0, 0}, {8, -1}}}}, {0, -2}};
  const FlatlandCase thirds{
      {{-12, 16}, {12, 16}}, {{{{-6, 8}, {-2, 8}}}, {{{-1, 4}, {1, 4}}}, {{{2, 8}, {6, 8}}}}, {0, 0}};
  return {
      refuted_claim<FlatlandCase>(
          {"F3", "[P93] 4.2.2.1",
           "A light that the blocker crosses may be split at the crossing: what lies in the umbra of one half lies in "
           "umbra."},
          {crossed}, crossed_lights, check_halves),
      refuted_claim<FlatlandCase>(
          {"F4", "[P93] 4.2.2.2",
           "Where two blockers are joined, their whole common penumbra is umbra of both together."},
          {halves, folded}, joined_pairs, check_common_penumbra),
      refuted_claim<FlatlandCase>(
          {"F5", "[P93] 4.2.3.2", "Pairs of blockers suffice: what lies in the umbra of all lies in the umbra of two."},
          {thirds}, three_thirds, check_pairs_suffice),
  };
}

}  // namespace gnomon::laws
