#include "apps/gnomon/receiver_rows.h"

#include <algorithm>

#include "apps/gnomon/text.h"
#include "geometry/scene/receiver_facets.h"

namespace gnomon {
namespace {

constexpr std::size_t most_rows = 1024;

}  // namespace

ReceiverRows::ReceiverRows(const SpaceScene& scene, const std::string& name,
                           const std::optional<std::array<std::uint32_t, 2>>& shape)
    : shape_(shape), cells_(shape ? std::size_t{(*shape)[0]} * (*shape)[1] : 1) {
  for (const SceneReceiver& receiver : scene.receivers) {
    if (receiver.is_called(name)) facets_.push_back(&receiver);
  }
}

std::string ReceiverRows::header() const {
  return facets_.size() == 1 ? "x,y,z,nx,ny,nz" : "x,y,z,nx,ny,nz,facet";
}

ReceiverGrid ReceiverRows::grid_on(const SceneReceiver& facet) const {
  return {facet.shape, shape_.value_or(std::array<std::uint32_t, 2>{1, 1})};
}

bool ReceiverRows::has_finite_points() const {
  return std::ranges::all_of(facets_, [&](const SceneReceiver* facet) { return grid_on(*facet).has_finite_points(); });
}

void ReceiverRows::append_row(std::vector<TableRow>& rows) const {
  const SceneReceiver& facet = *facets_[next_ / cells_];
  const Point3 p = shape_ ? grid_->point(next_ % cells_) : mean_of_corners(facet.shape);
  if (shape_ && !grid_->is_on_receiver(p)) return;
  const Point3 n = grid_->normal();
  std::string text;
  for (const double number : {p.x, p.y, p.z, n.x, n.y, n.z}) text += (text.empty() ? "" : ",") + number_text(number);
  if (facets_.size() > 1) text += ',' + csv_field(facet.name);
  rows.emplace_back(PointRow{next_ + 1, text, {p.x, p.y, p.z}, {n.x, n.y, n.z}});
}

std::vector<TableRow> ReceiverRows::next() {
  std::vector<TableRow> rows;
  for (; rows.size() < most_rows && next_ < count(); ++next_) {
    if (next_ % cells_ == 0) grid_ = grid_on(*facets_[next_ / cells_]);
    append_row(rows);
  }
  return rows;
}

ReceiverPoint ReceiverRows::receiver_of(const PointRow& row, const OwnBlockers& own) const {
  const ConvexPolygon& facet = facets_[(row.line - 1) / cells_]->shape;
  const auto& [x, y, z] = row.coordinates;
  return {{x, y, z}, facet_front(facet), own.of(facet)};
}

void require_receiver(const std::string& option, const std::string& name, const std::vector<SceneReceiver>& receivers) {
  if (name.empty()) return;
  if (std::any_of(receivers.begin(), receivers.end(), [&](const auto& r) { return r.is_called(name); })) return;
  std::string known;
  for (const ReceiverGroup side : receiver_sides(receivers)) {
    known += (known.empty() ? "'" : ", '") + side.front().side + "'";
  }
  throw UsageError(option + ": the scene has no receiver '" + name + "'; it has " + (known.empty() ? "none" : known));
}

}  // namespace gnomon
