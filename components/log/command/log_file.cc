#include "log/command/log_file.hh"

#include <algorithm>
#include <vector>

#include "log/mcap/input_file.hh"
#include "log/store/failure.hh"
#include "log/tlog/tlog_reader.hh"
#include "pongsim/program/nearest_word.hh"
#include "shared/program/failure.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

Format formatOf(const fs::path& file) {
  if (file.extension() == ".mcap") return Format::kMcap;
  if (file.extension() == ".tlog") return Format::kTlog;
  throw cli::UsageError("'" + file.string() + "' is not a log", "the name must end in .mcap or .tlog");
}

LogFile::LogFile(const fs::path& file) {
  constexpr std::string_view kSqlite = "SQLite format 3";
  bool isTlog = false;
  {
    // closed before SQLite opens the file
    const InputFile bytes(file);
    isTlog = bytes.size() >= kSqlite.size() && bytes.read(0, kSqlite.size()) == kSqlite;
  }
  if (isTlog) {
    reader_ = std::make_unique<TlogReader>(file);
    return;
  }
  auto mcap = std::make_unique<McapReader>(file);
  mcap_ = mcap.get();
  reader_ = std::move(mcap);
}

Definition LogFile::definition(std::string_view topic, std::string_view type) const {
  return mcap_ == nullptr ? protobufDefinition(type) : mcap_->definition(topic, type);
}

std::string requireTopic(const Reader& reader, const std::string& file, const std::string& topic) {
  const std::vector<Topic> topics = reader.topics();
  for (const std::string& name : {topic, "/" + topic}) {
    if (std::ranges::find(topics, name, &Topic::name) != topics.end()) return name;
  }
  std::vector<std::string_view> names;
  for (const Topic& each : topics) names.push_back(each.name);
  const std::string near = didYouMean(topic, names);
  throw Failure("there is no topic '" + topic + "' in '" + file + "'",
                near.empty() ? "pongsim log info " + file + " lists them" : near);
}

Compression compressionFrom(const std::string& text) {
  if (text == "none") return Compression::kNone;
  const std::optional<Compression> compression = compressionOf(text);
  if (!compression || *compression == Compression::kNone) {
    throw cli::UsageError("'" + text + "' is not a compression", "use zstd, lz4 or none");
  }
  return *compression;
}

}  // namespace pongsim::log
