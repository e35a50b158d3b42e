#include "geometry/scene/gltf_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "gnomon/scene.h"
#include "tests/support/gltf_model.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string file_name = "room.gltf";

GltfScene scene_of(const std::string& bytes) {
  return gltf_scene(bytes, file_name, testing::TempDir());
}

std::string gltf_refusal(const std::string& bytes) {
  try {
    scene_of(bytes);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "nothing";
}

/// A triangle in the plane z = 0 whose front is up.
GltfModel one_triangle() {
  GltfModel model;
  model.mesh({{"attributes", {{"POSITION", model.points({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
  model.node({{"mesh", 0}});
  return model;
}

std::vector<Point3> facet_places(const GltfScene& scene, std::size_t facet) {
  std::vector<Point3> points;
  for (const std::uint32_t v : scene.soup.facets.at(facet)) points.push_back(scene.soup.vertices[v]);
  return points;
}

void expect_places(const GltfScene& scene, const std::vector<Point3>& expected) {
  const std::vector<Point3> found = facet_places(scene, 0);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found[k].x, expected[k].x, 1e-15);
    EXPECT_NEAR(found[k].y, expected[k].y, 1e-15);
    EXPECT_NEAR(found[k].z, expected[k].z, 1e-15);
  }
}

TEST(GltfScene, IsTheSameAsTextAsBinaryAndWithABufferBesideIt) {
  const GltfModel model = one_triangle();
  std::ofstream(testing::TempDir() + "/a b.bin", std::ios::binary) << model.bytes;
  for (const std::string& bytes : {model.text(), model.binary(), model.text_with_buffer("a%20b.bin")}) {
    EXPECT_EQ(facet_places(scene_of(bytes), 0), (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  }
}

TEST(GltfScene, PlacesMeshesByTheNodesAboveThem) {
  GltfModel model = one_triangle();
  // Scaled, then turned by a right angle about z, then moved; and moved again by the node above.
  const double half = std::sqrt(0.5);
  model.document["nodes"] = {
      {{"mesh", 0}, {"translation", {1, 2, 3}}, {"rotation", {0, 0, half, half}}, {"scale", {2, 3, 1}}},
      {{"children", {0}}, {"translation", {10, 0, 0}}},
      {{"mesh", 0}, {"translation", {-5, 0, 0}}}};
  model.document["scenes"] = {{{"nodes", {2}}}, {{"nodes", {1}}}};
  model.document["scene"] = 1;
  expect_places(scene_of(model.text()), {{11, 2, 3}, {11, 4, 3}, {8, 2, 3}});
  EXPECT_EQ(scene_of(model.text()).soup.facets.size(), 1U);
  // Without a choice the first scene is shown; without scenes all that is nobody's child.
  model.document.erase("scene");
  expect_places(scene_of(model.text()), {{-5, 0, 0}, {-4, 0, 0}, {-5, 1, 0}});
  model.document.erase("scenes");
  EXPECT_EQ(scene_of(model.text()).soup.facets.size(), 2U);
  model.document["nodes"] = {{{"mesh", 0}, {"matrix", {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 1, 0, 11, 2, 3, 1}}}};
  expect_places(scene_of(model.text()), {{11, 2, 3}, {11, 4, 3}, {8, 2, 3}});
}

TEST(GltfScene, KeepsFrontsOfWhatIsMirrored) {
  GltfModel model = one_triangle();
  model.document["nodes"] = {{{"mesh", 0}, {"scale", {-1, 1, 1}}}};
  EXPECT_EQ(facet_places(scene_of(model.text()), 0), (std::vector<Point3>{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}));
}

TEST(GltfScene, ReadsStripsFansAndIndicesOfAnySize) {
  GltfModel model;
  const std::size_t places = model.points({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 9, 9, 9});
  const std::size_t bytes = model.add<std::uint8_t>({0, 1, 2, 3}, 5121, "SCALAR", 1);
  const std::size_t shorts = model.add<std::uint16_t>({0, 1, 3, 2}, 5123, "SCALAR", 1);
  const std::size_t words = model.add<std::uint32_t>({0, 1, 2, 2, 1, 3}, 5125, "SCALAR", 1);
  const json attributes = {{"POSITION", places}};
  model.mesh({{"attributes", attributes}, {"indices", bytes}, {"mode", 5}});
  model.mesh({{"attributes", attributes}, {"indices", shorts}, {"mode", 6}});
  model.mesh({{"attributes", attributes}, {"indices", words}});
  model.mesh({{"attributes", attributes}, {"mode", 1}});
  for (int k = 0; k < 4; ++k) model.node({{"mesh", k}});
  const GltfScene scene = scene_of(model.text());
  ASSERT_EQ(scene.soup.facets.size(), 6U);
  for (std::size_t f = 0; f < 6; ++f) {
    const std::vector<Point3> p = facet_places(scene, f);
    EXPECT_EQ((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x), 1) << f;
  }
  EXPECT_THAT(scene.soup.doubts, ElementsAre(HasSubstr("points or lines (1)")));
}

TEST(GltfScene, ReadsInterleavedNumbers) {
  GltfModel model;
  const std::size_t places = model.points({7, 0, 0, 0, 7, 1, 0, 0, 7, 0, 1, 0});
  model.document["accessors"][places]["count"] = 3;
  model.document["accessors"][places]["byteOffset"] = 4;
  model.document["bufferViews"][0]["byteStride"] = 16;
  model.mesh({{"attributes", {{"POSITION", places}}}});
  model.node({{"mesh", 0}});
  EXPECT_EQ(facet_places(scene_of(model.text()), 0), (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(GltfScene, TakesWhatMaterialsEmitAndReflect) {
  GltfModel model = one_triangle();
  model.document["materials"] = {
      {{"name", "lamp"},
       {"emissiveFactor", {1, 0.5, 0}},
       {"doubleSided", true},
       {"emissiveTexture", {{"index", 0}}},
       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}}},
      {{"pbrMetallicRoughness",
        {{"baseColorFactor", {0.5, 1, 0, 1}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.5}}}}};
  model.document["meshes"][0]["primitives"][0]["material"] = 1;
  const GltfScene scene = scene_of(model.text());
  EXPECT_THAT(scene.soup.materials, ElementsAre("lamp", "material 1", ""));
  EXPECT_THAT(scene.soup.facet_materials, ElementsAre(1));
  EXPECT_EQ(scene.materials[0]->emission, (std::array<double, 3>{8, 4, 0}));
  EXPECT_TRUE(scene.materials[0]->emits_both_ways);
  EXPECT_EQ(scene.materials[1]->diffuse, (std::array<double, 3>{0.375, 0.75, 0}));
  EXPECT_EQ(scene.materials[1]->specular, (std::array<double, 3>{0.125, 0.25, 0}));
  EXPECT_EQ(scene.materials[1]->exponent, 30);
  EXPECT_FALSE(scene.materials[2]);
  EXPECT_THAT(scene.soup.doubts, ElementsAre(HasSubstr("textures of materials (1)")));
}

TEST(GltfScene, PlacesPunctualLights) {
  GltfModel model = one_triangle();
  model.document["extensionsRequired"] = {"KHR_lights_punctual"};
  model.document["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"name", "bulb"}, {"intensity", 4}, {"color", {1, 0.5, 0.25}}},
      {{"type", "directional"}},
      {{"type", "spot"}}};
  const auto with = [](int light, json node) {
    node["extensions"]["KHR_lights_punctual"]["light"] = light;
    return node;
  };
  model.document["nodes"].push_back(with(0, {{"translation", {1, 2, 3}}}));
  model.document["nodes"].push_back(with(1, {{"rotation", {1, 0, 0, 0}}}));
  model.document["nodes"].push_back(with(2, json::object()));
  const GltfScene scene = scene_of(model.text());
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].name, "bulb");
  EXPECT_EQ(scene.lights[0].place, (Point3{1, 2, 3}));
  EXPECT_EQ(scene.lights[0].intensity, (std::array<double, 3>{4, 2, 1}));
  EXPECT_TRUE(scene.lights[1].is_directional);
  EXPECT_EQ(scene.lights[1].place, (Point3{0, 0, 1}));  // -z, turned by half a turn about x
  EXPECT_THAT(scene.soup.doubts, ElementsAre(HasSubstr("spot lights (1)")));
}

TEST(GltfScene, LooksFromTheFirstCameraInPerspective) {
  GltfModel model = one_triangle();
  model.document["cameras"] = {{{"type", "orthographic"}, {"orthographic", json::object()}},
                               {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"aspectRatio", 2}}}}};
  // A quarter turn about y: -z of the node is -x.
  const double half = std::sqrt(0.5);
  model.document["nodes"].push_back({{"camera", 0}});
  model.document["nodes"].push_back({{"camera", 1}, {"translation", {5, 1, 2}}, {"rotation", {0, half, 0, half}}});
  const GltfScene scene = scene_of(model.text());
  ASSERT_TRUE(scene.camera);
  EXPECT_EQ(scene.camera->eye, (Point3{5, 1, 2}));
  EXPECT_NEAR(scene.camera->look_at.x, 4, 1e-15);
  EXPECT_NEAR(scene.camera->look_at.z, 2, 1e-15);
  EXPECT_EQ(scene.camera->up, (Point3{0, 1, 0}));
  EXPECT_NEAR(scene.camera->vertical_angle, 57.29577951308232, 1e-12);
  EXPECT_EQ(scene.camera->aspect, 2);
  EXPECT_THAT(scene.soup.doubts, ElementsAre(HasSubstr("cameras but the first one in perspective (1)")));
}

TEST(GltfScene, NamesWhatIsWrong) {
  struct Wrong {
    const char* pointer;
    json value;
    const char* told;
  };
  const Wrong all[] = {
      {"/asset/version", "1.0", "version"},
      {"/asset", json::array(), "asset"},
      {"/extensionsRequired", {"KHR_draco_mesh_compression"}, "KHR_draco_mesh_compression"},
      {"/nodes/0/mesh", 1, "/nodes/0/mesh"},
      {"/nodes/0/mesh", -1, "/nodes/0/mesh"},
      {"/nodes/0/mesh", 0.5, "/nodes/0/mesh"},
      {"/nodes/0/children", {0}, "all below others"},
      {"/scenes", {{{"nodes", {0, 0}}}}, "met twice"},
      {"/nodes/0/children", {7}, "index of a node"},
      {"/nodes/0/translation", {1, 2}, "an array of 3 numbers"},
      {"/nodes/0/matrix", {1.7e308, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1.7e308, 0, 0, 1}, "beyond doubles"},
      {"/nodes/0/matrix", {1}, "an array of 16 numbers"},
      {"/meshes/0/primitives/0/mode", 7, "mode"},
      {"/meshes/0/primitives/0/attributes", json::object(), "POSITION"},
      {"/meshes/0/primitives/0/material", 0, "index of a material"},
      {"/meshes/0/primitives/0/indices", 0, "another type"},
      {"/accessors/0/componentType", 5123, "another type"},
      {"/accessors/0/componentType", 7, "component type"},
      {"/accessors/0/type", "VEC4", "another type"},
      {"/accessors/0/count", 4, "beyond the end of the buffer view"},
      {"/accessors/0/byteOffset", 4, "beyond the end of the buffer view"},
      {"/accessors/0/byteOffset", 1e12, "beyond the end of the buffer view"},
      {"/accessors/0/sparse", json::object(), "sparse"},
      {"/accessors/0/bufferView", 9, "bufferViews"},
      {"/bufferViews/0/byteLength", 37, "beyond the end of the buffer"},
      {"/bufferViews/0/byteOffset", 1, "beyond the end of the buffer"},
      {"/bufferViews/0/buffer", 1, "index of a buffer"},
      {"/buffers/0/byteLength", 400, "as announced"},
      {"/buffers/0/uri", "data:,abc", "base64"},
      {"/buffers/0/uri", "data:x;base64,a*b", "base64"},
      {"/buffers/0/uri", "https://example.org/a.bin", "beside the glTF file"},
      {"/buffers/0/uri", "../a.bin", "beside the glTF file"},
      {"/buffers/0/uri", "%2e%2e/a.bin", "beside the glTF file"},
      {"/buffers/0/uri", "no_such.bin", "no such file"},
      {"/scene", 3, "scenes"},
      {"/materials", {{{"emissiveFactor", {-1, 0, 0}}}}, "negative emission"},
      {"/materials", {{{"pbrMetallicRoughness", {{"metallicFactor", 2}}}}}, "no share"},
      {"/materials", 5, "/materials"},
  };
  for (const Wrong& wrong : all) {
    json document = json::parse(one_triangle().text());
    document[json::json_pointer(wrong.pointer)] = wrong.value;
    EXPECT_THAT(gltf_refusal(document.dump()), HasSubstr(wrong.told)) << wrong.pointer << ' ' << wrong.value;
    EXPECT_THAT(gltf_refusal(document.dump()), HasSubstr(file_name)) << wrong.pointer;
  }
}

TEST(GltfScene, RefusesFilesThatAreCutOff) {
  const std::string whole = one_triangle().binary();
  EXPECT_EQ(gltf_refusal(whole), "nothing");
  for (std::size_t size = 0; size + 4 < whole.size(); ++size) {
    EXPECT_NE(gltf_refusal(whole.substr(0, size)), "nothing") << size;
  }
}

TEST(GltfScene, SurvivesAnyBytes) {
  constexpr unsigned seed = 5;
  std::mt19937 engine(seed);
  GltfModel model = one_triangle();
  model.document["materials"] = {{{"name", "a"}, {"emissiveFactor", {1, 1, 1}}}};
  std::size_t read = 0;
  for (const std::string& whole : {model.text(), model.binary()}) {
    for (int run = 0; run < 5000; ++run) {
      std::string bytes = whole;
      for (unsigned k = 0; k < 1 + engine() % 4; ++k) bytes[engine() % bytes.size()] = static_cast<char>(engine());
      read += gltf_refusal(bytes) == "nothing" ? 1 : 0;
    }
  }
  std::cout << read << " of 10000 mangled files were read (seed " << seed << ")\n";
  EXPECT_GT(read, 0U);
}

}  // namespace
}  // namespace gnomon
