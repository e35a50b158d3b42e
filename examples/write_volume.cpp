// Reads a scene, computes the shadow of its first light and blocker, and writes a folder that ParaView opens.
// Usage: write_volume SCENE DIR

#include <cstdio>
#include <exception>
#include <variant>

#include <gnomon/scene.h>
#include <gnomon/writer.h>

namespace {

void write_first_pair(const char* file, const char* directory) {
  using namespace gnomon;
  const Scene scene = read_scene(file);
  const auto& space = std::get<SpaceScene>(scene);
  const Light& light = space.lights.at(0).shape;
  const ConvexPolygon& blocker = std::get<ConvexPolygon>(space.blockers.at(0).shape);
  const Box3 box = default_clip_box(scene).value();

  PairResult pair;
  pair.light = space.lights[0].name;
  pair.blocker = space.blockers[0].name;
  pair.position = pair_position(light, blocker);
  pair.supported = pair.position == Position::standard;
  if (pair.supported) {
    pair.volumes = shadow_volumes(light, blocker);
    pair.meshes = shadow_meshes(light, blocker, box);
  }
  for (const auto& written : write_shadow({&scene, box, {pair}}, directory)) std::printf("%s\n", written.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: write_volume SCENE DIR\n");
    return 2;
  }
  try {
    write_first_pair(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_volume: %s\n", error.what());
    return 1;
  }
}
