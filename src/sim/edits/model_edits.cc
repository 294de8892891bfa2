#include "sim/edits/model_edits.hh"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "sdf/includes/model_config.hh"
#include "sim/edits/editor.hh"
#include "sim/edits/light_edits.hh"
#include "sim/system_set.hh"

namespace pongsim::sim {

namespace {

/// @return The first model in the file, with warnings about its unsupported elements; null on errors.
std::shared_ptr<description::Model> firstModel(sdf::Root root, Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : root.unsimulated.all()) diagnostics.add(diagnostic);
  if (diagnostics.hasErrors()) return nullptr;
  if (root.models.empty()) {
    diagnostics.error({}, "there is no model to insert", "put it directly in <sdf>");
    return nullptr;
  }
  auto model = std::make_shared<description::Model>(std::move(root.models.front()));
  for (std::size_t i = 1; i < root.models.size(); ++i) {
    diagnostics.warning(root.models[i].position, "model '" + root.models[i].name + "' is left out: the first model, '" +
                                                     model->name + "', is inserted");
  }
  return model;
}

void addAll(const Diagnostics& found, Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : found.all()) diagnostics.add(diagnostic);
}

}  // namespace

ModelEdits::ModelEdits(Access& access, const assets::Places& places, const std::filesystem::path& worldFile)
    : access_(access), places_(places), reach_{places.folders, {}} {
  reach_.folders.insert(reach_.folders.end(), places.installed.begin(), places.installed.end());
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(worldFile, ignored)) return;
  reach_.world = std::filesystem::absolute(worldFile, ignored).parent_path();
}

assets::Finder ModelEdits::finder(bool isFromOutside) const {
  assets::Finder finder = assets::finderIn(places_);
  return isFromOutside ? finder.confinedTo(reach_) : finder;
}

std::optional<std::filesystem::path> ModelEdits::modelFile(const std::filesystem::path& file, bool isFromOutside,
                                                           Diagnostics& diagnostics) const {
  const auto isReadable = [&](const std::filesystem::path& each) {
    std::error_code ignored;
    return !isFromOutside || (std::filesystem::exists(each, ignored) && isInReach(each));
  };
  const auto refuse = [&](const std::filesystem::path& each) {
    // the same message whether the file exists or not, so that a request can't probe for files
    diagnostics.error({}, "'" + each.string() + "' is not found",
                      "requests find only files in the world's folder, in those of PONGSIM_RESOURCE_PATH and in the "
                      "Fuel cache");
    return std::nullopt;
  };
  if (!isReadable(file)) return refuse(file);
  std::error_code ignored;
  if (!std::filesystem::is_directory(file, ignored)) return file;
  const std::filesystem::path config = file / "model.config";
  if (!isReadable(config)) return refuse(config);
  std::optional<std::filesystem::path> named =
      sdf::readModelConfig(config, std::make_shared<const std::string>(config.string()), diagnostics);
  if (named && !isReadable(*named)) return refuse(*named);
  return named;
}

// Each function judges only the diagnostics of its own reading: earlier errors do not prevent an insertion.

std::optional<Model> ModelEdits::insertFile(const std::filesystem::path& file, const InsertOptions& options,
                                            Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<Model> model;
  if (const std::shared_ptr<description::Model> read = readFirst(file, options.isFromOutside, found))
    model = insertOwned(read, options, found);
  addAll(found, diagnostics);
  return model;
}

std::optional<Model> ModelEdits::insertText(std::string_view text, std::string_view name, const InsertOptions& options,
                                            Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<Model> model =
      insertFirst(sdf::loadText(text, name, found, finder(options.isFromOutside)), options, found);
  addAll(found, diagnostics);
  return model;
}

std::optional<ModelOrLight> ModelEdits::insertModelOrLight(const std::filesystem::path& file,
                                                           const InsertOptions& options, Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<ModelOrLight> inserted;
  if (const std::optional<std::filesystem::path> path = modelFile(file, options.isFromOutside, found)) {
    sdf::Root root = sdf::loadFile(*path, found, finder(options.isFromOutside), sdf::NamedBy::kContent);
    inserted = insertFirstOf(std::move(root), options, found);
  }
  addAll(found, diagnostics);
  return inserted;
}

