#include <CLI/App.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "log/command/command.hh"
#include "log/command/log_file.hh"
#include "log/command/times.hh"
#include "shared/program/console.hh"

namespace pongsim::log {

namespace {

namespace fs = std::filesystem;

struct InfoCommandLine {
  std::string file;
  bool asJson = false;
};

/// Information about a log, as text or as JSON.
struct LogInfo {
  std::string file;
  std::uint64_t size = 0;
  std::vector<Topic> topics;
  std::optional<TimeRange> range;
  std::optional<std::string> torn;
  std::uint64_t messages = 0;
  /// [s]
  double duration = 0;
};

LogInfo infoOf(const std::string& file, const LogFile& log) {
  LogInfo info{file, fs::file_size(file), log.reader().topics(), log.reader().timeRange(), log.reader().torn()};
  for (const Topic& topic : info.topics) info.messages += topic.count;
  if (info.range)
    info.duration = (static_cast<double>(info.range->last) - static_cast<double>(info.range->first)) * 1e-9;
  return info;
}

/// Messages per second, over the whole log.
double rateOf(const Topic& topic, const LogInfo& info) {
  return info.duration > 0 ? static_cast<double>(topic.count) / info.duration : 0;
}

std::string formatted(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string sizeText(std::uint64_t bytes) {
  constexpr std::array<const char*, 4> kUnits = {"%.0f B", "%.1f kB", "%.1f MB", "%.1f GB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (value >= 1000 && unit + 1 < kUnits.size()) {
    value /= 1000;
    ++unit;
  }
  return formatted(kUnits[unit], value);
}

std::string packingText(const McapReader& mcap) {
  const Packing packing = mcap.packing();
  if (packing.compression.empty()) return "none";
  std::string text =
      packing.compression + ", " + std::to_string(packing.chunks) + (packing.chunks == 1 ? " chunk" : " chunks");
  if (packing.compression != "none" && packing.unpacked > 0) {
    text += ", " + sizeText(packing.unpacked) + " in " +
            formatted("%.1f %%", 100 * static_cast<double>(packing.packed) / static_cast<double>(packing.unpacked));
  }
  return text;
}

std::string textOf(const LogInfo& info, const LogFile& log) {
  std::string text = "file:        " + info.file + "\n";
  const McapReader* mcap = log.mcap();
  text += std::string("format:      ") + (mcap == nullptr ? "tlog" : "MCAP") + ", " + sizeText(info.size) + "\n";
  if (mcap != nullptr) {
    text += "compression: " + packingText(*mcap) + "\n";
    if (!mcap->profile().empty()) text += "profile:     " + mcap->profile() + "\n";
    if (!mcap->library().empty()) text += "written by:  " + mcap->library() + "\n";
  }
  if (info.range) {
    text += "start:       " + timeText(info.range->first) + "\nend:         " + timeText(info.range->last) +
            "\nduration:    " + formatted("%.3f s", info.duration) + "\n";
  }
  text += "messages:    " + std::to_string(info.messages) + "\n";
  text += "topics:      " + std::to_string(info.topics.size()) + "\n";
  std::size_t name = 0, type = 0, count = 0;
  for (const Topic& topic : info.topics) {
    name = std::max(name, topic.name.size());
    type = std::max(type, topic.type.size());
    count = std::max(count, std::to_string(topic.count).size());
  }
  const auto padded = [](const std::string& word, std::size_t width) {
    return std::string(width - std::min(width, word.size()), ' ');
  };
  for (const Topic& topic : info.topics) {
    const std::string number = std::to_string(topic.count);
    text += "  " + topic.name + padded(topic.name, name) + "  " + topic.type + padded(topic.type, type) + "  " +
            padded(number, count) + number;
    if (info.duration > 0) text += "  " + formatted("%9.2f Hz", rateOf(topic, info));
    text += "\n";
  }
  return text;
}

std::string jsonOf(const LogInfo& info, const LogFile& log) {
  nlohmann::ordered_json json = {
      {"file", info.file}, {"format", log.mcap() == nullptr ? "tlog" : "mcap"}, {"size", info.size}};
  if (const McapReader* mcap = log.mcap()) {
    const Packing packing = mcap->packing();
    json["compression"] = packing.compression;
    json["chunks"] = packing.chunks;
    json["packed_size"] = packing.packed;
    json["unpacked_size"] = packing.unpacked;
    json["profile"] = mcap->profile();
    json["library"] = mcap->library();
  }
  if (info.range) {
    json["start_ns"] = info.range->first;
    json["end_ns"] = info.range->last;
  }
  json["duration"] = info.duration;
  json["messages"] = info.messages;
  json["topics"] = nlohmann::ordered_json::array();
  for (const Topic& topic : info.topics) {
    json["topics"].push_back(
        {{"name", topic.name}, {"type", topic.type}, {"count", topic.count}, {"rate", rateOf(topic, info)}});
  }
  json["torn"] = info.torn ? nlohmann::ordered_json(*info.torn) : nlohmann::ordered_json();
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int tell(const InfoCommandLine& given) {
  const LogFile log(given.file);
  const LogInfo info = infoOf(given.file, log);
  cli::print(given.asJson ? jsonOf(info, log) : textOf(info, log));
  if (info.torn) cli::say("warning: " + *info.torn);
  return cli::kDone;
}

}  // namespace

void addInfoAction(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<InfoCommandLine>();
  CLI::App* action = program.add_subcommand("info", "Print a log's topics, types, counts, rates and times");
  action->add_option("FILE", given->file, "The log, .mcap or .tlog")->type_name("")->required();
  action->add_flag("--json", given->asJson, "Print JSON: an object");
  action->footer("Example:\n  pongsim log info run.mcap");
  action->callback([given, &work] { work = [given] { return tell(*given); }; });
}

}  // namespace pongsim::log
