#include "sdf/includes/includes.hh"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "sdf/includes/include_overrides.hh"
#include "sdf/includes/model_config.hh"
#include "sdf/includes/model_document.hh"
#include "sdf/schema/default_elements.hh"
#include "sdf/schema/element_check.hh"
#include "sdf/text/file_text.hh"
#include "sdf/text/values.hh"
#include "sdf/upgrade.hh"
#include "sdf/version.hh"
#include "sdf/xacro/xacro.hh"

namespace pongsim::sdf {

namespace fs = std::filesystem;

namespace {

fs::path withoutLinks(const fs::path& path) {
  std::error_code error;
  fs::path plain = fs::canonical(path, error);
  return error ? path : plain;
}

void setFileName(Element& element, const std::shared_ptr<const std::string>& name) {
  element.position.file = name;
  for (Element::Attribute& attribute : element.attributes) attribute.position.file = name;
  for (Element& child : element.children) setFileName(child, name);
}

/// @return The part of a file that other files include, which may be an include itself; nothing, with an error, if
/// there is none.
std::optional<Element> contentOf(Element& root, Diagnostics& diagnostics) {
  constexpr std::array<std::string_view, 4> kKinds{"model", "light", "actor", "include"};
  const auto isContent = [&](const Element& child) { return std::ranges::find(kKinds, child.name) != kKinds.end(); };
  const auto content = std::ranges::find_if(root.children, isContent);
  if (content == root.children.end()) {
    diagnostics.error(root.position, "this file has no model, light or actor to include",
                      root.child("world") != nullptr ? "a world can't be included" : "");
    return std::nullopt;
  }
  const auto second = std::find_if(std::next(content), root.children.end(), isContent);
  if (second != root.children.end()) {
    diagnostics.warning(
        second->position,
        "<" + second->name + "> is ignored: only the first model, light or actor of a file is included");
  }
  return std::move(*content);
}

}  // namespace

Includes::Includes(assets::Finder finder, Diagnostics& diagnostics, Diagnostics& unsimulated)
    : finder_(std::move(finder)), diagnostics_(diagnostics), unsimulated_(unsimulated) {}

void Includes::begin(const fs::path& file) { open_.assign(1, withoutLinks(file)); }

bool Includes::follow(const Element& include, Context& context, const ReadIncluded& read) {
  const std::optional<fs::path> path = find(include, context);
  if (!path) return false;
  File& file = fileAt(*path, include.position);
  if (isRecursion(include, file) || !file.content || !isWithinBounds(include, file)) return false;

  Element content = *file.content;
  setFileName(content, newName(file.name, include.position));
  if (keepsReplacements_) makeAddressesAbsolute(content, file.context.folder);
  open_.push_back(file.path);
  bool isRead = true;
  if (content.name == "include") {
    joinOverrides(include, content);
    isRead = follow(content, file.context, read);
  } else {
    applyOverrides(include, content, context);
    read(content, file.context);
  }
  open_.pop_back();
  return isRead;
}

void Includes::modernize(Element& root, Context& context) {
  if (!isForPrint_) return upgrade(root, context);
  // the file itself comes first; what it includes is printed within it
  const int version = std::max(printedVersion_, upgradedVersion(context.version));
  if (printedVersion_ == 0) printedVersion_ = version;
  upgrade(root, context, RemovedUse::kKeep, version);
  addDefaultElements(root, version);
}

const std::vector<Element>& Includes::replace(const Element& include, std::vector<Element>& parts) {
  if (!keepsReplacements_) return parts;
  return replacements_[&include] = std::move(parts);
}

void Includes::resolve(Element& element) {
  std::vector<Element> children;
  for (Element& child : element.children) {
    const auto replacement = child.name == "include" ? replacements_.find(&child) : replacements_.end();
    if (replacement == replacements_.end()) {
      resolve(child);
      children.push_back(std::move(child));
      continue;
    }
    // swap, do not copy: includes among them are looked up by their addresses in memory
    Element holder;
    holder.children.swap(replacement->second);
    resolve(holder);
    std::ranges::move(holder.children, std::back_inserter(children));
  }
  element.children = std::move(children);
}

std::optional<fs::path> Includes::find(const Element& include, Context& context) {
  const Element* uri = include.child("uri");
  if (uri == nullptr || uri->text.empty()) {
    diagnostics_.error(include.position, "<include> has no <uri>", "write <uri>model://NAME</uri>");
    return std::nullopt;
  }
  const std::optional<fs::path> found = finder_(uri->text, context.folder, uri->position, diagnostics_);
  std::error_code ignored;
  if (!found || !fs::is_directory(*found, ignored)) return found;
  const auto known = modelFiles_.find(found->string());
  if (known != modelFiles_.end()) return known->second;
  const fs::path config = *found / "model.config";
  if (!fs::exists(config, ignored) || !finder_.mayRead(config, context.folder)) {
    diagnostics_.error(uri->position, "there is no model.config in '" + found->string() + "'",
                       "it names the SDF file in a model's folder; <uri> can also name the SDF file directly");
    return std::nullopt;
  }
  std::optional<fs::path> file = readModelConfig(config, newName(config, include.position), diagnostics_);
  if (file && !finder_.mayRead(*file, *found)) {
    diagnostics_.error(uri->position, "'" + config.string() + "' names a file that is not found");
    file.reset();
  }
  return modelFiles_[found->string()] = file;
}

Includes::File& Includes::fileAt(const fs::path& path, const SourcePosition& includedFrom) {
  std::unique_ptr<File>& file = files_[path.string()];
  if (file == nullptr) {
    Context context{
        .diagnostics = diagnostics_, .unsimulated = unsimulated_, .includes = *this, .folder = path.parent_path()};
    file = std::make_unique<File>(File{withoutLinks(path), path, 0, std::nullopt, std::move(context)});
    parse(path, newName(path, includedFrom), *file);
  }
  return *file;
}

void Includes::parse(const fs::path& path, const Name& name, File& file) {
  const std::optional<ExpandedText> text = readExpandedText(path, name, NamedBy::kContent, mayExpand(path), diagnostics_);
  if (!text) return;
  file.size = text->text.size();
  const bool isExpanded = text->name != name;
  file.name = isExpanded ? fs::path(*text->name) : path;
  const Name shown = isExpanded ? newName(file.name, includedFrom_.at(name)) : name;
  std::optional<ModelDocument> document = parseModelDocument(text->text, shown, diagnostics_);
  if (!document) return;
  Element& root = document->sdf;
  bring(root);
  file.context.urdf = std::move(document->urdf);
  file.context.version = readVersion(root, diagnostics_);
  checkElements(root, file.context);
  modernize(root, file.context);
  file.content = contentOf(root, diagnostics_);
}

bool Includes::isWithinBounds(const Element& include, const File& file) {
  const auto refuse = [&](std::string message) {
    diagnostics_.error(include.position, std::move(message));
    return false;
  };
  // only the first excess is reported
  if (count_ > kMostIncludes || size_ > kLargestFile) return false;
  ++count_;
  size_ += file.size;
  if (count_ > kMostIncludes) return refuse("there are more than " + std::to_string(kMostIncludes) + " includes");
  if (size_ > kLargestFile) {
    return refuse("the included files together are larger than " + std::to_string(kLargestFile >> 20U) +
                  " MiB, which is the limit");
  }
  if (open_.size() > kDeepestInclude) {
    return refuse("includes nest more than " + std::to_string(kDeepestInclude) + " deep");
  }
  return true;
}

bool Includes::isRecursion(const Element& include, const File& file) {
  const auto first = std::ranges::find(open_, file.path);
  if (first == open_.end()) return false;
  std::string message = "'" + first->string() + "' includes ";
  for (auto next = std::next(first); next != open_.end(); ++next) {
    message += "'" + next->string() + "', which includes ";
  }
  diagnostics_.error(include.position, message + (std::next(first) == open_.end() ? "itself" : "it again"));
  return true;
}

Includes::Name Includes::newName(const fs::path& path, const SourcePosition& includedFrom) {
  auto name = std::make_shared<const std::string>(path.string());
  includedFrom_.emplace(name, includedFrom);
  return name;
}

std::vector<SourcePosition> Includes::chainOf(const SourcePosition& position) const {
  std::vector<SourcePosition> chain;
  for (auto found = includedFrom_.find(position.file); found != includedFrom_.end();
       found = includedFrom_.find(chain.back().file)) {
    chain.push_back(found->second);
  }
  return chain;
}

bool Includes::enterModel(const SourcePosition& position) {
  if (modelDepth_ == kDeepestModel) {
    diagnostics_.error(position, "models nest more than " + std::to_string(kDeepestModel) + " deep");
    return false;
  }
  ++modelDepth_;
  return true;
}

}  // namespace pongsim::sdf
