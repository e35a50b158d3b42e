#pragma once

#include <optional>

#include "geometry/spatial/body_pair.h"
#include "geometry/spatial/pair.h"

namespace gnomon {

/// What is asked of a pair before anything else, found out once: how the two stand to each other, and the form in which
/// its algorithms take them. Each answer is worked out when it is first asked for.
///
/// Requires: light and blocker outlive it.
class PairForm {
 public:
  PairForm(const Light& light, const ConvexBlocker& blocker);

  /// See pair_position.
  Position position();

  /// See pair_refusal.
  std::string_view refusal();

  /// Throws: PreconditionError if there is a refusal.
  void require_support();

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
