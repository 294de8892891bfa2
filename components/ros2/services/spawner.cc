#include "ros2/services/spawner.hh"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "ros2/node/names.hh"

namespace pongsim::ros2 {

namespace si = simulation_interfaces;
using si::SpawnResult;

namespace {

/// @return "FILE:1:2: ERROR (HINT)", in one line.
std::string lineOf(const Diagnostic& diagnostic) {
  const SourcePosition& position = diagnostic.position;
  std::string line;
  if (position.file) line = *position.file + ":";
  if (position.line > 0) line += std::to_string(position.line) + ":" + std::to_string(position.column) + ":";
  if (!line.empty()) line += " ";
  return line + diagnostic.message + (diagnostic.hint.empty() ? "" : " (" + diagnostic.hint + ")");
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

bool isMissingFile(const Diagnostic& diagnostic) {
  return has(diagnostic.message, "' is not found") || has(diagnostic.message, "is not in the local Fuel cache") ||
         has(diagnostic.message, "there is no Fuel cache");
}

bool isUnusableFile(const Diagnostic& diagnostic) {
  return has(diagnostic.message, "can't be read as ") || has(diagnostic.message, "is not a supported kind of address");
}

/// @return The result code for an error in reading.
std::uint8_t codeOf(const Diagnostic& error) {
  if (isMissingFile(error)) return SpawnResult::kMissingAssets;
  if (isUnusableFile(error)) return SpawnResult::kUnsupportedAssets;
  if (has(error.message, "begins with <")) return SpawnResult::kUnsupportedFormat;
  return SpawnResult::kResourceParseError;
}

/// @return Whether the extension is that of an unsupported robot or scene format.
bool isOtherFormat(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 8> kOthers{".usd",  ".usda", ".usdc",  ".usdz",
                                                    ".mjcf", ".wbt",  ".proto", ".glb"};
  return std::ranges::find(kOthers, file.extension().string()) != kOthers.end();
}

}  // namespace

std::optional<std::string> entityNameError(const std::string& name) {
  if (has(name, "::")) return "contains '::', which separates names";
  if (name == "world") return "is the world's frame";
  if (name.starts_with("__") && name.ends_with("__")) return "is reserved by SDF";
  const auto isControl = [](char letter) { return static_cast<unsigned char>(letter) < ' ' || letter == '\x7f'; };
  if (std::ranges::any_of(name, isControl)) return "has a control character";
  if (name.size() > 1000) return "is longer than 1000 bytes";
  return std::nullopt;
}

std::optional<std::string> nameSpaceError(const std::string& nameSpace) {
  return rosNameError(absoluteName("/", nameSpace));
}

void Spawner::spawn(const si::SpawnEntity& request, Spawned spawned) {
  const auto refuse = [&spawned](std::uint8_t code, std::string why) { spawned({refused(code, std::move(why)), {}}); };
  if (const auto error = entityNameError(request.name)) {
    return refuse(SpawnResult::kNameInvalid, "the name '" + request.name.substr(0, 100) + "' " + *error);
  }
  if (const auto error = request.entity_namespace.empty() ? std::nullopt : nameSpaceError(request.entity_namespace)) {
    return refuse(SpawnResult::kNamespaceInvalid,
                  "the namespace '" + request.entity_namespace.substr(0, 100) + "' " + *error);
  }
  if (const auto error = poseError(request.initial_pose.pose)) return refuse(SpawnResult::kInvalidPose, *error);
  Outcome<MovingFrame> frame = finder_.frame(request.initial_pose.header.frame_id);
  if (!frame) return refuse(SpawnResult::kInvalidPose, frame.error);

  Result result;
  const std::optional<ModelTemplate> model = read(request.entity_resource, result);
  if (!model) return spawned({result, {}});
  const std::string& name = request.name.empty() ? model->name() : request.name;
  if (name.empty()) return refuse(SpawnResult::kNameInvalid, "neither the request nor the resource contains a name");
  if (const auto error = entityNameError(name)) {
    return refuse(SpawnResult::kNameInvalid, "the resource's name '" + name.substr(0, 100) + "' " + *error);
  }
  insert(*model,
         {.name = name,
          .pose = frame->pose * poseOf(request.initial_pose.pose),
          .allowRenaming = request.allow_renaming,
          .nameSpace = request.entity_namespace.empty() ? "" : absoluteName("/", request.entity_namespace)},
         std::move(spawned));
}

std::optional<ModelTemplate> Spawner::read(const si::Resource& resource, Result& result) const {
  if (resource.uri.empty() && resource.resource_string.empty()) {
    result = refused(SpawnResult::kNoResource, "both uri and resource_string are empty");
    return std::nullopt;
  }
  if (resource.uri.empty() && resource.resource_string.size() > kLongestResource) {
    result = refused(SpawnResult::kResourceParseError,
                     "resource_string is " + std::to_string(resource.resource_string.size()) + " bytes long; up to " +
                         std::to_string(kLongestResource) + " are allowed");
    return std::nullopt;
  }
  Diagnostics diagnostics;
  std::optional<ModelTemplate> model;
  try {
    model = resource.uri.empty() ? edits_.readText(resource.resource_string, "resource_string", diagnostics)
                                 : readAddress(resource.uri, diagnostics, result);
  } catch (const Error& error) {
    result = refused(codeOf(error.diagnostic()), lineOf(error.diagnostic()));
    return std::nullopt;
  }
  // something missing, which is otherwise only a warning, is a reason not to insert it
  for (const Diagnostic& warning : diagnostics.all()) {
    if (!isMissingFile(warning) && !isUnusableFile(warning)) continue;
    result = refused(codeOf(warning), lineOf(warning));
    return std::nullopt;
  }
  return model;
}

std::optional<ModelTemplate> Spawner::readAddress(const std::string& uri, Diagnostics& diagnostics,
                                                  Result& result) const {
  const std::optional<std::filesystem::path> found = edits_.resolve(uri);
  // the same whether it is there or not
  if (!found || !edits_.isInReach(*found)) {
    result = notFound("there is no '" + uri.substr(0, 1000) + "'");
    return std::nullopt;
  }
  if (isOtherFormat(*found)) {
    result = refused(SpawnResult::kUnsupportedFormat, "'" + uri + "' is neither SDF nor URDF");
    return std::nullopt;
  }
  return edits_.readFile(*found, diagnostics);
}

void Spawner::insert(const ModelTemplate& model, const InsertOptions& options, Spawned spawned) {
  const auto answer = std::make_shared<Spawned>(std::move(spawned));
  const std::uint64_t owed = owed_.owe([answer] {
    (*answer)({failed("the world was reset before the entity was spawned"), {}});
  });
  InsertOptions fromOutside = options;
  fromOutside.isFromOutside = true;
  edits_.insert(model, fromOutside, [this, answer, owed, name = options.name](const Outcome<Model>& inserted) {
    if (!owed_.settle(owed)) return;
    if (inserted.value) return (*answer)({succeeded(), std::string(inserted.value->name())});
    const bool isTaken = !finder_.world().isNameFree(name);
    (*answer)({refused(isTaken ? SpawnResult::kNameNotUnique : Result::kResultOperationFailed, inserted.error), {}});
  });
}

void Spawner::remove(const std::string& name, std::function<void(const Result&)> done) {
  Outcome<Model> model = finder_.find(name);
  if (!model) return done(notFound(model.error));
  if (const auto parent = model->parent()) {
    return done(failed("'" + name + "' is part of '" + parent->scopedName() + "' and can't be removed alone"));
  }
  remove(*model, std::move(done));
}

void Spawner::remove(const Model& model, std::function<void(const Result&)> done) {
  const auto answer = std::make_shared<std::function<void(const Result&)>>(std::move(done));
  const std::uint64_t owed =
      owed_.owe([answer] { (*answer)(failed("the world was reset before the entity was deleted")); });
  edits_.remove(model, [this, answer, owed](const Outcome<void>& removed) {
    if (owed_.settle(owed)) (*answer)(removed ? succeeded() : failed(removed.error));
  });
}

void Spawner::removeInserted(std::function<void(const Result&)> done) {
  std::vector<Model> inserted = finder_.world().models();
  std::erase_if(inserted, [](const Model& model) { return !model.isInserted(); });
  if (inserted.empty()) return done(succeeded());
  struct Count {
    std::size_t left;
    Result result = succeeded();
  };
  const auto count = std::make_shared<Count>(Count{inserted.size()});
  for (const Model& model : inserted) {
    remove(model, [count, done](const Result& result) {
      if (!isOk(result)) count->result = result;
      if (--count->left == 0) done(count->result);
    });
  }
}

}  // namespace pongsim::ros2
