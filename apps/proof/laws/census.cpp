#include "apps/proof/laws/census.h"

#include <algorithm>

namespace gnomon::laws {
namespace {

template <std::size_t N>
void count(std::array<std::uint32_t, N>& counts, std::size_t value) {
  ++counts[std::min(value, N - 1)];
}

template <std::size_t N>
void add_up(std::array<std::uint32_t, N>& counts, const std::array<std::uint32_t, N>& others) {
  for (std::size_t i = 0; i < N; ++i) counts[i] += others[i];
}

}  // namespace

void Census::add_point(Region region) {
  count(points, static_cast<std::size_t>(region));
}
void Census::add_umbrae(std::size_t number) {
  count(umbrae, number);
}
void Census::add_penumbrae(std::size_t number) {
  count(penumbrae, number);
}
void Census::add_pockets(std::size_t number) {
  count(pockets, number);
}

void Census::add(const planar::ShadowRegions& regions) {
  add_umbrae(regions.umbra.components);
  add_penumbrae(regions.penumbra.components);
}

void Census::add(const ShadowVolumes& volumes) {
  add_umbrae(volumes.umbra_facts.components);
  add_penumbrae(volumes.penumbra_facts.components);
  add_pockets(volumes.umbra_pockets);
}

Census& Census::operator+=(const Census& other) {
  cases += other.cases;
  add_up(points, other.points);
  add_up(umbrae, other.umbrae);
  add_up(penumbrae, other.penumbrae);
  add_up(pockets, other.pockets);
  return *this;
}

}  // namespace gnomon::laws
