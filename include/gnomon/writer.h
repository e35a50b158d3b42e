#pragma once

/// @file
/// Results as files, for ParaView and others.
///
///     #include <gnomon/writer.h>
///     int main() {
///       using namespace gnomon;
///       const Scene scene = parse_scene(default_scene_text(), "default", ".");
///       const auto files = write_shadow({&scene, default_clip_box(scene).value(), {}}, "written_scene");
///       return files.front() == "shadow.vtm" ? 0 : 1;
///     }

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gnomon/point.h"
#include "gnomon/result.h"
#include "gnomon/scene.h"

namespace gnomon {

/// How a result is laid out on disk. The numbers of the first three are doubles throughout.
enum class OutputFormat {
  vtm,   ///< `shadow.vtm`, a tree of the block files in `shadow/`
  vtpc,  ///< `shadow.vtpc`, the same block files as a partitioned collection with an assembly
  vtp,   ///< `shadow.vtp`, all surfaces in one file, with the cell array `block_id` and the field array `block_names`
  obj,   ///< `shadow.obj`, one group per block, named by its path; decimal numbers that read back as the same doubles
  stl,   ///< one ASCII file per volume surface in `shadow/`; STL knows one nameless triangle soup per file
  gltf,  ///< `shadow.gltf`, one node per block; positions are floats, relative to the centre of the clip box
};

/// The format's name, which is also the file name's ending.
std::string_view name(OutputFormat format);

/// The format of that name, or nothing.
std::optional<OutputFormat> output_format(std::string_view name);

struct WriteOptions {
  std::vector<OutputFormat> formats = {OutputFormat::vtm};
};

/// Writes a result into a folder, which is made if it is not there: the files of the formats asked for,
/// `manifest.json` (every block with file, kind and counts, empty ones too; every pair with its position) and, for vtm
/// and vtpc, `view.py`, a ParaView script that shows the result.
///
/// All files are first written completely to a folder beside their places and then renamed into place, block files
/// first, manifest.json last: a run that fails or is killed before that leaves an earlier result as it was. Block files
/// keep their names from run to run. Files of an earlier result that are not written again are removed, results of
/// other commands and files of others are left alone. Where two processes write into one folder, the last result is
/// there whole.
///
/// Requires: result.scene is not null.
/// Returns:  the files written, relative to the folder, those to be opened by a user first.
/// Throws:   std::runtime_error naming the file that could not be written, and why: a file that is not ours among
/// others;
///           PreconditionError.
std::vector<std::filesystem::path> write_shadow(const ShadowResult& result, const std::filesystem::path& directory,
                                                const WriteOptions& options = {});

/// Makes sure, before anything is computed, that no `manifest.json` or `view.py` of others stands where a result is to
/// be written. A folder that is not there is fine.
///
/// Throws: std::runtime_error naming the file.
void require_result_folder(const std::filesystem::path& directory);

/// The roots of those results in a folder that other commands have written of another scene, or with another box, than
/// the last one: what they show of lights, blockers and receivers is no longer theirs. None if there is no manifest.
std::vector<std::string> outdated_roots(const std::filesystem::path& directory);

/// Results of one scene over time, in a folder: `shadow.pvd`, which ParaView plays, one `shadow_0000/shadow.vtm` per
/// time with the blocks of write_shadow, `manifest.json` and `view.py`. The manifest lists every block that any time
/// has, with the file of the first time that has it.
///
/// All files are written beside their places and renamed together in `publish`, as write_shadow does.
class SeriesWriter {
 public:
  /// Throws: std::runtime_error if the folder cannot be made.
  explicit SeriesWriter(std::filesystem::path directory);
  ~SeriesWriter();
  SeriesWriter(const SeriesWriter&) = delete;
  SeriesWriter& operator=(const SeriesWriter&) = delete;

  /// Adds the result of a time, which is later than the one before.
  ///
  /// Requires: result.scene is not null; of the same elements and the same clip box as the results before.
  /// Throws:   std::runtime_error naming the file that could not be written; PreconditionError.
  void add(double time, const ShadowResult& result);

  /// Returns: the files written, relative to the folder, the one to be opened by a user first.
  /// Throws:  std::runtime_error naming the file that could not be written; PreconditionError if nothing was added.
  std::vector<std::filesystem::path> publish();

