#include "assets/meshes/mesh_files.hh"

#include <algorithm>
#include <cstring>
#include <memory>
#include <system_error>
#include <utility>
#include <variant>

#include "assets/meshes/mesh_file.hh"
#include "base/is_below.hh"
#include "base/regular_file.hh"

namespace pongsim::assets {

namespace fs = std::filesystem;

/// Assimp's view of a file: functions, and a pointer that leads them back here.
struct MeshFiles::OpenFile {
  explicit OpenFile(const std::string& ofContent) : content(ofContent) {
    file.ReadProc = read;
    file.WriteProc = [](aiFile*, const char*, size_t, size_t) -> size_t { return 0; };
    file.TellProc = [](aiFile* of) { return self(of).at; };
    file.FileSizeProc = [](aiFile* of) { return self(of).content.size(); };
    file.SeekProc = seek;
    file.FlushProc = [](aiFile*) {};
    file.UserData = reinterpret_cast<char*>(this);
  }

  static OpenFile& self(aiFile* of) { return *reinterpret_cast<OpenFile*>(of->UserData); }

  static size_t read(aiFile* of, char* to, size_t size, size_t count) {
    OpenFile& open = self(of);
    if (size == 0) return 0;
    const size_t read = std::min(count, (open.content.size() - open.at) / size);
    std::memcpy(to, open.content.data() + open.at, read * size);
    open.at += read * size;
    return read;
  }

  static aiReturn seek(aiFile* of, size_t offset, aiOrigin origin) {
    OpenFile& open = self(of);
    const size_t size = open.content.size();
    size_t from = 0;
    if (origin == aiOrigin_CUR) from = open.at;
    // Assimp counts back from the end with a positive offset
    if (origin == aiOrigin_END) {
      if (offset > size) return aiReturn_FAILURE;
      open.at = size - offset;
      return aiReturn_SUCCESS;
    }
    if (offset > size - from) return aiReturn_FAILURE;
    open.at = from + offset;
    return aiReturn_SUCCESS;
  }

  const std::string& content;
  size_t at = 0;
  aiFile file{};
};

MeshFiles::MeshFiles(const fs::path& mesh, std::string content)
    : mesh_(mesh),
      content_(std::move(content)),
      room_(kLargestMeshFile - std::min(kLargestMeshFile, content_.size())),
      io_{open, close, reinterpret_cast<char*>(this)} {
  std::error_code error;
  const fs::path real = fs::canonical(mesh, error);
  if (!error) around_ = real.parent_path().parent_path();
}

aiFile* MeshFiles::open(aiFileIO* io, const char* name, const char* mode) {
  auto& files = *reinterpret_cast<MeshFiles*>(io->UserData);
  if (std::strpbrk(mode, "wa+") != nullptr) return nullptr;
  const std::string* content = files.contentOf(name);
  return content == nullptr ? nullptr : &std::make_unique<OpenFile>(*content).release()->file;
}

void MeshFiles::close(aiFileIO*, aiFile* file) { delete &OpenFile::self(file); }

const std::string* MeshFiles::contentOf(const fs::path& file) {
  if (file == mesh_) return &content_;
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error || around_.empty() || !base::isBelow(real, around_)) return nullptr;
  auto read = base::readRegularFile(real, room_);
  auto* const content = std::get_if<std::string>(&read);
  if (content == nullptr) return nullptr;
  room_ -= content->size();
  return &contents_.emplace_back(std::move(*content));
}

}  // namespace pongsim::assets
