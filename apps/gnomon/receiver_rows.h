#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/gnomon/point_batches.h"
#include "geometry/bodies/own_blockers.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"
#include "shading/receiver_grid.h"

namespace gnomon {

/// Points on the facets of a receiver, facet by facet, as rows of a table.
class ReceiverRows {
 public:
  /// `shape` tells the number of points of a ReceiverGrid on each facet; without one a facet has one point, the mean of
  /// its corners. The scene outlives the rows.
  /// Requires: the scene has a receiver that is called so.
  ReceiverRows(const SpaceScene& scene, const std::string& name,
               const std::optional<std::array<std::uint32_t, 2>>& shape);

  /// x,y,z,nx,ny,nz, and of several facets their names.
  std::string header() const;

  /// The next rows, at most 1,024: as many are held in memory at a time. None at the end.
  std::vector<TableRow> next();

  /// The row's point as one of its facet.
  ReceiverPoint receiver_of(const PointRow& row, const OwnBlockers& own) const;

  /// False where a facet is so wide that points in its rectangle overflow.
  bool has_finite_points() const;

  /// Of all points that are looked at.
  std::size_t count() const { return facets_.size() * cells_; }

 private:
  ReceiverGrid grid_on(const SceneReceiver& facet) const;
  void append_row(std::vector<TableRow>& rows) const;

  std::vector<const SceneReceiver*> facets_;
  std::optional<std::array<std::uint32_t, 2>> shape_;
  std::size_t cells_ = 1;  ///< of each facet
  std::size_t next_ = 0;
  std::optional<ReceiverGrid> grid_;  ///< of the facet of the next row
};

/// Accepts what a receiver, one of its sides or facets is called.
///
/// Throws: UsageError that names the option, the name, and the receivers there are.
void require_receiver(const std::string& option, const std::string& name, const std::vector<SceneReceiver>& receivers);

/// Where rows come from, of a table or spread over a receiver.
struct RowSource {
  std::string file;                                           ///< as messages call it
  std::string header;                                         ///< the columns that the result repeats
  std::function<std::vector<TableRow>()> next_batch;          ///< none at the end
  std::function<ReceiverPoint(const PointRow&)> receiver_of;  ///< any number of threads may ask
  std::size_t count = 0;                                      ///< of rows; 0 if nobody knows
  std::function<double()> share = [] { return -1.0; };        ///< of the work that has been read, if count is 0
};

}  // namespace gnomon
