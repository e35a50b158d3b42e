#include <mutex>
#include <optional>
#include <utility>

#include "geometry/spatial/prepared_pair.h"
#include "gnomon/shadow_mesh.h"

namespace gnomon {

PreparedPair prepared_pair(const Light& light, PairForm form) {
  form.require_support();
  PreparedPair result;
  result.standard = form.standard();
  if (result.standard) {
    result.contacts.emplace(*result.standard);
    result.half_spaces = standard_half_spaces(*result.standard, *result.contacts);
  } else {
    result.bodies = std::move(form.bodies());
    result.half_spaces = pair_half_spaces(*result.bodies, light);
  }
  return result;
}

PreparedPair prepared_pair(const Light& light, const ConvexBlocker& blocker) {
  return prepared_pair(light, PairForm(light, blocker));
}

struct ShadowPair::Content {
  Content(Light given_light, ConvexBlocker given_blocker)
      : light(std::move(given_light)),
        blocker(std::move(given_blocker)),
        form(light, blocker),
        position(form.position()),
        refusal(form.refusal()) {}

  const PreparedPair& prepared() const {
    std::call_once(is_prepared, [&] { made.emplace(prepared_pair(light, std::move(form))); });
    return *made;
  }

  Light light;
  ConvexBlocker blocker;
  mutable PairForm form;
  Position position;
  std::string_view refusal;
  mutable std::once_flag is_prepared;
  mutable std::optional<PreparedPair> made;
};

ShadowPair::ShadowPair(Light light, ConvexBlocker blocker)
    : content_(std::make_shared<const Content>(std::move(light), std::move(blocker))) {}

const ConvexBlocker& ShadowPair::blocker() const {
  return content_->blocker;
}

Position ShadowPair::position() const {
  return content_->position;
}

std::string_view ShadowPair::refusal() const {
  return content_->refusal;
}

ShadowVolumes ShadowPair::volumes() const {
  return volumes_of(content_->prepared(), content_->light, content_->blocker);
}

ShadowMeshes ShadowPair::meshes(const Box3& box, const ShadowParts& parts) const {
  return meshes_of(content_->prepared(), box, parts);
}

ShadowVolumes shadow_volumes(const Light& light, const ConvexBlocker& blocker) {
  return volumes_of(prepared_pair(light, blocker), light, blocker);
}

ShadowMeshes shadow_meshes(const Light& light, const ConvexBlocker& blocker, const Box3& box,
                           const ShadowParts& parts) {
  return meshes_of(prepared_pair(light, blocker), box, parts);
}

}  // namespace gnomon
