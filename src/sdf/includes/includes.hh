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
#include "assets/mesh_store.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/includes/addresses.hh"

namespace pongsim::sdf {

/// The files that one load includes, each of which is parsed once, and who includes what.
class Includes {
 public:
  /// Models within models, across files.
  static constexpr int kDeepestModel = 100;
  static constexpr std::size_t kDeepestInclude = 50;
  static constexpr std::size_t kMostIncludes = 20'000;

  /// @param unsimulated As in the contexts of the files.
  Includes(assets::Finder finder, Diagnostics& diagnostics, Diagnostics& unsimulated);

  /// Where the load begins: a file that includes this one includes itself.
  void begin(const std::filesystem::path& file);

  /// Downloads what is on a Fuel server and named anywhere in a file, all of it at once.
  void bring(const Element& root) const { finder_.bring(fuelAddressesIn(root)); }

  /// Called with what an `<include>` stands for: a `<model>`, `<light>` or `<actor>` with what the `<include>` says of
  /// it in place of its own, to keep or change; and the context of its file.
  using Read = std::function<void(Element& included, Context& context)>;

  /// Opens what an `<include>` names, and calls `read` with it.
  /// @param context That of the file of the `<include>`.
  /// @return False, and an error added by the first such `<include>` at least, where it can't be opened.
  bool follow(const Element& include, Context& context, const Read& read);

  /// Readies the load for a result that is printed: from now on elements get what Fortress adds to them.
  /// @param keepsReplacements What stands in place of each `<include>` is kept, and relative addresses in it are made
  /// absolute.
  void prepareToPrint(bool keepsReplacements) {
    isForPrint_ = true;
    keepsReplacements_ = keepsReplacements;
  }

  /// To SDF 1.9; for the print also what Fortress adds.
  void modernize(Element& root, Context& context) const;

  /// Notes what stands in place of an `<include>`.
  /// @return Those elements, to be read: `parts`, or the copy that is kept of them.
  const std::vector<Element>& replace(const Element& include, std::vector<Element>& parts);

  /// Puts what was kept in place of the includes in `element`, all the way down.
  void resolve(Element& element);

  /// Finds another file that one names, as a mesh: see `assets::Finder`.
  std::optional<std::filesystem::path> findAsset(std::string_view uri, const std::filesystem::path& folder,
                                                 const SourcePosition& position, Diagnostics& diagnostics) const {
    return finder_(uri, folder, position, diagnostics);
  }
  assets::MeshStore& meshes() { return meshes_; }

  /// @return Where the file of `position` is included, where that file is included, and so on.
  std::vector<SourcePosition> chainOf(const SourcePosition& position) const;

  /// Notes that a model begins.
  /// @return False, and an error added, where it nests too deep.
  bool enterModel(const SourcePosition& position);
  void leaveModel() { --modelDepth_; }

 private:
  struct File {
    /// As found on the disk, without links, to know it again.
    std::filesystem::path path;
    std::size_t size = 0;
    /// What it holds for others; nothing if it can't be read.
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
  /// By the folder of each model its SDF file, where its model.config names one.
  std::unordered_map<std::string, std::optional<std::filesystem::path>> modelFiles_;
  /// Where each name of a file comes from: every inclusion has a name of its own.
  std::unordered_map<Name, SourcePosition> includedFrom_;
  /// The files that are open, the innermost last.
  std::vector<std::filesystem::path> open_;
  std::size_t count_ = 0;
  std::size_t size_ = 0;
  int modelDepth_ = 0;
  bool isForPrint_ = false;
  bool keepsReplacements_ = false;
  std::unordered_map<const Element*, std::vector<Element>> replacements_;
};

}  // namespace pongsim::sdf
