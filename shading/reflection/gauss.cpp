#include "shading/reflection/gauss.h"

#include <map>

#include "gnomon/errors.h"

namespace gnomon::shading {
namespace {

/// Legendre's polynomial of degree 16, and the one before it.
struct Legendre {
  Precise value = 1.0, before = 0.0;

  explicit Legendre(const Precise& x) {
    for (int k = 1; k <= static_cast<int>(gauss_nodes); ++k) {
      const Precise next = (Precise(2.0 * k - 1) * x * value - Precise(k - 1.0) * before) / Precise(double(k));
      before = value;
      value = next;
    }
  }
  Precise slope(const Precise& x) const {
    return Precise(double(gauss_nodes)) * (x * value - before) / (x * x - Precise(1.0));
  }
};

/// The number in the middle of an interval, as an interval of nothing else.
Precise thin(const Precise& x) {
  mpfr_t middle;
  mpfr_init2(middle, mpfi_get_prec(x.get()));
  mpfi_get_fr(middle, x.get());
  Precise result;
  mpfi_set_fr(result.get(), middle);
  mpfr_clear(middle);
  return result;
}

/// By Newton's method, which doubles the digits, and a change of sign that holds the node for certain.
Precise node(std::size_t k, int bits) {
  Precise x = std::cos(std::numbers::pi * (double(k) + 0.75) / (double(gauss_nodes) + 0.5));
  for (int round = 0; round < 12; ++round) {
    const Legendre at(x);
    x = thin(x - at.value / at.slope(x));
  }
  const double reach = std::ldexp(1.0, 16 - bits);
  const int below = certain_sign(Legendre(x - Precise(reach)).value);
  const int above = certain_sign(Legendre(x + Precise(reach)).value);
  if (below * above != -1) throw PreconditionError("a node of Gauss's rule was not found");
  return widened(x, reach);
}

GaussRule<Precise> precise_rule(int bits) {
  const Precise::Bits protect(bits);
  GaussRule<Precise> rule;
  for (std::size_t k = 0; k < rule.node.size(); ++k) {
    const Precise x = node(k, bits);
    const Precise slope = Legendre(x).slope(x);
    rule.node[k] = Precise(x);
    rule.weight[k] = Precise(2.0) / ((Precise(1.0) - x * x) * slope * slope);
  }
  return rule;
}

GaussRule<Bounded> bounded_rule() {
  const GaussRule<Precise> precise = precise_rule(128);
  GaussRule<Bounded> rule;
  for (std::size_t k = 0; k < rule.node.size(); ++k) {
    rule.node[k] = bounded(precise.node[k]);
    rule.weight[k] = bounded(precise.weight[k]);
  }
  return rule;
}

}  // namespace

template <>
const GaussRule<Bounded>& gauss_rule<Bounded>() {
  static const GaussRule<Bounded> rule = bounded_rule();
  return rule;
}

/// One a precision and thread, kept.
template <>
const GaussRule<Precise>& gauss_rule<Precise>() {
  thread_local std::map<int, GaussRule<Precise>> rules;
  const int bits = static_cast<int>(mpfi_get_prec(Precise().get()));
  const auto found = rules.find(bits);
  return found != rules.end() ? found->second : rules.emplace(bits, precise_rule(bits)).first->second;
}

}  // namespace gnomon::shading
