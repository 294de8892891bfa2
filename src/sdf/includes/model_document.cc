#include "sdf/includes/model_document.hh"

#include <utility>

#include "sdf/text/document.hh"
#include "urdf/converter.hh"

namespace pongsim::sdf {

std::optional<ModelDocument> parseModelDocument(std::string_view text, std::shared_ptr<const std::string> file,
                                                Diagnostics& diagnostics) {
  std::optional<Element> root = parseDocument(text, std::move(file), diagnostics);
  if (!root) return std::nullopt;
  if (root->name == "sdf") return ModelDocument{std::move(*root), nullptr};
  if (root->name != "robot") {
    diagnostics.error(root->position, "the file begins with <" + root->name + ">, not with <sdf> or <robot>");
    return std::nullopt;
  }
  std::optional<Element> sdf = urdf::toSdf(*root, diagnostics);
  if (!sdf) return std::nullopt;
  return ModelDocument{std::move(*sdf),
                       std::make_shared<const UrdfSource>(UrdfSource{std::string(text), std::move(*root)})};
}

}  // namespace pongsim::sdf
