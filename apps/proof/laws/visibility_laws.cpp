#include "apps/proof/laws/law_lists.h"

#include <algorithm>

#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/visibility_cases.h"
#include "apps/proof/laws/visibility_definition.h"

namespace gnomon::laws {
namespace {

/// What the subject says of all blockers together, and the definition of each alone.
struct Regions {
  Region together;
  std::vector<Region> alone;

  auto count(Region region) const { return std::ranges::count(alone, region); }
};

Regions regions(const VisibilityCase& drawn, const Subject& subject) {
  Regions result{subject.visibility(drawn.light, {drawn.blockers, {}}, drawn.point).region, {}};
  for (const ConvexBlocker& blocker : drawn.blockers) {
    result.alone.push_back(region_behind({walls(blocker)}, drawn.light, exact(drawn.point)));
  }
  return result;
}

bool is_shadow(Region region) {
  return region == Region::penumbra || region == Region::umbra;
}

/// The premise of all: several blockers before a light that shows its front.
bool applies(const VisibilityCase& drawn) {
  return drawn.blockers.size() > 1 && !is_unlit(drawn.light, exact(drawn.point));
}

Verdict check_shadow_of_union(const VisibilityCase& drawn, const Subject& subject) {
  if (!applies(drawn)) return premise_fails();
  const Regions found = regions(drawn, subject);
  return verdict(is_shadow(found.together) == std::ranges::any_of(found.alone, is_shadow),
                 "the shadow is not the union of the shadows");
}

Verdict check_penumbra_of_union(const VisibilityCase& drawn, const Subject& subject) {
  if (!applies(drawn)) return premise_fails();
  const Regions found = regions(drawn, subject);
  return verdict(found.together != Region::penumbra || found.count(Region::penumbra) > 0,
                 "a penumbra outside of all penumbrae");
}

Verdict check_umbra_of_union(const VisibilityCase& drawn, const Subject& subject) {
  if (!applies(drawn)) return premise_fails();
  const Regions found = regions(drawn, subject);
  const bool in_an_umbra = found.count(Region::umbra) > 0;
  if (in_an_umbra && found.together != Region::umbra) return verdict(false, "an umbra is not in the umbra of all");
  return verdict(found.together != Region::umbra || in_an_umbra || found.count(Region::penumbra) > 1,
                 "umbra outside of all umbrae and of all common penumbrae");
}

rc::Gen<VisibilityCase> cases(Domain domain) {
  using enum LightKind;
  return visibility_cases(domain, {{point, direction, segment, polygon, rounded_polygon},
                                   {BlockerKind::polygon, BlockerKind::polygon, BlockerKind::solid},
                                   3});
}

}  // namespace

std::vector<Law> visibility_laws() {
  return {
      law({"M1", "[P93] 4.2.3.2", "The shadow of many blockers is the union of their shadows."}, cases,
          check_shadow_of_union),
      law({"M2", "[P93] 4.2.3.2", "The penumbra of many blockers lies in the union of their penumbrae."}, cases,
          check_penumbra_of_union),
      law({"M3", "[P93] 4.2.3.2",
           "The umbra of many blockers holds each of their umbrae, and lies in the union of these and of the common "
           "penumbrae of two."},
          cases, check_umbra_of_union),
  };
}

}  // namespace gnomon::laws
