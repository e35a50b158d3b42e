#include "viz/vtk/manifest.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gnomon/pair.h"
#include "viz/vtk/block.h"
#include "viz/vtk/cell_arrays.h"
#include "viz/vtk/palette.h"

namespace gnomon::viz {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* schema = "gnomon/manifest/1";

Json fields_json(const Fields& fields) {
  Json json = Json::object();
  for (const Field& field : fields) std::visit([&](const auto& values) { json[field.name] = values; }, field.values);
  return json;
}

Json arrays_json() {
  Json json = Json::array();
  for (const CellArray& array : cell_arrays()) {
    json.push_back({{"name", array.name}, {"type", array.type}, {"none", array.none}, {"meaning", array.meaning}});
  }
  return json;
}

/// The colours that the scripts for ParaView use, too.
Json palette_json() {
  return {{"light", palette.light},           {"blocker", palette.blocker},
          {"receiver", palette.receiver},     {"edge", palette.edge},
          {"plane", palette.occlusion},       {"separating", palette.separating},
          {"supporting", palette.supporting}, {"lit", palette.lit},
          {"penumbra", palette.penumbra},     {"umbra", palette.umbra},
          {"unlit", palette.unlit},           {"unresolved_eee", palette.unresolved_eee},
          {"D0", palette.discontinuities[0]}, {"D1", palette.discontinuities[1]},
          {"D2", palette.discontinuities[2]}};
}

Json volume_json(const VolumeFacts& facts, const VolumeMesh& mesh) {
  return {{"empty", facts.empty},
          {"bounded", facts.bounded},
          {"components", facts.components},
          {"volume_in_box", mesh.volume.nearest},
          {"volume_in_box_exact", mesh.volume.exact}};
}

Json pair_json(const PairResult& pair) {
  Json json = {{"light", pair.light},         {"blocker", pair.blocker},
               {"light_id", pair.light_id},   {"blocker_id", pair.blocker_id},
               {"supported", pair.supported}, {"position", gnomon::name(pair.position)}};
  if (!pair.supported) return json;
  json["occlusion"] = volume_json(pair.volumes.occlusion_facts, pair.meshes.occlusion);
  json["umbra"] = volume_json(pair.volumes.umbra_facts, pair.meshes.umbra);
  json["penumbra"] = volume_json(pair.volumes.penumbra_facts, pair.meshes.penumbra);
  return json;
}

Json region_json(const planar::PlanarRegion& region, const planar::RegionInBox& in_box) {
  return {{"empty", region.empty()},
          {"bounded", region.bounded()},
          {"components", region.components},
          {"volume_in_box", in_box.area.nearest},
          {"volume_in_box_exact", in_box.area.exact}};
}

Json pair_json(const PlanarPairResult& pair) {
  return {{"light", pair.light},
          {"blocker", pair.blocker},
          {"light_id", pair.light_id},
          {"blocker_id", pair.blocker_id},
          {"supported", true},
          {"position", gnomon::name(pair.position)},
          {"occlusion", region_json(pair.regions.occlusion, pair.in_box.occlusion)},
          {"umbra", region_json(pair.regions.umbra, pair.in_box.umbra)},
          {"penumbra", region_json(pair.regions.penumbra, pair.in_box.penumbra)}};
}

Json merged_json(const std::vector<MergedResult>& merged) {
  Json json = {
      {"note",
       "Occlusion volumes are united over the parts of a blocker, or of all blockers. Umbrae are not: parts that each "
       "hide only some "
       "of the light may hide all of it together, so the umbra of the whole is more than the union of umbrae."},
      {"blockers", Json::array()}};
  for (const MergedResult& result : merged) {
    json["blockers"].push_back({{"light", result.light},
                                {"blocker", result.blocker},
                                {"volume_in_box", result.occlusion.mesh.volume.nearest},
                                {"volume_in_box_exact", result.occlusion.mesh.volume.exact}});
  }
  return json;
}

/// Those beyond the arrays that the manifest describes.
std::vector<std::string> more_cell_arrays(std::vector<std::string> names) {
  std::erase_if(names,
                [](const std::string& name) { return std::ranges::count(cell_arrays(), name, &CellArray::name); });
  return names;
}

Json block_json(const WrittenBlock& written) {
  const Block& block = *written.block;
  Json json = {{"path", block.path},
               {"name", joined(block.path)},
               {"kind", block.kind},
               {"empty", block.empty()},
               {"points", block.data->GetNumberOfPoints()},
               {"cells", block.data->GetNumberOfCells()},
               {"cell_arrays", names_of_cell_arrays(*block.data)},
               {"file", nullptr},
               {"files", written.files},
               {"field_data", fields_json(block.fields)}};
  if (!written.files.empty()) json["file"] = written.files.front();
  json["generation"] = written.generation;
  const auto more = more_cell_arrays(names_of_cell_arrays(*block.data));
  if (!more.empty()) json["more_cell_arrays"] = more;
  return json;
}

Box3 box_of(const Json& sides, const std::filesystem::path& file) {
  const auto side = [&](std::size_t i) { return sides.at(i).get<double>(); };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double width = side(axis + 3) - side(axis);
    if (std::isfinite(width) && width >= 0) continue;
    throw ResultError("cannot read " + file.string() + ": its clip_box runs from " + std::to_string(side(axis)) +
                      " to " + std::to_string(side(axis + 3)));
  }
  return {{side(0), side(1), side(2)}, {side(3), side(4), side(5)}};
}

