#include "support/proc.hh"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace pongsim::test {

namespace {

std::filesystem::path folderOf(pid_t pid) { return "/proc/" + std::to_string(pid); }

}  // namespace

std::set<std::string> socketsOf(pid_t pid, const std::string& table) {
  std::set<std::string> inodes;
  for (const auto& entry : std::filesystem::directory_iterator(folderOf(pid) / "fd")) {
    std::error_code ignored;
    const std::string target = std::filesystem::read_symlink(entry, ignored).string();
    if (target.starts_with("socket:[")) inodes.insert(target.substr(8, target.size() - 9));
  }
  std::set<std::string> addresses;
  std::ifstream lines(folderOf(pid) / "net" / table);
  for (std::string line; std::getline(lines, line);) {
    char address[64];
    char inode[64];
    if (std::sscanf(line.c_str(), " %*u: %63s %*s %*s %*s %*s %*s %*s %*s %63s", address, inode) != 2) continue;
    if (inodes.contains(inode)) addresses.insert(address);
  }
  return addresses;
}

std::uint64_t memoryOf(pid_t pid) {
  std::ifstream lines(folderOf(pid) / "status");
  std::uint64_t bytes = 0;
  for (std::string line; std::getline(lines, line);) {
    unsigned long long kilobytes = 0;
    for (const char* kind : {"RssAnon: %llu kB", "RssShmem: %llu kB"}) {
      if (std::sscanf(line.c_str(), kind, &kilobytes) == 1) bytes += kilobytes * 1024;
    }
  }
  return bytes;
}

std::set<std::string> sharedMemoryOf(pid_t pid) {
  const std::string folder = "/dev/shm/";
  std::set<std::string> names;
  std::ifstream lines(folderOf(pid) / "maps");
  for (std::string line; std::getline(lines, line);) {
    if (const std::size_t at = line.find(folder); at != std::string::npos)
      names.insert(line.substr(at + folder.size()));
  }
  return names;
}

}  // namespace pongsim::test
