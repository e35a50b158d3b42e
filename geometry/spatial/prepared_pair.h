#pragma once

#include <optional>

#include "geometry/spatial/pair_form.h"
#include "geometry/spatial/pair_half_spaces.h"
#include "gnomon/shadow_mesh.h"

namespace gnomon {

/// A pair with the half-spaces of its volumes.
struct PreparedPair {
  PairHalfSpaces half_spaces;
  std::optional<StandardPair> standard;  ///< with its contacts, where the occlusion has a form known beforehand
  std::optional<StandardContacts> contacts;
  std::optional<BodyPair> bodies;  ///< elsewhere

  bool has_penumbra() const { return standard ? standard->light.size() > 1 : bodies->light.corners.size() > 1; }
  bool has_solid() const { return bodies && !bodies->blocker.flat; }
};

/// Requires: light and blocker outlive the result; the form is theirs.
/// Throws:   PreconditionError if there is a pair_refusal(light, blocker).
PreparedPair prepared_pair(const Light& light, PairForm form);
PreparedPair prepared_pair(const Light& light, const ConvexBlocker& blocker);

/// The answers of shadow_volumes and shadow_meshes.
ShadowVolumes volumes_of(PreparedPair pair, const Light& light, const ConvexBlocker& blocker);
ShadowMeshes meshes_of(const PreparedPair& pair, const Box3& box, const ShadowParts& parts);

}  // namespace gnomon
