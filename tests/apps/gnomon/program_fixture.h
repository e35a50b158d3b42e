#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gnomon {

/// What a run of the program left.
struct Outcome {
  int code = -1;    ///< exit code; 128 + n if signal n ended it
  std::string out;  ///< stdout
  std::string err;  ///< stderr
};

/// Runs the built program in a folder of its own, where the examples of the project lie in `examples`.
class Program : public ::testing::Test {
 protected:
  /// Whether the program finds the display that the tests run on.
  enum class Display { hidden, shown };

  explicit Program(Display display = Display::hidden);
  ~Program() override;

  /// Runs `gnomon` with arguments as a POSIX shell reads them; redirections are allowed.
  Outcome gnomon(const std::string& arguments) const;

  /// Runs a shell command in which $GNOMON is the program.
  Outcome shell(const std::string& command) const;

  void write(const std::string& file, const std::string& text) const;
  std::string read(const std::string& file) const;
  nlohmann::json read_json(const std::string& file) const;
  std::string path_of(const std::string& file) const { return (folder_ / "run" / file).string(); }
  bool exists(const std::string& file) const { return std::filesystem::exists(folder_ / "run" / file); }

  /// Everything in a folder, hidden files too, sorted.
  std::vector<std::string> names_in(const std::string& folder) const;

 private:
  Display display_;
  std::filesystem::path folder_;
};

std::vector<std::string> lines(const std::string& text);

/// The commands that the program's help lists.
std::vector<std::string> commands_of(const std::string& help);

/// The long options that a help text describes, with their dashes.
std::vector<std::string> options_of(const std::string& help);

/// The lines "  gnomon ..." that follow "Examples:" in a help text, without the program's name.
std::vector<std::string> examples_of(const std::string& help);

/// A lamp of side 2 at height 4 above an aligned table of side 4 at height 2. Below the table the half width grows by
/// 3/2 of the depth for the occlusion and by 1/2 for the umbra.
inline const std::string table_scene = R"({
  "gnomon": 1, "dimension": 3,
  "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4]]}],
  "blockers": [{"name": "table", "shape": "polygon", "vertices": [[-2,-2,2], [2,-2,2], [2,2,2], [-2,2,2]]}]
})";

/// The same with more: a wall that the lamp crosses, a solid, and a sun.
inline const std::string mixed_scene = R"({
  "gnomon": 1, "dimension": 3,
  "lights": [
    {"name": "lamp", "shape": "polygon", "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4]]},
    {"name": "sun", "shape": "direction", "direction": [0,0,-1]}],
  "blockers": [
    {"name": "table", "shape": "polygon", "vertices": [[-2,-2,2], [2,-2,2], [2,2,2], [-2,2,2]]},
    {"name": "wall", "shape": "polygon", "vertices": [[0,5,0], [0,6,0], [0,6,3], [0,5,3]]},
    {"name": "post", "shape": "polytope", "vertices": [[5,0,0], [6,0,0], [5,1,0], [5,0,2]]}]
})";

/// A lamp whose vertices are not exactly coplanar: the table in front of it is supported, the shelf beside it is not.
inline const std::string bent_lamp_scene = R"({
  "gnomon": 1, "dimension": 3,
  "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4.000000000001]]}],
  "blockers": [
    {"name": "table", "shape": "polygon", "vertices": [[-2,-2,2], [2,-2,2], [2,2,2], [-2,2,2]]},
    {"name": "shelf", "shape": "polygon", "vertices": [[2,-1,3], [2,1,3], [2,1,5], [2,-1,5]]}]
})";

/// Nothing in it is supported.
inline const std::string bent_shelf_scene = R"({
  "gnomon": 1, "dimension": 3,
  "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4.000000000001]]}],
  "blockers": [{"name": "shelf", "shape": "polygon", "vertices": [[2,-1,3], [2,1,3], [2,1,5], [2,-1,5]]}]
})";

}  // namespace gnomon
