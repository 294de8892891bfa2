// Arbitrary bytes as a mesh file; the first one selects the format. The readers must end and return a mesh with
// vertices for all its triangles, or a reason.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>

#include "assets/meshes/mesh_file.hh"
#include "assets/meshes/mesh_look.hh"
#include "require.hh"
#include "support/temp_folder.hh"

namespace {

using pongsim::assets::Problem;
using pongsim::fuzz::require;

void read(const std::filesystem::path& file) {
  const auto found = pongsim::assets::readMeshFile(file);
  if (const auto* problem = std::get_if<Problem>(&found)) return require(!problem->text.empty());
  for (const auto& part : std::get<0>(found)) {
    for (const auto& triangle : part.mesh.triangles) {
      for (const std::uint32_t corner : triangle) require(corner < part.mesh.vertices.size());
    }
  }
}

void readLook(const std::filesystem::path& file) {
  const auto found = pongsim::assets::readMeshLook(file, {}, false);
  if (const auto* problem = std::get_if<Problem>(&found)) return require(!problem->text.empty());
  for (const auto& part : std::get<0>(found)) {
    require(part.triangles.size() % 3 == 0);
    for (const std::uint32_t corner : part.triangles) require(corner < part.corners.size());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const pongsim::test::TempFolder folder;
  constexpr std::array<const char*, 5> kNames{"mesh.dae", "mesh.stl", "mesh.obj", "mesh.glb", "mesh.gltf"};
  const auto file = folder.write(kNames[data[0] % kNames.size()],
                                 std::string_view(reinterpret_cast<const char*>(data), size).substr(1));
  read(file);
  readLook(file);
  return 0;
}
