#include "shading/illumination/packed_meshes.h"

#include <string>

#include "geometry/shared_work.h"

namespace gnomon::illumination {

std::vector<char> packed(std::span<const IlluminationMesh> meshes, std::span<const std::uint32_t> receivers) {
  std::string bytes;
  for (const std::uint32_t r : receivers) {
    const IlluminationMesh& mesh = meshes[r];
    append_bytes(bytes, mesh.points);
    append_bytes(bytes, mesh.irradiance);
    append_bytes(bytes, std::vector<std::size_t>{mesh.of_lights.size()});
    for (const std::vector<Irradiance>& of_light : mesh.of_lights) append_bytes(bytes, of_light);
    append_bytes(bytes, mesh.faces);
    append_bytes(bytes, mesh.edges);
  }
  return {bytes.begin(), bytes.end()};
}

void unpack(std::span<const char> bytes, std::span<const std::uint32_t> receivers,
            std::vector<IlluminationMesh>& meshes) {
  std::string_view left(bytes.data(), bytes.size());
  for (const std::uint32_t r : receivers) {
    IlluminationMesh& mesh = meshes[r];
    mesh.points = take_values<Point3>(left);
    mesh.irradiance = take_values<Irradiance>(left);
    mesh.of_lights.resize(take_values<std::size_t>(left).at(0));
    for (std::vector<Irradiance>& of_light : mesh.of_lights) of_light = take_values<Irradiance>(left);
    mesh.faces = take_values<IlluminationFace>(left);
    mesh.edges = take_values<IlluminationEdge>(left);
  }
}

}  // namespace gnomon::illumination
