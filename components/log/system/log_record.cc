#include "log/system/log_record.hh"

#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "log/system/leave_out.hh"
#include "pongsim/files/resolved_sdf.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/scene.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

namespace {

constexpr const char* kConsoleFile = "server_console.log";

const char* wordFor(LogLevel level) {
  switch (level) {
    case LogLevel::kError:
      return "[Err]";
    case LogLevel::kWarning:
      return "[Wrn]";
    case LogLevel::kInfo:
      return "[Msg]";
    default:
      return "[Dbg]";
  }
}

/// Prints a message on the terminal, regardless of the log level except none.
void say(const std::string& message) {
  if (logLevel() == LogLevel::kNone) return;
  const std::string line = "pongsim: " + message + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace

RecordSystem::~RecordSystem() {
  const bool isKnown = failure_.has_value();
  end();
  if (failure_ && !isKnown) log_->error(failure_->what());
}

void RecordSystem::declare(Declaration& declaration) {
  declaration.is("Records the world's state and topics into a folder, for LogPlayback.", Declaration::Place::kWorld);
  declaration.usesFiles();
  declaration.standsOutside();
  declaration.parameter("record_path", &path_, "", "folder of the recording")
      .otherwise("HOME/.ignition/gazebo/log/TIME");
  declaration.parameter(
      "record_topic", &topics_, "",
      "further topic to record; with any of * ? [ ] ( ) . it is a regular expression for whole names");
  declaration.parameter("record_period", &period_, "s", "minimum simulated time between two states; 0: each step")
      .atLeast(0);
  declaration.parameter("record_resources", &resources_, "", "copy meshes and textures into the folder");
  declaration.parameter("compress", &compress_, "", "pack the folder into a zip file at the end, and delete it");
  declaration.parameter("compress_path", &zipPath_, "", "that file").otherwise("PATH.zip");
  declaration.parameter("overwrite", &overwrite_, "", "delete a folder or zip file that is there already");
  declaration.parameter("keep_existing", &keepsExisting_, "", "record into PATH(1), PATH(2) and so on if PATH exists");
  declaration.publishes("/world/W/log/clock", "ignition.msgs.Clock", "the time by which messages are recorded");
  declaration.publishes("/FOLDER/sdf", "ignition.msgs.StringMsg", "the world, in SDF");
}

void RecordSystem::configure(const SystemContext& context) {
  log_ = &context.log;
  const bool isSecond =
      std::ranges::any_of(context.before, [](System* other) { return dynamic_cast<RecordSystem*>(other) != nullptr; });
  if (isSecond) refuse(context.sdf, "the world is already being recorded", "remove one of the two LogRecord systems");
  try {
    start(context);
  } catch (const Failure& why) {
    leaveOut(context, why.what(), why.hint());
  } catch (const std::invalid_argument& why) {
    leaveOut(context, std::string("<record_topic> ") + why.what());
  }
}

void RecordSystem::start(const SystemContext& context) {
  const WhereTaken where = overwrite_       ? WhereTaken::kDelete
                           : keepsExisting_ ? WhereTaken::kTakeAnother
                                            : WhereTaken::kReplaceFiles;
  const std::string world(context.world.name());
  if (context.sdf.attributeOr("beside_others", "") == "true") {
    worlds_ = WorldsFolder::join(path_, zipPath_, where);
    folder_ = worlds_->folderOf(world);
  } else {
    folder_ = makeRecordFolder(path_.empty() ? defaultRecordFolder() : fs::path(path_), zipPath_, where);
  }
  if (resources_) copies_.emplace(folder_.folder);
  sdfTopic_ = cleanTopic("/" + folder_.folder.filename().string() + "/sdf");
  ignition::msgs::StringMsg sdf;
  sdf.set_data(worldText(context));
  sdf_ = sdf.SerializeAsString();

  writer_ = std::make_unique<TlogWriter>(folder_.folder / kStateFile);
  topicRecorder_.emplace(context.node, topics_, *writer_, [this](const std::exception& why) {
    note(why);
    throw *failure_;
  });
  stateRecorder_.emplace(Scene(context.world), *writer_, cleanTopic("/world/" + world + "/changed_state"),
                         [this](const Message& step) {
                           if (copies_) copies_->addAllOf(step);
                         });
  clock_ = context.node.advertise<ignition::msgs::Clock>(cleanTopic("/world/" + world + "/log/clock"));
  sdfPublisher_ = context.node.advertise<ignition::msgs::StringMsg>(sdfTopic_, {.latched = true});
  sdfPublisher_->publish(sdf);
  startConsoleLog();
  isRecording_ = true;
  say("recording to " + (folder_.folder / kStateFile).string());
}

void RecordSystem::startConsoleLog() {
  console_.open(folder_.folder / kConsoleFile);
  sink_.emplace(LogLevel::kDebug, [this](const pongsim::LogRecord& record) {
    const std::lock_guard lock(consoleMutex_);
    console_ << wordFor(record.level) << " [" << record.speaker << "] " << record.message << std::endl;
  });
}

/// @return The world with everything that it includes, and with paths of files. They are replaced in the recording if
/// resources are recorded.
std::string RecordSystem::worldText(const SystemContext& context) {
  const SourcePosition position = context.world.sourcePosition();
  std::error_code error;
  std::optional<std::string> text;
  // its errors were reported when it was loaded
  Diagnostics known;
  if (position.file && fs::is_regular_file(*position.file, error)) text = resolvedSdf(*position.file, known);
  if (!text) {
    context.diagnostics.warning(context.sdf.position,
                                "the world's file can't be read again: the recording contains only the state");
    return "<sdf version='1.9'><world name='" + std::string(context.world.name()) + "'/></sdf>";
  }
  return withAddresses(*text, [&](const std::string& address) {
    const std::optional<fs::path> file = context.edits.resolve(address);
    if (!file) return address;
    if (copies_) copies_->add(*file);
    return fs::absolute(*file).string();
  });
}

void RecordSystem::preUpdate(const StepInfo& info) {
  if (!isRecording_) return;
  topicRecorder_->update(info.time);
  publishClock(info.time);
}

void RecordSystem::publishClock(Time time) {
  if (!clock_->hasSubscribers()) return;
  ignition::msgs::Clock message;
  setTime(time, *message.mutable_sim());
  clock_->publish(message);
}

void RecordSystem::postUpdate(const StepInfo& info) {
  if (!isRecording_ || info.paused) return;
  const Time period = fromSeconds(period_);
  const bool isDue = !last_ || info.time - *last_ >= period || stateRecorder_->hasNews();
  if (!isDue) return;
  last_ = info.time;
  try {
    if (!sdf_.empty()) {
      writer_->write({info.time.count(), sdfTopic_, "ignition.msgs.StringMsg", sdf_});
      sdf_.clear();
    }
    stateRecorder_->record();
  } catch (const Failure& why) {
    note(why);
    throw *failure_;
  }
}

void RecordSystem::reset() {
  // times in a log do not go back
  if (!isRecording_ || !last_) return;
  log_->warning("the world was reset: the recording ends here");
  end();
  if (failure_) throw *failure_;
}

void RecordSystem::finish() {
  end();
  if (failure_) throw *failure_;
}

void RecordSystem::note(const std::exception& why) {
  isRecording_ = false;
  if (failure_) return;
  const auto* const failure = dynamic_cast<const Failure*>(&why);
  const std::string hint = failure == nullptr || failure->hint().empty() ? "" : " (" + failure->hint() + ")";
  failure_.emplace(std::string("the recording is incomplete: ") + why.what() + hint);
}

void RecordSystem::end() {
  if (!writer_) return;
  try {
    complete();
  } catch (const std::exception& why) {
    note(why);
  }
  isRecording_ = false;
  sink_.reset();
  stateRecorder_.reset();
  writer_.reset();
  folder_.lock.reset();
}

void RecordSystem::complete() {
  // queued messages first
  topicRecorder_.reset();
  stateRecorder_->finish();
  writer_->close();
  sink_.reset();
  console_.close();
  if (!console_) throw Failure("'" + (folder_.folder / kConsoleFile).string() + "' can't be written");
  if (worlds_) {
    folder_.lock.reset();
    WorldsFolder::leave(std::move(worlds_), compress_);
  } else if (compress_) {
    packRecording(folder_);
  }
}

}  // namespace pongsim::log
