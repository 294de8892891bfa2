#include "assets/meshes/mesh_store.hh"

#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest_word.hh"

namespace pongsim::assets {

namespace {

using description::TriangleMesh;

void append(const TriangleMesh& part, TriangleMesh& whole) {
  const auto first = static_cast<std::uint32_t>(whole.vertices.size());
  whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
  for (const auto& [a, b, c] : part.triangles) whole.triangles.push_back({first + a, first + b, first + c});
}

void center(TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
  for (Vector3& vertex : mesh.vertices) vertex -= box.center();
}

Problem unknownPart(const std::vector<MeshPart>& parts, const std::string& name) {
  std::vector<std::string_view> known;
  for (const MeshPart& part : parts) {
    known.push_back(part.nodeName);
    known.push_back(part.meshName);
  }
  return {"has no submesh '" + name + "'", base::didYouMean(name, known)};
}

MeshStore::Result select(const std::vector<MeshPart>& parts, const std::string& submesh, bool isCentered) {
  auto mesh = std::make_shared<TriangleMesh>();
  for (const MeshPart& part : parts) {
    if (submesh.empty() || part.nodeName == submesh || part.meshName == submesh) append(part.mesh, *mesh);
  }
  if (mesh->triangles.empty()) return unknownPart(parts, submesh);
  if (isCentered && !submesh.empty()) center(*mesh);
  return mesh;
}

}  // namespace

MeshStore::Result MeshStore::find(const std::filesystem::path& file, const std::string& submesh, bool isCentered) {
  const auto key = std::tuple(file, submesh, isCentered);
  if (const auto known = meshes_.find(key); known != meshes_.end()) return known->second;
  auto parts = files_.find(file);
  if (parts == files_.end()) parts = files_.emplace(file, readMeshFile(file)).first;
  const auto* problem = std::get_if<Problem>(&parts->second);
  Result found = problem != nullptr ? Result(*problem) : select(std::get<0>(parts->second), submesh, isCentered);
  return meshes_.emplace(key, std::move(found)).first->second;
}

}  // namespace pongsim::assets
