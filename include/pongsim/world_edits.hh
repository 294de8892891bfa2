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

/// A parsed and checked model, to be inserted any number of times. Copies refer to the same model.
class PONGSIM_API ModelTemplate {
 public:
  /// @return Its name in the file.
  const std::string& name() const;
  /// @return Its pose in the file.
  Pose pose() const;
  bool isStatic() const;

 private:
  friend class WorldEdits;
  explicit ModelTemplate(std::shared_ptr<const description::Model> model) : model_(std::move(model)) {}
  std::shared_ptr<const description::Model> model_;
};

/// Inserts and removes models for a system. Requests are carried out between phases of a step, in the order of all
/// systems' requests: those made while messages are delivered (in a subscription or service) before this step's
/// `preUpdate`, those made during a step at its end, after `postUpdate`. Paused steps do so too. The given function is
/// called afterwards.
///
/// If a system is removed with its model, its requests are discarded without an answer. A reset discards open requests,
/// which are not part of a saved state either.
class PONGSIM_API WorldEdits {
 public:
  /// Called with the model, or why there is none.
  using Inserted = std::function<void(const Outcome<Model>&)>;
  /// Called with the reason why the model still exists; nothing if it was removed.
  using Removed = std::function<void(const Outcome<void>&)>;

  ~WorldEdits();
  WorldEdits(const WorldEdits&) = delete;
  WorldEdits& operator=(const WorldEdits&) = delete;

  /// Reads the first model of an `<sdf>` element, such as one in a `<plugin>`, including the files it refers to. Do it
  /// in `configure`.
  /// @throws Error on errors. Warnings are added to `diagnostics`.
  ModelTemplate read(const Element& sdf, Diagnostics& diagnostics) const;
  /// Like `read`, from a text, which may be a URDF robot; `name` is used in messages. For models from outside: see
  /// `InsertOptions::isFromOutside`.
  ModelTemplate readText(std::string_view text, std::string_view name, Diagnostics& diagnostics) const;
  /// The same from a file, or from a model folder (with `model.config`).
  ModelTemplate readFile(const std::filesystem::path& file, Diagnostics& diagnostics) const;

  /// @return The folders searched for models and their files, in this order.
  std::vector<std::filesystem::path> resourceFolders() const;
  /// @return Whether what comes from outside may read this file or folder: see `InsertOptions::isFromOutside`.
  bool isInReach(const std::filesystem::path& path) const;
  /// @return The file or folder of an address such as "model://box"; nothing if it was not found.
  std::optional<std::filesystem::path> resolve(const std::string& address) const;

  /// Requests a copy of the model, with the systems of its plugins.
  /// @param inserted Empty: only a refusal is reported, as a warning.
  void insert(const ModelTemplate& model, const InsertOptions& options, Inserted inserted = {});
  /// Requests the first model of a text, which may be a URDF robot; `name` is used in messages.
  void insertText(std::string text, std::string name, const InsertOptions& options, Inserted inserted = {});
  /// The same from a file, or from a model folder.
  void insertFile(std::filesystem::path file, const InsertOptions& options, Inserted inserted = {});
  /// Requests a copy of a top-level model as it was inserted, at the model's pose at that time or that of `options`.
  void insertCopy(const Model& model, const InsertOptions& options, Inserted inserted = {});
  /// Requests the removal of a top-level model with its systems.
  /// @param removed Empty: only a refusal is reported, as a warning.
  void remove(const Model& model, Removed removed = {});

 private:
  friend class sim::SystemSlot;
  WorldEdits(sim::EditQueue& queue, sim::SystemSlot& owner) : queue_(queue), owner_(owner) {}
  InsertOptions owned(InsertOptions options) const;

  sim::EditQueue& queue_;
  sim::SystemSlot& owner_;
};

}  // namespace pongsim
