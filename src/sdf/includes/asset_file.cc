#include "sdf/includes/asset_file.hh"

#include <optional>

#include "sdf/includes/includes.hh"

namespace pongsim::sdf {

namespace {

/// @return An address as messages about the scene have it. Of a file that is not found, one from outside has none: the
/// web server gives out the files that a scene names.
std::string uriOf(const std::string& uri, bool isFound, const Context& context) {
  return isFound || context.includes.mayWrite(context.folder) ? uri : std::string();
}

}  // namespace

void AssetFile::warn(const assets::Problem& problem, Context& context) const {
  context.diagnostics.warning(position, kind + " '" + path.string() + "' " + problem.text + effect, problem.hint);
}

AssetFile findAsset(const Element& shape, const std::string& kind, const std::string& owner, bool isCollision,
                    Context& context) {
  const std::string effect = ": " + owner + (isCollision ? " will not collide" : " will not be seen");
  const Element* uri = shape.child("uri");
  if (uri == nullptr || uri->text.empty()) {
    context.diagnostics.error(shape.position, "the " + kind + " of " + owner + " has no <uri>",
                              "write <uri>model://NAME/FILE</uri>");
    return {{}, {}, kind, shape.position, effect};
  }
  Diagnostics found;
  const std::optional<std::filesystem::path> path =
      context.includes.findAsset(uri->text, context.folder, uri->position, found);
  for (const Diagnostic& diagnostic : found.all()) {
    context.diagnostics.warning(diagnostic.position, kind + ' ' + diagnostic.message + effect, diagnostic.hint);
  }
  return {uriOf(uri->text, path.has_value(), context), path.value_or(std::filesystem::path()), kind, uri->position,
          effect};
}

description::Texture readTexture(const Element& parent, std::string_view child, Context& context) {
  description::Texture texture;
  const Element* element = parent.child(child);
  if (element == nullptr || element->text.empty()) return texture;
  texture.uri = element->text;
  Diagnostics found;
  texture.file = context.includes.findAsset(texture.uri, context.folder, element->position, found)
                     .value_or(std::filesystem::path());
  if (texture.file.empty() && context.firstTime("missing file " + texture.uri)) {
    for (const Diagnostic& diagnostic : found.all()) {
      context.diagnostics.warning(diagnostic.position, "<" + element->name + "> " + diagnostic.message,
                                  diagnostic.hint);
    }
  }
  texture.uri = uriOf(texture.uri, !texture.file.empty(), context);
  return texture;
}

}  // namespace pongsim::sdf
