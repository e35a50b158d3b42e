#pragma once

/// What several lights give to places of receivers. Private to the libraries.

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "gnomon/illumination.h"

namespace gnomon::illumination {

/// All lights behind the same obstacles, for several workers.
class LightsTogether {
 public:
  LightsTogether(std::span<const IlluminationLight> lights, const Obstacles& obstacles,
                 std::span<const ConvexPolygon> receivers, const LengthUnit& unit, unsigned workers);

  /// The irradiance of each light [W/m²] at a place of a receiver; asked by a worker of for_all.
  std::vector<Irradiance> each(std::size_t worker, std::uint32_t receiver, const Point3& p);
  Irradiance sum(std::size_t worker, std::uint32_t receiver, const Point3& p);

  std::size_t size() const { return lights_; }
  std::size_t evaluations() const { return evaluations_; }

 private:
  struct Receiver {
    ReceiverPoint point;
    Point3 normal;
  };
  struct Part {
    Light light;
    std::uint32_t of;  ///< the light
  };

  std::size_t lights_;
  std::vector<Part> parts_;
  std::vector<Receiver> receivers_;
  LengthUnit unit_;
  std::vector<std::vector<LightIrradiance>> of_workers_;  ///< each part's
  std::atomic<std::size_t> evaluations_ = 0;
};

}  // namespace gnomon::illumination
