#pragma once

/// The regions of a receiver's faces. Private to this folder.

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/light_before.h"
#include "geometry/discontinuity/quick_sight.h"
#include "geometry/discontinuity/receiver_mesh_data.h"
#include "geometry/discontinuity/receiver_sight.h"

namespace gnomon::event {

/// Finds the region of every face.
///
/// Method:    a face that was not reached is asked about, by a point inside of it. What is found spreads to its
///            neighbours across edges whose events cannot change it: a light seen whole stays so but for boundaries of
///            occlusion; a vertex of the light that is seen, and one that is hidden, stay so but for events of
///            theirs. Where the receiver's plane meets the light, every face is asked about: horizon events may end
///            what a light vertex or an edge of it was seen to do.
/// Exactness: exact; faces in which penumbra and umbra may both occur become unresolved_eee.
void label_faces(const EventScene& scene, const VertexShadows& shadows, std::uint32_t receiver,
                 const LightBefore& light, ReceiverSight& sight, ReceiverMesh::Data& data);

}  // namespace gnomon::event
