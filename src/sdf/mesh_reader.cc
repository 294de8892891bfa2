#include "sdf/mesh_reader.hh"

#include <utility>
#include <variant>

#include "sdf/includes.hh"
#include "sdf/values.hh"

namespace pongsim::sdf {

namespace {

/// Where the mesh's file is; empty, and a warning added, where it is not there.
std::filesystem::path findFile(const Element& uri, const std::string& effect, Context& context) {
  Diagnostics found;
  const auto file = context.includes.findAsset(uri.text, context.folder, uri.position, found);
  for (const Diagnostic& diagnostic : found.all()) {
    context.diagnostics.warning(diagnostic.position, "mesh " + diagnostic.message + effect, diagnostic.hint);
  }
  return file.value_or(std::filesystem::path());
}

void readSubmesh(const Element& element, description::Mesh& mesh, Context& context) {
  const Element* submesh = element.child("submesh");
  if (submesh == nullptr) return;
  mesh.submesh = childText(*submesh, "name");
  mesh.isCentered = readFlag(*submesh, "center", mesh.isCentered, context);
  if (mesh.submesh.empty()) {
    context.diagnostics.warning(submesh->position, "<submesh> has no <name>: the whole mesh is taken");
  }
}

}  // namespace

description::Mesh readMesh(const Element& element, const std::string& owner, bool isCollision, Context& context) {
  description::Mesh mesh;
  mesh.scale = readVector(element, "scale", mesh.scale, context);
  if (mesh.scale.cwiseAbs().minCoeff() == 0) {
    context.diagnostics.error(element.child("scale")->position, "the mesh of " + owner + " has a scale of zero");
  }
  readSubmesh(element, mesh, context);
  const Element* uri = element.child("uri");
  if (uri == nullptr || uri->text.empty()) {
    context.diagnostics.error(element.position, "the mesh of " + owner + " has no <uri>",
                              "write <uri>model://NAME/FILE</uri>");
    return mesh;
  }
  mesh.uri = uri->text;
  const std::string effect = ": " + owner + (isCollision ? " will not collide" : " will not be seen");
  mesh.file = findFile(*uri, effect, context);
  if (mesh.file.empty() || !isCollision) return mesh;

  const assets::MeshStore::Found found = context.includes.meshes().find(mesh.file, mesh.submesh, mesh.isCentered);
  if (const auto* problem = std::get_if<assets::MeshProblem>(&found)) {
    context.diagnostics.warning(uri->position, "mesh '" + mesh.file.string() + "' " + problem->text + effect,
                                problem->hint);
  } else {
    mesh.triangles = std::get<0>(found);
  }
  return mesh;
}

}  // namespace pongsim::sdf
