#include "sdf/model_document.hh"

#include <utility>

#include "sdf/document.hh"
#include "urdf/converter.hh"

namespace pongsim::sdf {

std::optional<Element> parseModelDocument(std::string_view text, std::shared_ptr<const std::string> file,
                                          Diagnostics& diagnostics) {
  std::optional<Element> root = parseDocument(text, std::move(file), diagnostics);
  if (!root || root->name == "sdf") return root;
  if (root->name == "robot") return urdf::toSdf(*root, diagnostics);
  diagnostics.error(root->position, "the file begins with <" + root->name + ">, not with <sdf> or <robot>");
  return std::nullopt;
}

}  // namespace pongsim::sdf
