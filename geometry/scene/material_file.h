#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace gnomon {

/// The materials of an MTL file that emit light: whose key Ke is followed by a number other than 0. Anything else in
/// the file is passed over, whatever it is.
std::set<std::string> emitting_materials(std::string_view text);

/// What an MTL file says of a material; none where it says nothing, or no finite numbers from 0 on.
struct FileMaterial {
  std::optional<std::array<double, 3>> emission, diffuse, specular;  ///< Ke, Kd, Ks
  std::optional<double> exponent;                                    ///< Ns
  bool emits_both_ways = false;                                      ///< facets emit from their backs, too
};

struct MaterialFile {
  std::map<std::string, FileMaterial> materials;
  std::map<std::string, std::size_t> passed_over;  ///< first words of lines that are not used, and how many
};

/// The materials of an MTL file. One number stands for three equal ones. Textures, transparency, ambient shares and all
/// other lines are passed over, and counted.
MaterialFile material_file(std::string_view text);

}  // namespace gnomon
