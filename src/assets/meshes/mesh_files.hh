#pragma once

#include <assimp/cfileio.h>

#include <filesystem>
#include <list>
#include <string>

namespace pongsim::assets {

/// The files that Assimp opens for one mesh: the mesh itself, and what it names, such as buffers of glTF and materials
/// of OBJ. Only regular files in the mesh's folder and in those beside it, at most `kLargestMeshFile` bytes in all,
/// read whole.
class MeshFiles {
 public:
  /// @param mesh Its content is `content` and is not read again.
  MeshFiles(const std::filesystem::path& mesh, std::string content);
  MeshFiles(const MeshFiles&) = delete;
  MeshFiles& operator=(const MeshFiles&) = delete;

  aiFileIO* io() { return &io_; }

 private:
  struct OpenFile;

  static aiFile* open(aiFileIO* io, const char* name, const char* mode);
  static void close(aiFileIO* io, aiFile* file);
  const std::string* contentOf(const std::filesystem::path& file);

  std::filesystem::path mesh_;
  /// The parent of the mesh's folder, with all links resolved.
  std::filesystem::path around_;
  std::string content_;
  std::size_t room_;
  /// Of the files that the mesh names.
  std::list<std::string> contents_;
  aiFileIO io_;
};

}  // namespace pongsim::assets
