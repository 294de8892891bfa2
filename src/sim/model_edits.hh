#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "assets/finder.hh"
#include "description/model.hh"
#include "pongsim/handles.hh"
#include "pongsim/insert_options.hh"
#include "sdf/loader.hh"
#include "sim/access.hh"

namespace pongsim::sim {

class SystemSet;

/// Inserts and removes models with their systems, between two steps. What is refused changes nothing.
class ModelEdits {
 public:
  /// @param places Where files that models name are looked for. Both must outlive it.
  ModelEdits(Access& access, const assets::Places& places) : access_(access), places_(places) {}

  /// From now on models come and go with their systems, whose set must outlive it.
  void setSystems(SystemSet& systems) { systems_ = &systems; }

  std::optional<Model> insertFile(const std::filesystem::path& file, const InsertOptions& options,
                                  Diagnostics& diagnostics);
  std::optional<Model> insertText(std::string_view text, std::string_view name, const InsertOptions& options,
                                  Diagnostics& diagnostics);
  std::optional<Model> insertCopy(ModelId original, const InsertOptions& options, Diagnostics& diagnostics);
  /// @param model What is to be inserted but for what the options say.
  std::optional<Model> insert(const description::Model& model, const InsertOptions& options, Diagnostics& diagnostics);

  /// @return Why not, or nothing.
  std::optional<std::string> remove(ModelId model);

  /// @return The first model of an `<sdf>` element; null where there was an error. Likewise below.
  std::shared_ptr<const description::Model> read(const Element& sdf, Diagnostics& diagnostics) const;
  std::shared_ptr<const description::Model> readFile(const std::filesystem::path& file, Diagnostics& diagnostics) const;
  std::shared_ptr<const description::Model> readText(std::string_view text, std::string_view name,
                                                     Diagnostics& diagnostics) const;

  /// Where files that models name are looked for.
  const assets::Places& places() const { return places_; }

 private:
  std::shared_ptr<description::Model> readFirst(const std::filesystem::path& file, Diagnostics& diagnostics) const;
  std::optional<Model> insertFirst(sdf::Root root, const InsertOptions& options, Diagnostics& diagnostics);
  std::optional<Model> insertOwned(std::shared_ptr<description::Model> model, const InsertOptions& options,
                                   Diagnostics& diagnostics);
  void announceChanges();

  Access& access_;
  const assets::Places& places_;
  SystemSet* systems_ = nullptr;
};

}  // namespace pongsim::sim
