#include "log/command/new_log.hh"

#include "log/command/log_file.hh"
#include "log/store/failure.hh"
#include "log/tlog/tlog_writer.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

std::unique_ptr<Writer> newLog(const fs::path& file, const McapOptions& options, const Definitions& definitions) {
  const Format format = formatOf(file);
  std::error_code error;
  if (!options.overwrites && fs::exists(fs::symlink_status(file, error))) {
    throw Failure("'" + file.string() + "' is there already", "--force overwrites it");
  }
  if (fs::is_directory(file, error)) throw Failure("'" + file.string() + "' is a folder");
  if (format == Format::kMcap) return std::make_unique<McapWriter>(file, options, definitions);
  return std::make_unique<TlogWriter>(file);
}

}  // namespace pongsim::log