std::optional<ModelOrLight> ModelEdits::insertModelOrLight(std::string_view text, std::string_view name,
                                                           const InsertOptions& options, Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<ModelOrLight> inserted =
      insertFirstOf(sdf::loadText(text, name, found, finder(options.isFromOutside)), options, found);
  addAll(found, diagnostics);
  return inserted;
}

std::optional<ModelOrLight> ModelEdits::insertFirstOf(sdf::Root root, const InsertOptions& options,
                                                      Diagnostics& found) {
  if (root.models.empty() && !found.hasErrors()) {
    if (!root.lights.empty()) return insertFirstLight(root, options, found);
    found.error({}, "there is no model or light to insert",
                root.actors.empty() ? "put it directly in <sdf>" : "actors can only be loaded with a world");
    return std::nullopt;
  }
  if (std::optional<Model> model = insertFirst(std::move(root), options, found)) return *model;
  return std::nullopt;
}

std::optional<ModelOrLight> ModelEdits::insertFirstLight(const sdf::Root& root, const InsertOptions& options,
                                                         Diagnostics& diagnostics) {
  const description::Light& light = root.lights.front();
  for (std::size_t i = 1; i < root.lights.size(); ++i) {
    diagnostics.warning(root.lights[i].position, "light '" + root.lights[i].name + "' is left out: the first light, '" +
                                                     light.name + "', is inserted");
  }
  addAll(root.unsimulated, diagnostics);
  Outcome<std::string> name = insertLight(access_, light, options);
  if (!name) {
    diagnostics.error(light.position, name.error);
    return std::nullopt;
  }
  announceChanges();
  return *name;
}

std::optional<Model> ModelEdits::insertCopy(ModelId original, const InsertOptions& options, Diagnostics& diagnostics) {
  const world::Slot slot = access_.entities.slot(original);
  if (slot == world::kNoSlot) {
    diagnostics.error({}, "the model no longer exists");
    return std::nullopt;
  }
  const world::ModelRecord& record = access_.entities.models()[slot];
  if (record.parent != world::kNoSlot) {
    diagnostics.error({}, "model '" + record.scopedName + "' is part of another model");
    return std::nullopt;
  }
  InsertOptions placed = options;
  if (!placed.pose) placed.pose = world::modelPose(access_.entities, access_.state, slot);
  return insert(*record.description, placed, diagnostics);
}

std::optional<Model> ModelEdits::insert(const description::Model& model, const InsertOptions& options,
                                        Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<Model> inserted = insertOwned(std::make_shared<description::Model>(model), options, found);
  addAll(found, diagnostics);
  return inserted;
}

std::shared_ptr<description::Model> ModelEdits::readFirst(const std::filesystem::path& file, bool isFromOutside,
                                                          Diagnostics& diagnostics) const {
  const std::optional<std::filesystem::path> found = modelFile(file, isFromOutside, diagnostics);
  if (!found) return nullptr;
  return firstModel(sdf::loadFile(*found, diagnostics, finder(isFromOutside), sdf::NamedBy::kContent), diagnostics);
}

std::optional<Model> ModelEdits::insertFirst(sdf::Root root, const InsertOptions& options, Diagnostics& diagnostics) {
  std::shared_ptr<description::Model> model = firstModel(std::move(root), diagnostics);
  if (!model) return std::nullopt;
  return insertOwned(std::move(model), options, diagnostics);
}

