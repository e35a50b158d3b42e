#pragma once

/// Receivers in triangles that are fine enough to be painted by what they receive. Private to the libraries.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "gnomon/irradiance.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon::image {

/// The irradiance of a place, asked by a worker of for_all.
using IrradianceAt = std::function<Irradiance(std::size_t worker, const Point3&)>;

/// The triangles of divided receivers, each divided by itself.
///
/// Definition: edges are halved while they are longer than a 24th of the whole; `refine` halves them further where the
///             middle is off from the mean of the ends by more than a 400th of the largest irradiance, or the ends
///             differ by more than a 24th of it, down to a 1000th of the whole.
/// Exactness:  a corner has the irradiance, with its bound, of a place 2^-20 of the way from it to the middle of the
///             divided receiver's triangle, so that it is that of its own face where the light jumps. What is
///             interpolated between corners is an estimate.
class IrradianceMesh {
 public:
  struct Corner {
    Point3 point;
    Irradiance irradiance;
  };

  /// A piece of a receiver, with whom to ask.
  void add(const MeshDrawing& drawing, IrradianceAt irradiance);

  /// Asks at all corners. Requires: all pieces have been added.
  void begin(unsigned threads);

  /// The largest irradiance at a corner that is finite.
  double largest() const;

  void refine(double largest, unsigned threads);

  std::vector<Corner> corners() const;
  /// By their corners, counterclockwise seen from the front.
  std::vector<std::array<std::uint32_t, 3>> triangles() const;

 private:
  /// A triangle of the drawing and what has become of it.
  struct Root {
    const IrradianceAt* irradiance;
    Point3 middle;
    std::vector<Corner> corners;
    std::vector<std::array<std::uint32_t, 3>> triangles;
  };
  class Halving;

  double extent() const;

  std::vector<IrradianceAt> pieces_;
  std::vector<std::size_t> piece_of_;  ///< of each root
  std::vector<Root> roots_;
};

}  // namespace gnomon::image
