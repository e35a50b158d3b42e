#pragma once

#include <cstdint>
#include <vector>

#include "geometry/spatial/pair.h"

namespace gnomon {

/// Calls on_contact(k, TouchedCorners) for every side k of the blocker in order, walking the touched corner around an
/// area light. `outward` is +1 for supporting planes (no light corner on the positive side), -1 for separating planes
/// (none on the negative side). `orientation` is a sign like exact_orientation.
///
/// While the blocker side advances, the touched corner only moves forward: both rings turn the same way, and the
/// blocker lies strictly on one side of the light's plane.
///
/// Requires: the rings of a standard pair, the light's of at least 3 corners.
/// Cost:     2 n + m orientations at most: n to find the first corner, and every further one either moves on around
///           the light or is the last of its blocker side.
template <class Orientation, class OnContact>
void walk_area_light(const Ring& light, const Ring& blocker, int outward, const Orientation& orientation,
                     OnContact&& on_contact) {
  const Point3* start = &blocker.corner(0);
  const Point3* end = &blocker.corner(1);
  const auto gain = [&](const Point3& from, const Point3& to) { return outward * orientation(*start, *end, from, to); };
  std::uint32_t j = 0;
  for (std::uint32_t candidate = 1; candidate < light.size(); ++candidate) {
    if (gain(light.corner(j), light.corner(candidate)) > 0) j = candidate;
  }
  if (gain(light.corner(j), light.corner(light.previous(j))) == 0) j = light.previous(j);
  std::uint32_t ahead = light.next(j);
  const Point3* here = &light.corner(j);
  const Point3* there = &light.corner(ahead);
  for (std::uint32_t k = 0;;) {
    int step = gain(*here, *there);
    for (; step > 0; step = gain(*here, *there)) {
      j = ahead;
      ahead = light.next(ahead);
      here = there;
      there = &light.corner(ahead);
    }
    on_contact(k, TouchedCorners{j, step == 0 ? ahead : j, false});
    if (++k == blocker.size()) return;
    start = end;
    end = &blocker.corner(blocker.next(k));
  }
}

/// The contacts of all blocker sides with a linear light. A side coplanar with the light is touched by both ends; which
/// end comes first is what its neighbours touch.
std::vector<TouchedCorners> linear_light_contacts(const StandardPair& pair, int outward);

/// The same for any light.
template <class OnContact>
void for_each_contact(const StandardPair& pair, int outward, OnContact&& on_contact) {
  if (pair.light.size() > 2) {
    walk_area_light(pair.light, pair.blocker, outward, pair.orientation, on_contact);
  } else if (pair.light.size() == 2) {
    const std::vector<TouchedCorners> contacts = linear_light_contacts(pair, outward);
    for (std::uint32_t k = 0; k < contacts.size(); ++k) on_contact(k, contacts[k]);
  } else {
    for (std::uint32_t k = 0; k < pair.blocker.size(); ++k) on_contact(k, TouchedCorners{0, 0, true});
  }
}

}  // namespace gnomon
