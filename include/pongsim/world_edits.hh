#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/insert_options.hh"
#include "pongsim/outcome.hh"
#include "pongsim/types.hh"

namespace pongsim {

namespace description {
struct Model;
}

namespace sim {
class EditQueue;
class ModelEdits;
class SystemSlot;
}  // namespace sim

/// A model that was read and checked, to be inserted as often as one likes. A copy is the same model.
class PONGSIM_API ModelTemplate {
 public:
  /// @return The name that its file gives it.
  const std::string& name() const;
  /// @return The pose that its file gives it.
  Pose pose() const;
  bool isStatic() const;

 private:
  friend class WorldEdits;
  explicit ModelTemplate(std::shared_ptr<const description::Model> model) : model_(std::move(model)) {}
  std::shared_ptr<const description::Model> model_;
};

/// How a system inserts and removes models. What it asks for is carried out between two phases in which systems run, in
/// the order in which all systems have asked: what is asked for while messages are handed over (in the function of a
/// subscription or a service) before this step's `preUpdate`, what is asked for in a step at its end, after
/// `postUpdate`. Paused steps do so, too. Then the function is called that was given with it.
///
/// A system that goes, for its model was removed, has no answer any more and what it asked for is not done; a reset
/// forgets what has not been done yet, which is no part of a saved state either.
class PONGSIM_API WorldEdits {
 public:
  /// Told the model, or why there is none.
  using Inserted = std::function<void(const Outcome<Model>&)>;
  /// Told why the model is still there; nothing where it has gone.
  using Removed = std::function<void(const std::optional<std::string>&)>;

  ~WorldEdits();
  WorldEdits(const WorldEdits&) = delete;
  WorldEdits& operator=(const WorldEdits&) = delete;

  /// Reads the first model of an `<sdf>` element, as one that stands in a `<plugin>`. Files that it names are read,
  /// too: do it in `configure`.
  /// @throws Error where it is wrong. All else that is to be said of it is added to `diagnostics`.
  ModelTemplate read(const Element& sdf, Diagnostics& diagnostics) const;
  /// As `read`, of a text, which may be a URDF robot; `name` stands in the messages.
  ModelTemplate readText(std::string_view text, std::string_view name, Diagnostics& diagnostics) const;
  /// Likewise of a file, or of a model's folder, whose `model.config` names the file.
  ModelTemplate readFile(const std::filesystem::path& file, Diagnostics& diagnostics) const;

  /// @return Where models and what they name are looked for, in this order.
  std::vector<std::filesystem::path> resourceFolders() const;
  /// @return The file or folder that an address names, as "model://box"; nothing where there is none.
  std::optional<std::filesystem::path> resolve(const std::string& address) const;

  /// Asks for a copy of the model, with the systems of its plugins.
  /// @param inserted Empty: only a refusal is told, as a warning.
  void insert(const ModelTemplate& model, const InsertOptions& options, Inserted inserted = {});
  /// Asks for the first model of a text, which may be a URDF robot; `name` stands in the messages.
  void insertText(std::string text, std::string name, const InsertOptions& options, Inserted inserted = {});
  /// Likewise of a file, or of a model's folder.
  void insertFile(std::filesystem::path file, const InsertOptions& options, Inserted inserted = {});
  /// Asks for a copy of a model of the top level as it was when it came, where the model is then or as `options` say.
  void insertCopy(const Model& model, const InsertOptions& options, Inserted inserted = {});
  /// Asks for a model of the top level to go, with its systems.
  /// @param removed Empty: only a refusal is told, as a warning.
  void remove(const Model& model, Removed removed = {});

 private:
  friend class sim::SystemSlot;
  WorldEdits(sim::EditQueue& queue, sim::SystemSlot& owner) : queue_(queue), owner_(owner) {}
  sim::EditQueue& queue_;
  sim::SystemSlot& owner_;
};

}  // namespace pongsim
