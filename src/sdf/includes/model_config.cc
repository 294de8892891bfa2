#include "sdf/includes/model_config.hh"

#include "sdf/text/document.hh"
#include "sdf/text/file_text.hh"
#include "sdf/version.hh"

namespace pongsim::sdf {

std::optional<std::filesystem::path> readModelConfig(const std::filesystem::path& file,
                                                     const std::shared_ptr<const std::string>& name,
                                                     Diagnostics& diagnostics) {
  const std::optional<std::string> text = readFileText(file, name, NamedBy::kContent, diagnostics);
  if (!text) return std::nullopt;
  const std::optional<Element> root = parseDocument(*text, name, diagnostics);
  if (!root) return std::nullopt;

  // Fortress's choice, so that a model is the same there; if it can read none of the files, the newest one
  const auto rank = [](int version) {
    if (version > kNewestVersion) return -1;
    return version <= kFortressVersion ? kNewestVersion + version : version;
  };
  const Element* best = nullptr;
  int bestRank = -1;
  for (const Element& child : root->children) {
    if (child.name != "sdf" || child.text.empty()) continue;
    const int version = parseVersion(child.attributeOr("version", "")).value_or(0);
    if (best != nullptr && rank(version) <= bestRank) continue;
    best = &child;
    bestRank = rank(version);
  }
  if (best == nullptr) {
    diagnostics.error(root->position, "the model has no <sdf>", "write <sdf version=\"1.9\">model.sdf</sdf>");
    return std::nullopt;
  }
  return file.parent_path() / best->text;
}

}  // namespace pongsim::sdf
