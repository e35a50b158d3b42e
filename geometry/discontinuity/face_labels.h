#pragma once

/// The regions of a receiver's faces. Private to this folder.

#include <cstdint>
#include <span>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/light_before.h"
#include "geometry/discontinuity/receiver_mesh_data.h"
#include "geometry/discontinuity/vertex_shadows.h"

namespace gnomon::event {

/// A receiver and what it is lit by.
struct LitReceiver {
  const EventScene& scene;
  const VertexShadows& shadows;
  const Light& light;
  std::span<const ConvexBlocker> blockers;
  std::uint32_t receiver = 0;
  const LightBefore& before;
  std::span<const ClosedSurface> enclosures = {};  ///< what lies strictly inside is umbra
};

/// Finds the region of every face.
///
/// Method:    a face that was not reached is asked about, by a point inside of it. What intervals tell spreads to its
///            neighbours across edges whose events cannot change it: a light seen whole stays so but for boundaries of
///            occlusion; a vertex of the light that is seen, and one that is hidden, stay so but for events of
///            theirs. Faces left over are asked about exactly. Where the receiver's plane meets the light, every face
///            is asked about: horizon events may end what a light vertex or an edge of it was seen to do.
/// Exactness: exact; faces in which penumbra and umbra may both occur become unresolved_eee.
/// Labels are the same for any number of threads.
void label_faces(const LitReceiver& lit, ReceiverMesh::Data& data, unsigned threads);

}  // namespace gnomon::event
