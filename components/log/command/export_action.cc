#include <CLI/App.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "log/command/command.hh"
#include "log/command/export_rows.hh"
#include "log/command/log_file.hh"
#include "log/command/times.hh"
#include "log/store/failure.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::log {

namespace {

struct ExportCommandLine {
  std::string file;
  std::optional<std::string> topic, output, from, to;
  std::vector<std::string> fields;
  bool asJson = false, asCsv = false;
};

/// The output: stdout, or a new file.
class Lines {
 public:
  explicit Lines(const std::optional<std::string>& file) {
    if (!file) return;
    name_ = *file;
    file_.open(*file, std::ios::binary | std::ios::trunc);
    check();
  }
  void add(const std::string& text) {
    pending_ += text;
    if (pending_.size() >= kAtOnce) flush();
  }
  void flush() {
    if (name_.empty()) {
      cli::print(pending_);
    } else {
      file_ << pending_ << std::flush;
      check();
    }
    pending_.clear();
  }

 private:
  static constexpr std::size_t kAtOnce = 65536;

  void check() const {
    if (!file_) throw Failure("'" + name_ + "' can't be written: " + std::strerror(errno));
  }

  std::string name_, pending_;
  std::ofstream file_;
};

/// The rows of one topic, for each of its types.
class ExportTask {
 public:
  ExportTask(const ExportCommandLine& given, const LogFile& log) : given_(given), log_(log) {
    if (given.from) selection_.from = timeFrom("--from", *given.from);
    if (given.to) selection_.to = timeFrom("--to", *given.to);
    if (!given.topic) return;
    const std::string topic = requireTopic(log.reader(), given.file, *given.topic);
    selection_.topics = std::vector{topic};
    std::size_t types = 0;
    for (const Topic& each : log.reader().topics()) {
      if (each.name != topic) continue;
      ++types;
      rowsOf(each.name, each.type);
    }
    if (types > 1 && given.asCsv)
      throw Failure("'" + topic + "' has messages of several types, which do not fit in one table");
  }

  void run() {
    Lines lines(given_.output);
    if (given_.asCsv) lines.add(rows_.begin()->second.csvHeader());
    try {
      log_.reader().forEach(selection_, [&](const Record& record) {
        lines.add(rowsOf(record.topic, record.type).row(record.timeNs, record.payload));
        return true;
      });
    } catch (const Failure&) {
      // everything before the error has been printed
      lines.flush();
      throw;
    }
    lines.flush();
    if (const auto torn = log_.reader().torn()) cli::say("warning: " + *torn);
  }

 private:
  ExportRows& rowsOf(std::string_view topic, std::string_view type) {
    const std::pair<std::string, std::string> key(topic, type);
    const auto found = rows_.find(key);
    if (found != rows_.end()) return found->second;
    const Definition definition = log_.definition(topic, type);
    return rows_.emplace(key, ExportRows(definition, key.first, key.second, given_.fields, given_.asCsv)).first->second;
  }

  const ExportCommandLine& given_;
  const LogFile& log_;
  Selection selection_;
  std::map<std::pair<std::string, std::string>, ExportRows> rows_;
};

int exportLog(const ExportCommandLine& given) {
  if (given.asCsv && !given.topic) throw cli::UsageError("--csv needs a topic", "pongsim log export FILE TOPIC --csv");
  const LogFile log(given.file);
  ExportTask(given, log).run();
  return cli::kDone;
}

}  // namespace

void addExportAction(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<ExportCommandLine>();
  CLI::App* action = program.add_subcommand("export", "Print the messages of a log as CSV or as lines of JSON");
  action->add_option("FILE", given->file, "The log, .mcap or .tlog")->type_name("")->required();
  action->add_option("TOPIC", given->topic, "Only this topic (all; CSV needs one)")->type_name("");
  action->add_option("FIELD", given->fields, "Only these values, such as twist.linear.x or pose[0].position (all)")
      ->type_name("")
      ->expected(0, 1000);
  auto* json = action->add_flag("--json", given->asJson, "Lines of JSON, one object per message (default)");
  action->add_flag("--csv", given->asCsv, "A table: the time [s], then one column per value")->excludes(json);
  const auto text = [action](const char* names, std::optional<std::string>& to, const char* value, const char* help) {
    action
        ->add_option_function<std::string>(
            names, [&to](const std::string& word) { to = word; }, help)
        ->type_name(value);
  };
  text("-o,--output", given->output, "FILE", "Write to a file instead of standard output");
  text("--from", given->from, "S", "Only records from this time on [s]; 'info --json' prints the start in ns");
  text("--to", given->to, "S", "Only records up to this time [s]");
  action->footer(
      "Examples:\n"
      "  pongsim log export run.mcap /odom twist.linear.x --csv -o speed.csv\n"
      "  pongsim log export run.mcap /lidar");
  action->callback([given, &work] { work = [given] { return exportLog(*given); }; });
}

}  // namespace pongsim::log