ListedBlock listed_block(const Json& block) {
  const Json& name = block.at("file");
  return {block.at("path"), block.at("kind"), name.is_null() ? "" : name.get<std::string>(),
          block.value("generation", "")};
}

std::string dimension_problem(const std::filesystem::path& file, int found) {
  return "cannot read " + file.string() + ": found the dimension " + std::to_string(found) + ", expected 2 or 3";
}

Json parsed(const std::filesystem::path& file) {
  const std::string start = "cannot read " + file.string() + ": ";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored))) {
    throw ResultError(start + "no result of `gnomon shadow` lies there");
  }
  std::ifstream in(file);
  if (!in) throw ResultError(start + "the file cannot be opened");
  try {
    Json json = Json::parse(in);
    if (!json.is_object() || json.value("schema", Json()) != schema) {
      throw ResultError(start + "no list of files of a result: its \"schema\" is not " + schema);
    }
    return json;
  } catch (const Json::exception& error) {
    throw ResultError(start + error.what());
  }
}

/// The command that wrote a result; in older manifests its roots tell.
std::string command_of(const Json& result) {
  const auto command = result.find("command");
  if (command != result.end()) return command->get<std::string>();
  for (const Json& root : result.at("roots")) return std::filesystem::path(root.get<std::string>()).stem().string();
  return "shadow";
}

OtherResult other_result(const Json& result) {
  return {command_of(result), result.value("generation", ""), result.at("roots").get<std::vector<std::string>>(),
          result.at("files").get<std::vector<std::string>>()};
}

/// The result that a manifest tells of, and those that it only mentions.
std::vector<OtherResult> results_in(const Json& manifest) {
  std::vector<OtherResult> results = {other_result(manifest)};
  for (const Json& other : manifest.value("others", Json::array())) results.push_back(other_result(other));
  return results;
}

}  // namespace

std::string manifest_text(const ShadowResult& result, const ManifestEntries& entries) {
  Json json = {{"schema", schema},
               {"command", entries.command},
               {"generation", entries.generations.front()},
               {"dimension", dimension(*result.scene)},
               {"roots", entries.roots}};
  if (entries.generations.size() > 1) json["generations"] = entries.generations;
  if (const auto* space = std::get_if<SpaceScene>(result.scene)) json["up"] = space->up == UpAxis::y ? "y" : "z";
  json["field_data"] = fields_json(result_fields(result));
  json["palette"] = palette_json();
  json["cell_arrays"] = arrays_json();
  json["pairs"] = Json::array();
  for (const PairResult& pair : result.pairs) json["pairs"].push_back(pair_json(pair));
  for (const PlanarPairResult& pair : result.planar_pairs) json["pairs"].push_back(pair_json(pair));
  if (!result.merged.empty()) json["merged"] = merged_json(result.merged);
  json["blocks"] = Json::array();
  for (const WrittenBlock& block : entries.blocks) json["blocks"].push_back(block_json(block));
  json["files"] = entries.files;
  // A scene's file name may be no UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string with_others(const std::string& manifest, const std::vector<OtherResult>& others) {
  if (others.empty()) return manifest;
  Json json = Json::parse(manifest);
  json["others"] = Json::array();
  for (const OtherResult& other : others) {
    json["others"].push_back(
        {{"command", other.command}, {"generation", other.generation}, {"roots", other.roots}, {"files", other.files}});
  }
  return json.dump(1) + "\n";
}

ListedResult read_manifest(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "manifest.json";
  const Json json = parsed(file);
  try {
    ListedResult result;
    result.scene = json.at("field_data").at("scene").at(0);
    result.dimension = json.at("dimension");
    if (result.dimension != 2 && result.dimension != 3) throw ResultError(dimension_problem(file, result.dimension));
    result.up = json.value("up", "z") == "y" ? UpAxis::y : UpAxis::z;
    if (const auto unit = json.at("field_data").find("length_unit"); unit != json.at("field_data").end()) {
      result.length_unit = unit->at(0);
    }
    result.clip_box = box_of(json.at("field_data").at("clip_box"), file);
    for (const Json& pair : json.at("pairs")) result.complete = result.complete && pair.at("supported").get<bool>();
    for (const Json& block : json.at("blocks")) result.blocks.push_back(listed_block(block));
    return result;
  } catch (const Json::exception& error) {
    throw ResultError("cannot read " + file.string() + ": " + error.what());
  }
}

std::vector<OtherResult> results_in_folder(const std::filesystem::path& directory) {
  try {
    return results_in(parsed(directory / "manifest.json"));
  } catch (const std::exception&) {
    return {};
  }
}

EarlierResults earlier_results(const std::filesystem::path& directory, const std::string& command) {
  EarlierResults earlier;
  for (OtherResult& result : results_in_folder(directory)) {
    if (result.command == command) {
      earlier.files.insert(earlier.files.end(), result.files.begin(), result.files.end());
    } else {
      earlier.others.push_back(std::move(result));
    }
  }
  return earlier;
}

}  // namespace gnomon::viz
