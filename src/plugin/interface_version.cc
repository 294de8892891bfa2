#include "plugin/interface_version.hh"

#include <link.h>

#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace pongsim::plugin {

namespace {

constexpr std::string_view kTableName = "pongsim_systems";
constexpr unsigned char kElfClass = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;

/// A file's bytes, of which any part may be asked for.
class ElfBytes {
 public:
  explicit ElfBytes(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return;
    std::ifstream stream(file, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), {});
  }

  /// @return The value there; nothing where the file ends before.
  template <class Value>
  std::optional<Value> at(std::size_t offset) const {
    if (offset > bytes_.size() || bytes_.size() - offset < sizeof(Value)) return std::nullopt;
    Value value;
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    return value;
  }

  /// @return Whether the text there is `text` and ends.
  bool hasText(std::size_t offset, std::string_view text) const {
    if (offset > bytes_.size() || bytes_.size() - offset <= text.size()) return false;
    return std::string_view(bytes_.data() + offset, text.size()) == text && bytes_[offset + text.size()] == '\0';
  }

 private:
  std::vector<char> bytes_;
};

/// @return Where in the file that address of the loaded library comes from.
std::optional<std::size_t> offsetOf(const ElfBytes& bytes, const ElfW(Ehdr) & header, std::size_t address) {
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    const auto part = bytes.at<ElfW(Phdr)>(header.e_phoff + i * sizeof(ElfW(Phdr)));
    if (!part) return std::nullopt;
    if (part->p_type == PT_LOAD && address >= part->p_vaddr && address - part->p_vaddr < part->p_filesz) {
      return address - part->p_vaddr + part->p_offset;
    }
  }
  return std::nullopt;
}

/// @return The address of the table among the names of a section, those that the library exports.
std::optional<std::size_t> tableAmong(const ElfBytes& bytes, const ElfW(Ehdr) & header, const ElfW(Shdr) & names) {
  const auto texts = bytes.at<ElfW(Shdr)>(header.e_shoff + names.sh_link * sizeof(ElfW(Shdr)));
  if (!texts) return std::nullopt;
  for (std::size_t i = 0; i < names.sh_size / sizeof(ElfW(Sym)); ++i) {
    const auto symbol = bytes.at<ElfW(Sym)>(names.sh_offset + i * sizeof(ElfW(Sym)));
    if (!symbol) return std::nullopt;
    if (symbol->st_shndx != SHN_UNDEF && bytes.hasText(texts->sh_offset + symbol->st_name, kTableName)) {
      return symbol->st_value;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::uint32_t> interfaceVersion(const std::filesystem::path& file) {
  const ElfBytes bytes(file);
  const auto header = bytes.at<ElfW(Ehdr)>(0);
  if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0 || header->e_ident[EI_CLASS] != kElfClass) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < header->e_shnum; ++i) {
    const auto section = bytes.at<ElfW(Shdr)>(header->e_shoff + i * sizeof(ElfW(Shdr)));
    if (!section) return std::nullopt;
    if (section->sh_type != SHT_DYNSYM) continue;
    const auto address = tableAmong(bytes, *header, *section);
    const auto offset = address ? offsetOf(bytes, *header, *address) : std::nullopt;
    return offset ? bytes.at<std::uint32_t>(*offset) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace pongsim::plugin
