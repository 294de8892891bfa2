#include "plugin/interface_version.hh"

#include <link.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace pongsim::plugin {

namespace {

constexpr std::string_view kTableName = "pongsim_systems";
constexpr unsigned char kElfClass = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;

/// A file read in parts: libraries can be large, and are checked each time a world loads them.
class ElfFile {
 public:
  explicit ElfFile(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return;
    const std::uintmax_t size = std::filesystem::file_size(file, ignored);
    if (ignored) return;
    size_ = size;
    stream_.open(file, std::ios::binary);
  }

  /// @return This many values at the offset; nothing if the file ends before.
  template <class Value>
  std::optional<std::vector<Value>> at(std::size_t offset, std::size_t count) {
    if (offset > size_ || (size_ - offset) / sizeof(Value) < count) return std::nullopt;
    std::vector<Value> values(count);
    stream_.seekg(static_cast<std::streamoff>(offset));
    stream_.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(Value)));
    return stream_ ? std::optional(std::move(values)) : std::nullopt;
  }

  /// @return The value at the offset; nothing if the file ends before.
  template <class Value>
  std::optional<Value> at(std::size_t offset) {
    const auto values = at<Value>(offset, 1);
    return values ? std::optional(values->front()) : std::nullopt;
  }

 private:
  std::size_t size_ = 0;
  std::ifstream stream_;
};

/// @return The file offset of an address in the loaded library.
std::optional<std::size_t> offsetOf(ElfFile& file, const ElfW(Ehdr) & header, std::size_t address) {
  const auto parts = file.at<ElfW(Phdr)>(header.e_phoff, header.e_phnum);
  if (!parts) return std::nullopt;
  for (const ElfW(Phdr) & part : *parts) {
    if (part.p_type == PT_LOAD && address >= part.p_vaddr && address - part.p_vaddr < part.p_filesz) {
      return address - part.p_vaddr + part.p_offset;
    }
  }
  return std::nullopt;
}

/// @return The address of the table of systems, if it is among the symbols of this section, which the library exports.
std::optional<std::size_t> tableAmong(ElfFile& file, const ElfW(Shdr) & names, const ElfW(Shdr) & textsOfNames) {
  const auto symbols = file.at<ElfW(Sym)>(names.sh_offset, names.sh_size / sizeof(ElfW(Sym)));
  const auto texts = file.at<char>(textsOfNames.sh_offset, textsOfNames.sh_size);
  if (!symbols || !texts || texts->empty() || texts->back() != '\0') return std::nullopt;
  for (const ElfW(Sym) & symbol : *symbols) {
    if (symbol.st_shndx == SHN_UNDEF || symbol.st_name >= texts->size()) continue;
    if (std::string_view(texts->data() + symbol.st_name) == kTableName) return symbol.st_value;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::uint32_t> interfaceVersion(const std::filesystem::path& path) {
  ElfFile file(path);
  const auto header = file.at<ElfW(Ehdr)>(0);
  if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0 || header->e_ident[EI_CLASS] != kElfClass) {
    return std::nullopt;
  }
  const auto sections = file.at<ElfW(Shdr)>(header->e_shoff, header->e_shnum);
  if (!sections) return std::nullopt;
  for (const ElfW(Shdr) & section : *sections) {
    if (section.sh_type != SHT_DYNSYM) continue;
    if (section.sh_link >= sections->size()) return std::nullopt;
    const auto address = tableAmong(file, section, (*sections)[section.sh_link]);
    const auto offset = address ? offsetOf(file, *header, *address) : std::nullopt;
    return offset ? file.at<std::uint32_t>(*offset) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace pongsim::plugin
