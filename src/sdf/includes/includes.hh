#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "assets/finder.hh"
#include "assets/meshes/mesh_store.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/includes/addresses.hh"

namespace pongsim::sdf {

/// The files included in one load, each parsed once, and where each is included.
class Includes {
 public:
  /// Maximum depth of nested models, across files.
  static constexpr int kDeepestModel = 100;
  static constexpr std::size_t kDeepestInclude = 50;
  static constexpr std::size_t kMostIncludes = 20'000;

  /// @param unsimulated As in the files' contexts.
  Includes(assets::Finder finder, Diagnostics& diagnostics, Diagnostics& unsimulated);

  /// Starts the load of this file, so that a file that includes it again is found to be a cycle.
  void begin(const std::filesystem::path& file);

  /// Downloads everything that a file names on Fuel servers, all at once.
  void bring(const Element& root) const { finder_.bring(fuelAddressesIn(root)); }

  /// Receives the element that an `<include>` stands for (a `<model>`, `<light>` or `<actor>`, with the overrides
  /// applied), which it may move from, and the context of its file.
  using ReadIncluded = std::function<void(Element& included, Context& context)>;

  /// Opens the file named by an `<include>` and calls `read` with its element.
  /// @param context Context of the file with the `<include>`.
  /// @return False if it can't be opened; at least the first such `<include>` adds an error.
  bool follow(const Element& include, Context& context, const ReadIncluded& read);

  /// Prepares for printing the result: from now on elements get those that Fortress adds.
  /// @param keepsReplacements Whether the elements that replace each `<include>` are kept, with relative addresses made
  /// absolute.
  void prepareToPrint(bool keepsReplacements) {
    isForPrint_ = true;
    keepsReplacements_ = keepsReplacements;
  }

  /// Upgrades to SDF 1.9 or 1.12; for printing, also adds what Fortress adds.
  void modernize(Element& root, Context& context);

  /// Records the elements that replace an `<include>`.
  /// @return Those elements, for reading: `parts`, or the copy that is kept of them.
  const std::vector<Element>& replace(const Element& include, std::vector<Element>& parts);

  /// Replaces all includes in `element`, at any depth, by what was kept.
  void resolve(Element& element);

  /// Finds another file, such as a mesh: see `assets::Finder`.
  std::optional<std::filesystem::path> findAsset(std::string_view uri, const std::filesystem::path& folder,
                                                 const SourcePosition& position, Diagnostics& diagnostics) const {
    return finder_(uri, folder, position, diagnostics);
  }
  /// @return Whether files in this folder may write other files.
  bool mayWrite(const std::filesystem::path& folder) const { return !finder_.isConfined(folder); }
  /// @return Whether xacro, which may read any file, may expand this one.
  bool mayExpand(const std::filesystem::path& file) const { return mayWrite(file.parent_path()); }
  assets::MeshStore& meshes() { return meshes_; }

  /// @return Where the file of `position` is included, where that file is included, and so on.
  std::vector<SourcePosition> chainOf(const SourcePosition& position) const;

  /// Call at the start of a model.
  /// @return False, with an error, if models are nested too deep.
  bool enterModel(const SourcePosition& position);
  void leaveModel() { --modelDepth_; }

 private:
  struct File {
    /// Canonical path, to recognize the file.
    std::filesystem::path path;
    /// Its name in diagnostics.
    std::filesystem::path name;
    std::size_t size = 0;
    /// The part that other files include; nothing if the file can't be read.
    std::optional<Element> content;
    Context context;
  };
  using Name = std::shared_ptr<const std::string>;

  std::optional<std::filesystem::path> find(const Element& include, Context& context);
  File& fileAt(const std::filesystem::path& path, const SourcePosition& includedFrom);
  void parse(const std::filesystem::path& path, const Name& name, File& file);
  bool isWithinBounds(const Element& include, const File& file);
  bool isRecursion(const Element& include, const File& file);
  Name newName(const std::filesystem::path& path, const SourcePosition& includedFrom);

  assets::Finder finder_;
  assets::MeshStore meshes_;
  Diagnostics& diagnostics_;
  Diagnostics& unsimulated_;
  std::unordered_map<std::string, std::unique_ptr<File>> files_;
  /// The SDF file of each model folder, if its model.config names one.
  std::unordered_map<std::string, std::optional<std::filesystem::path>> modelFiles_;
  /// Where the file of each name was included; every inclusion has a name of its own.
  std::unordered_map<Name, SourcePosition> includedFrom_;
  /// The open files, innermost last.
  std::vector<std::filesystem::path> open_;
  std::size_t count_ = 0;
  std::size_t size_ = 0;
  int modelDepth_ = 0;
  bool isForPrint_ = false;
  /// That of the file itself, when it is printed.
  int printedVersion_ = 0;
  bool keepsReplacements_ = false;
  std::unordered_map<const Element*, std::vector<Element>> replacements_;
};

}  // namespace pongsim::sdf
