#include "log/store/zip.hh"

#include <zip.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "log/store/failure.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

namespace {

struct Closer {
  void operator()(zip_t* zip) const { zip_discard(zip); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Archive = std::unique_ptr<zip_t, Closer>;

Archive openZip(const fs::path& file, int how) {
  int code = 0;
  Archive zip(zip_open(file.c_str(), how, &code));
  if (zip) return zip;
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  throw Failure("'" + file.string() + "' can't be opened as a zip file: " + why);
}

/// @return The path of an entry below a folder.
/// @throws Failure if it is outside of the folder.
fs::path placeOf(const std::string& name) {
  const fs::path path = fs::path(name).lexically_normal();
  if (path.empty() || path.is_absolute() || *path.begin() == "..")
    throw Failure("the zip file was refused: '" + name + "' leads out of its folder");
  return path;
}

/// @param size Its claimed size [bytes].
void unpackEntry(zip_t* zip, zip_uint64_t index, std::uint64_t size, const fs::path& target) {
  const std::unique_ptr<zip_file_t, Closer> entry(zip_fopen_index(zip, index, 0));
  std::ofstream stream(target, std::ios::binary);
  std::array<char, 65536> part{};
  std::uint64_t done = 0;
  zip_int64_t count = entry ? 0 : -1;
  while (stream && done <= size && entry && (count = zip_fread(entry.get(), part.data(), part.size())) > 0) {
    stream.write(part.data(), count);
    done += static_cast<std::uint64_t>(count);
  }
  if (count < 0 || (stream && done != size))
    throw Failure("the zip file is damaged where it has '" + target.filename().string() + "'");
  stream.close();
  if (!stream) throw Failure("'" + target.string() + "' can't be written: " + std::strerror(errno));
}

}  // namespace

void packFolder(const fs::path& folder, const fs::path& zipFile) {
  Archive zip = openZip(zipFile, ZIP_CREATE | ZIP_TRUNCATE);
  const auto fail = [&] { throw Failure("'" + zipFile.string() + "' can't be written: " + zip_strerror(zip.get())); };
  for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder)) {
    const std::string name = (folder.filename() / fs::relative(each.path(), folder)).string();
    if (each.is_directory()) {
      if (zip_dir_add(zip.get(), name.c_str(), ZIP_FL_ENC_UTF_8) < 0) fail();
      continue;
    }
    zip_source_t* const source = zip_source_file(zip.get(), each.path().c_str(), 0, 0);
    if (source == nullptr) fail();
    if (zip_file_add(zip.get(), name.c_str(), source, ZIP_FL_ENC_UTF_8) >= 0) continue;
    zip_source_free(source);
    fail();
  }
  // libzip writes the file here
  if (zip_close(zip.get()) != 0) fail();
  static_cast<void>(zip.release());
}

void unpackZip(const fs::path& zipFile, const fs::path& folder, const ZipLimits& limits) {
  const Archive zip = openZip(zipFile, ZIP_RDONLY | ZIP_CHECKCONS);
  const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(zip.get(), 0));
  if (count > limits.files) {
    throw Failure("the zip file was refused: it has " + std::to_string(count) + " files, and " +
                  std::to_string(limits.files) + " is the limit");
  }
  std::vector<zip_stat_t> stats(count);
  std::uint64_t total = 0;
  for (zip_uint64_t i = 0; i < count; ++i) {
    zip_stat_init(&stats[i]);
    const zip_uint64_t needed = ZIP_STAT_NAME | ZIP_STAT_SIZE;
    if (zip_stat_index(zip.get(), i, 0, &stats[i]) != 0 || (stats[i].valid & needed) != needed)
      throw Failure("'" + zipFile.string() + "' is damaged: " + zip_strerror(zip.get()));
    placeOf(stats[i].name);
    // sums of claims can wrap
    total += std::min(stats[i].size, std::numeric_limits<std::uint64_t>::max() - total);
  }
  const std::uint64_t packed = fs::file_size(zipFile);
  if (total > limits.free + limits.ratio * packed) {
    throw Failure(
        "the zip file was refused: its " + std::to_string(packed) + " bytes would become " + std::to_string(total),
        "if you trust it, unpack it yourself and play the folder");
  }
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  if (!error && space.available < total) {
    throw Failure("not enough disk space for the " + std::to_string(total) + " bytes of '" + zipFile.string() +
                      "' in '" + folder.string() + "'",
                  "set TMPDIR to a folder on another disk");
  }
  for (zip_uint64_t i = 0; i < count; ++i) {
    const std::string name = stats[i].name;
    const fs::path target = folder / placeOf(name);
    fs::create_directories(name.ends_with('/') ? target : target.parent_path());
    if (!name.ends_with('/')) unpackEntry(zip.get(), i, stats[i].size, target);
  }
}

}  // namespace pongsim::log
