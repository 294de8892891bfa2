#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "assets/finder.hh"
#include "description/model.hh"
#include "pongsim/handles.hh"
#include "pongsim/insert_options.hh"
#include "pongsim/simulation.hh"
#include "sdf/loader.hh"
#include "sim/api/access.hh"

namespace pongsim::sim {

class SystemSet;

/// Inserts and removes models with their systems, and inserts lights from files, between two steps. A refused change
/// has no effect.
class ModelEdits {
 public:
  /// @param places Where models' files are searched. Both references must outlive this.
  /// @param worldFile Models from outside may read files in its folder. Empty: the world has no file.
  ModelEdits(Access& access, const assets::Places& places, const std::filesystem::path& worldFile);

  /// Sets the systems, which are then added and removed with their models. They must outlive this.
  void setSystems(SystemSet& systems) { systems_ = &systems; }

  std::optional<Model> insertFile(const std::filesystem::path& file, const InsertOptions& options,
                                  Diagnostics& diagnostics);
  std::optional<Model> insertText(std::string_view text, std::string_view name, const InsertOptions& options,
                                  Diagnostics& diagnostics);
  /// Like the two functions above; the file or text may contain a light instead of a model.
  std::optional<ModelOrLight> insertModelOrLight(const std::filesystem::path& file, const InsertOptions& options,
                                                 Diagnostics& diagnostics);
  std::optional<ModelOrLight> insertModelOrLight(std::string_view text, std::string_view name,
                                                 const InsertOptions& options, Diagnostics& diagnostics);
  std::optional<Model> insertCopy(ModelId original, const InsertOptions& options, Diagnostics& diagnostics);
  /// @param model The model to insert, except for what the options replace.
  std::optional<Model> insert(const description::Model& model, const InsertOptions& options, Diagnostics& diagnostics);

  static constexpr std::string_view kNoLongerThere = "the model no longer exists";
  /// @return The top-level model that contains the model, or is it; 0 if the model does not exist.
  ModelId topLevel(ModelId model) const;
  /// @return Whether the model can be removed.
  Outcome<void> mayRemove(ModelId model) const;
  /// Removes all of the models, or none if one of them can't be removed.
  Outcome<void> remove(std::span<const ModelId> models);

  /// @return The first model of an `<sdf>` element; null on errors.
  std::shared_ptr<const description::Model> read(const Element& sdf, bool isFromOutside,
                                                 Diagnostics& diagnostics) const;
  /// The same for a file or text from outside.
  std::shared_ptr<const description::Model> readFile(const std::filesystem::path& file, Diagnostics& diagnostics) const;
  std::shared_ptr<const description::Model> readText(std::string_view text, std::string_view name,
                                                     Diagnostics& diagnostics) const;

  /// Where models' files are searched.
  const assets::Places& places() const { return places_; }
  /// @return Whether models from outside may read this file or folder.
  bool isInReach(const std::filesystem::path& path) const { return finder(true).mayRead(path, {}); }

 private:
  assets::Finder finder(bool isFromOutside) const;
  /// @return The SDF file that a model folder's model.config names; `file` itself if it is not a folder. Nothing, and
  /// an error, if there is no such file.
  std::optional<std::filesystem::path> modelFile(const std::filesystem::path& file, bool isFromOutside,
                                                 Diagnostics& diagnostics) const;
  std::shared_ptr<description::Model> readFirst(const std::filesystem::path& file, bool isFromOutside,
                                                Diagnostics& diagnostics) const;
  std::optional<Model> insertFirst(sdf::Root root, const InsertOptions& options, Diagnostics& diagnostics);
  /// @param found Diagnostics of reading the file; those of the insertion are appended.
  std::optional<ModelOrLight> insertFirstOf(sdf::Root root, const InsertOptions& options, Diagnostics& found);
  std::optional<ModelOrLight> insertFirstLight(const sdf::Root& root, const InsertOptions& options,
                                               Diagnostics& diagnostics);
  std::optional<Model> insertOwned(std::shared_ptr<description::Model> model, const InsertOptions& options,
                                   Diagnostics& diagnostics);
  void announceChanges();

  Access& access_;
  const assets::Places& places_;
  assets::Finder::Reach reach_;
  SystemSet* systems_ = nullptr;
};

}  // namespace pongsim::sim