std::optional<Model> ModelEdits::insertOwned(std::shared_ptr<description::Model> model, const InsertOptions& options,
                                             Diagnostics& diagnostics) {
  if (!options.name.empty()) model->name = options.name;
  if (options.pose) model->X_ParentModel = *options.pose;
  if (!options.nameSpace.empty()) model->nameSpace = options.nameSpace;
  Editor editor(access_);
  if (options.allowRenaming) model->name = editor.freeName(model->name);
  const SourcePosition position = model->position;
  if (!editor.isFree(model->name)) {
    diagnostics.error(position, "there is a '" + model->name + "' in the world already");
  } else if (model->name.find("::") != std::string::npos) {
    diagnostics.error(position, "the name '" + model->name + "' contains '::', which separates names");
  } else if (const char* fault = poseFault(model->X_ParentModel)) {
    diagnostics.error(position, "the pose of '" + model->name + "' " + fault);
  } else if (const auto error = topicNameError(model->nameSpace); error && !model->nameSpace.empty()) {
    diagnostics.error(position, "the namespace '" + model->nameSpace + "' " + *error);
  }
  if (diagnostics.hasErrors()) return std::nullopt;
  model->X_ParentModel.rotation.normalize();

  world::Slot slot = world::kNoSlot;
  try {
    slot = editor.insert(std::move(model));
  } catch (const std::invalid_argument& error) {
    diagnostics.error(position, error.what());
    return std::nullopt;
  }
  const Model inserted = World(access_).model(access_.entities.models()[slot].id).value();
  const auto removeAgain = [&] {
    systems_->unload(editor.remove({slot}));
    access_.hasChanged = false;
  };
  try {
    if (systems_ != nullptr) systems_->load(slot, options.isFromOutside, diagnostics);
  } catch (...) {
    removeAgain();
    throw;
  }
  if (diagnostics.hasErrors()) {
    removeAgain();
    return std::nullopt;
  }
  announceChanges();
  return inserted;
}

ModelId ModelEdits::topLevel(ModelId model) const {
  world::Slot slot = access_.entities.slot(model);
  if (slot == world::kNoSlot) return {};
  const std::vector<world::ModelRecord>& models = access_.entities.models();
  while (models[slot].parent != world::kNoSlot) slot = models[slot].parent;
  return models[slot].id;
}

Outcome<void> ModelEdits::mayRemove(ModelId model) const {
  const world::Slot slot = access_.entities.slot(model);
  if (slot == world::kNoSlot) return {std::string(kNoLongerThere)};
  const world::ModelRecord& record = access_.entities.models()[slot];
  if (record.parent != world::kNoSlot) {
    return {"model '" + record.scopedName + "' is part of '" + access_.entities.models()[record.parent].scopedName +
            "' and can't be removed alone"};
  }
  return {};
}

Outcome<void> ModelEdits::remove(std::span<const ModelId> models) {
  std::vector<world::Slot> slots;
  for (const ModelId model : models) {
    if (Outcome<void> removable = mayRemove(model); !removable) return removable;
    slots.push_back(access_.entities.slot(model));
  }
  if (slots.empty()) return {};
  std::ranges::sort(slots);
  const auto repeated = std::ranges::unique(slots);
  slots.erase(repeated.begin(), repeated.end());
  const std::vector<ModelId> gone = Editor(access_).remove(slots);
  if (systems_ != nullptr) systems_->unload(gone);
  announceChanges();
  return {};
}

std::shared_ptr<const description::Model> ModelEdits::read(const Element& sdf, bool isFromOutside,
                                                           Diagnostics& diagnostics) const {
  Diagnostics found;
  std::shared_ptr<const description::Model> model =
      firstModel(sdf::loadElement(sdf, found, finder(isFromOutside)), found);
  addAll(found, diagnostics);
  return model;
}

std::shared_ptr<const description::Model> ModelEdits::readFile(const std::filesystem::path& file,
                                                               Diagnostics& diagnostics) const {
  Diagnostics found;
  std::shared_ptr<const description::Model> model = readFirst(file, true, found);
  addAll(found, diagnostics);
  return model;
}

std::shared_ptr<const description::Model> ModelEdits::readText(std::string_view text, std::string_view name,
                                                               Diagnostics& diagnostics) const {
  Diagnostics found;
  std::shared_ptr<const description::Model> model = firstModel(sdf::loadText(text, name, found, finder(true)), found);
  addAll(found, diagnostics);
  return model;
}

void ModelEdits::announceChanges() {
  if (systems_ != nullptr) systems_->announceChanges();
}

}  // namespace pongsim::sim
