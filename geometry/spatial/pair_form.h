#pragma once

#include <optional>

#include "geometry/spatial/body_pair.h"
#include "geometry/spatial/pair.h"

namespace gnomon {

/// Why a pair is not supported.
inline constexpr const char* unsupported_pair =
    "the light's vertices are not exactly coplanar, so the blocker has to lie strictly apart from it, and strictly in "
    "front if it is one-sided";

/// What is asked of a pair before anything else, found out once: how the two stand to each other, and the form in which
/// its algorithms take them. Each answer is worked out when it is first asked for.
///
/// Requires: light and blocker outlive it.
class PairForm {
 public:
  PairForm(const Light& light, const ConvexBlocker& blocker);

  /// See pair_position.
  Position position();

  /// See is_supported.
  bool is_supported();

  /// The pair if it is one in standard position: a flat blocker, and a finite light that is flat or has no area.
  const std::optional<StandardPair>& standard() const { return standard_; }

  /// Any pair.
  BodyPair& bodies();

 private:
  const Light* light_;
  const ConvexBlocker* blocker_;
  std::optional<Position> position_;
  std::optional<StandardPair> standard_;
  std::optional<BodyPair> bodies_;
};

}  // namespace gnomon
