#include <cstddef>
#include <cstdint>
#include <string_view>

#include "gnomon/scene.h"

/// One run of the fuzzer: any bytes must end in a scene or in a SceneError. Mesh files are looked for in a folder that
/// does not exist.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const gnomon::Scene scene =
        gnomon::parse_scene({reinterpret_cast<const char*>(data), size}, "fuzz.scene.json", "no_such_folder");
    gnomon::default_clip_box(scene);
  } catch (const gnomon::SceneError&) {
  }
  return 0;
}
