#include "sim/inputs/recording.hh"

#include <cstring>
#include <exception>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

#include "base/hash.hh"
#include "base/regular_file.hh"

namespace pongsim::sim {

namespace {

/// Largest recording that is read.
constexpr std::uint64_t kLargest = std::uint64_t{16} << 30;
/// Before a frame's content: the size of the content, and the kind.
constexpr std::size_t kFrameHead = sizeof(std::uint64_t) + 1;
constexpr std::size_t kFrameTail = sizeof(std::uint64_t);

/// Writes or reads a list whose elements have no `transfer` of their own.
template <class Value, class Transfer>
void transferEach(StateArchive& archive, std::vector<Value>& list, const Transfer& transfer) {
  std::uint64_t size = list.size();
  archive(size);
  // each takes a byte at least
  archive.check(size <= archive.rest().size());
  if (archive.isGiving()) list.resize(size);
  for (Value& value : list) transfer(value);
}

void transferBytes(StateArchive& archive, std::vector<std::byte>& bytes) {
  std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  archive(text);
  if (!archive.isGiving()) return;
  const auto given = std::as_bytes(std::span(text.data(), text.size()));
  bytes.assign(given.begin(), given.end());
}

void transferPlace(StateArchive& archive, transport::Intake::Place& place) {
  archive(place.topic);
  archive(place.type);
  archive(place.subscription);
}

void transferIntake(StateArchive& archive, transport::Intake& intake) {
  using transport::Intake;
  transferEach(archive, intake.messages, [&archive](Intake::Message& message) {
    archive(message.position);
    transferPlace(archive, message.place);
    transferBytes(archive, message.bytes);
  });
  transferEach(archive, intake.left, [&archive](Intake::Left& left) {
    transferPlace(archive, left.place);
    archive(left.count);
  });
  transferEach(archive, intake.requests, [&archive](Intake::Request& request) {
    archive(request.position);
    archive(request.service);
    transferBytes(archive, request.bytes);
  });
}

void transferElement(StateArchive& archive, Element& element, int depth) {
  constexpr int kDeepest = 256;
  archive.check(depth < kDeepest);
  archive(element.name);
  archive(element.text);
  transferEach(archive, element.attributes, [&archive](Element::Attribute& attribute) {
    archive(attribute.name);
    archive(attribute.value);
  });
  transferEach(archive, element.children, [&](Element& child) { transferElement(archive, child, depth + 1); });
}

std::uint64_t checksumOf(std::span<const std::byte> bytes) {
  base::Hash hash;
  hash.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  return hash.value();
}

struct Frame {
  FrameKind kind;
  std::span<const std::byte> content;
};

std::uint64_t numberAt(std::span<const std::byte> bytes) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data(), sizeof number);
  return number;
}

/// @param bytes What is left of the file; without the frame afterwards.
/// @return The next frame; nothing if it is incomplete or damaged.
std::optional<Frame> takeFrame(std::span<const std::byte>& bytes) {
  if (bytes.size() < kFrameHead + kFrameTail) return std::nullopt;
  const std::uint64_t size = numberAt(bytes);
  if (size > bytes.size() - kFrameHead - kFrameTail) return std::nullopt;
  const std::span<const std::byte> checked = bytes.first(kFrameHead + size);
  if (numberAt(bytes.subspan(kFrameHead + size)) != checksumOf(checked)) return std::nullopt;
  const auto kind = static_cast<FrameKind>(bytes[sizeof(std::uint64_t)]);
  if (kind > FrameKind::kEnd) return std::nullopt;
  bytes = bytes.subspan(kFrameHead + size + kFrameTail);
  return Frame{kind, checked.subspan(kFrameHead)};
}

/// @return The tape of that world.
Tape& tapeOf(Recording& recording, std::uint32_t world) {
  if (world >= recording.tapes.size()) throw std::out_of_range("it has more worlds than it says");
  return recording.tapes[world];
}