 private:
  struct Writing;
  std::unique_ptr<Writing> writing_;
};

/// Points in rows parallel to the axes; x runs fastest, then y, then z.
struct PointGrid {
  std::array<std::uint32_t, 3> shape{};  ///< points along x, y, z; none is 0
  Point3 origin;
  Point3 spacing;

  /// From corner to corner of the box; a single point along an axis lies in the middle.
  static PointGrid in_box(const std::array<std::uint32_t, 3>& shape, const Box3& box);

  /// True if all points are finite and each differs from the next: steps may vanish beside large coordinates.
  bool has_distinct_points() const;

  std::size_t size() const { return std::size_t{shape[0]} * shape[1] * shape[2]; }

  /// The point of that index, in the very doubles that VTK makes of origin and spacing.
  Point3 point(std::size_t index) const;
};

/// What the points of a grid receive of one light.
struct GridValues {
  std::string suffix;  ///< of the arrays' names
  std::vector<std::uint8_t> region;
  std::vector<double> visible_fraction;
  std::vector<double> error_bound;
  std::vector<double> irradiance = {};              ///< [W/m²]; none where points have no normal
  std::vector<double> irradiance_error_bound = {};  ///< the same
};

/// What the points of a grid reflect to an eye of all lights together [W/(m² sr)]; red, green and blue point by point.
struct GridRadiance {
  std::vector<double> radiance;
  std::vector<double> error_bound;
};

/// A surface and what its view factors add up to.
struct SurfaceRow {
  std::string name;
  const std::vector<ConvexPolygon>* shape = nullptr;
  double sum = 0;
  double sum_bound = 0;
};

/// Writes surfaces as `view_factors.vtp` into a folder, with the cell arrays surface_id, row_sum, residual (1 less
/// that) and row_sum_bound; the field array surface_names has their names.
///
/// Throws: std::runtime_error naming the file that could not be written, and why.
void write_view_surfaces(std::span<const SurfaceRow> rows, const Scene& scene, const std::filesystem::path& directory);

/// A wall of a feasible cell: where it comes from, as the arrays facet_kind (6 a goal's plane, 7 the domain's),
/// goal_id, edge_index and vertex_index tell; -1 for what it has not.
struct DrawnWall {
  std::vector<std::uint32_t> corners;  ///< of the cell, around the wall
  std::int32_t facet_kind = 7;
  std::int32_t goal = -1;
  std::int32_t edge = -1;
  std::int32_t vertex = -1;
};

/// A convex cell of feasible positions: a solid, a polygon (one wall), a segment or a point (no wall).
struct DrawnCell {
  std::vector<Point3> corners;
  std::vector<DrawnWall> walls;
};

/// A goal's subject, a point or polygons, and 0 if the goal is fulfilled at the answer, 1 if not, 2 where there is
/// none.
struct DrawnGoal {
  std::string name;
  std::vector<std::vector<Point3>> subjects;
  std::int32_t status = 2;
};

/// What a design's files show.
struct DrawnDesign {
  std::string status;
  std::vector<DrawnCell> cells;
  std::vector<DrawnGoal> goals;
  std::optional<Point3> answer = {};
  double margin = 0;
};

/// Writes a design into a folder: `design.vtm`, and beneath `design/` feasible/cells.vtu, feasible/surface.vtp,
/// goals/NAME.vtp, answer.vtp, and ball.vtp, a sphere of the margin's radius about the answer.
///
/// Throws: std::runtime_error naming the file that could not be written, and why.
std::vector<std::filesystem::path> write_design(const DrawnDesign& design, const Scene& scene,
                                                const std::filesystem::path& directory);

/// Writes a grid with the point arrays region, visible_fraction and error_bound of every light as VTK image data
/// (.vti); where they are known with irradiance and irradiance_error_bound of every light, and with radiance and
/// radiance_error_bound; written beside the file and renamed.
///
/// Requires: as many values as points, of radiance three times as many.
/// Throws:   std::runtime_error naming the file and the cause.
void write_grid(const PointGrid& grid, std::span<const GridValues> values, const Scene& scene,
                const std::filesystem::path& file, const GridRadiance& radiance = {});

}  // namespace gnomon