/// @throws std::exception if the content is not what is written.
void addTo(Recording& recording, const Frame& frame) {
  StateArchive archive(frame.content);
  if (frame.kind == FrameKind::kStart) {
    archive(recording.start);
    recording.tapes.resize(recording.start.worlds.size());
  } else if (frame.kind == FrameKind::kPassage) {
    Passage passage;
    archive(passage);
    tapeOf(recording, passage.world).passages.push_back(std::move(passage));
  } else if (frame.kind == FrameKind::kState) {
    RecordedState state;
    archive(state);
    tapeOf(recording, state.world).states.push_back(std::move(state));
  } else if (frame.kind == FrameKind::kUnrecordedChange) {
    UnrecordedChange change;
    archive(change);
    tapeOf(recording, change.world).unrecordedAfter = change.steps;
  } else if (frame.kind == FrameKind::kWorldEnd) {
    WorldEnd end;
    archive(end);
    tapeOf(recording, end.world).endHash = end.stateHash;
  }
}

}  // namespace

void RunStart::File::transfer(StateArchive& archive) {
  archive(path);
  archive(hash);
}

void RunStart::transfer(StateArchive& archive) {
  archive(version);
  archive(file);
  archive(sdf);
  archive(files);
  archive(worlds);
  archive(onlyWorld);
  transferEach(archive, systems, [&archive](Element& element) { transferElement(archive, element, 0); });
  archive(seed);
  archive(levels);
  archive(allowPluginPaths);
  archive(paused);
}

void Passage::Run::transfer(StateArchive& archive) {
  archive(kind, Kind::kServe);
  archive(count);
}

void Passage::transfer(StateArchive& archive) {
  archive(world);
  archive(runs);
  transferEach(archive, intakes, [&archive](transport::Intake& intake) { transferIntake(archive, intake); });
  archive(folders);
  archive(changes);
  archive(hashes);
}

void RecordedState::transfer(StateArchive& archive) {
  archive(world);
  archive(steps);
  archive(values);
}

void UnrecordedChange::transfer(StateArchive& archive) {
  archive(world);
  archive(steps);
}

void WorldEnd::transfer(StateArchive& archive) {
  archive(world);
  archive(stateHash);
}

std::vector<std::byte> frameOf(FrameKind kind, std::vector<std::byte> content) {
  const std::uint64_t size = content.size();
  std::vector<std::byte> frame(kFrameHead + size + kFrameTail);
  std::memcpy(frame.data(), &size, sizeof size);
  frame[sizeof size] = static_cast<std::byte>(kind);
  if (size > 0) std::memcpy(frame.data() + kFrameHead, content.data(), size);
  const std::uint64_t checksum = checksumOf(std::span(frame).first(kFrameHead + size));
  std::memcpy(frame.data() + kFrameHead + size, &checksum, sizeof checksum);
  return frame;
}

bool isRecording(const std::filesystem::path& file) {
  const auto opened = base::RegularFile::open(file);
  const auto* regular = std::get_if<base::RegularFile>(&opened);
  std::string mark(kRecordingMark.size(), '\0');
  return regular != nullptr && regular->readAt(0, mark) == mark.size() && mark == kRecordingMark;
}

Outcome<Recording> readRecording(const std::filesystem::path& file) {
  const auto read = base::readRegularFile(file, kLargest);
  if (const auto* unreadable = std::get_if<base::Unreadable>(&read)) return {std::nullopt, unreadable->reason};
  const auto& text = std::get<std::string>(read);
  if (!text.starts_with(kRecordingMark)) return {std::nullopt, "is not a recording of inputs by this version"};
  std::span<const std::byte> bytes = std::as_bytes(std::span(text)).subspan(kRecordingMark.size());
  Recording recording;
  bool hasStart = false;
  try {
    while (true) {
      const std::optional<Frame> frame = takeFrame(bytes);
      if (!frame || hasStart == (frame->kind == FrameKind::kStart)) break;
      if (frame->kind == FrameKind::kEnd) return {std::move(recording), {}};
      addTo(recording, *frame);
      hasStart = true;
    }
  } catch (const std::exception& error) {
    return {std::nullopt, std::string("is not a sound recording of inputs: ") + error.what()};
  }
  if (!hasStart) return {std::nullopt, "is cut off before the run begins"};
  recording.cut = "it is cut off or damaged after " + std::to_string(text.size() - bytes.size()) + " bytes";
  return {std::move(recording), {}};
}

}  // namespace pongsim::sim
