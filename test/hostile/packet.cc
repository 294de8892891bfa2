#include "hostile/packet.hh"

namespace pongsim::hostile {

Packet::Packet(const Prefix& source) : bytes_{'R', 'T', 'P', 'S', 2, 3, 1, 0x0f} { addPrefix(source); }

void Packet::addNumber(std::uint64_t number, int size) {
  for (int i = 0; i < size; ++i) bytes_.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

void Packet::addEntity(EntityId id) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes_.push_back(static_cast<std::uint8_t>(id >> shift));
}

void Packet::addSequence(std::int64_t number) {
  const auto bits = static_cast<std::uint64_t>(number);
  addNumber(bits >> 32, 4);
  addNumber(bits & 0xffffffff, 4);
}

void Packet::addSequenceSet(std::int64_t base, std::uint32_t bits) {
  addSequence(base);
  add32(bits);
  for (std::uint32_t i = 0; i < (bits + 31) / 32 && i < 8; ++i) add32(0xffffffff);
}

void Packet::begin(Kind kind, std::uint8_t flags) {
  add8(static_cast<std::uint8_t>(kind));
  add8(static_cast<std::uint8_t>(flags | 1));
  open_.push_back(bytes_.size());
  add16(0);
}

void Packet::beginData(EntityId reader, EntityId writer, std::int64_t sequence, std::uint8_t flags) {
  begin(Kind::kData, flags);
  add16(0);
  add16(16);
  addEntity(reader);
  addEntity(writer);
  addSequence(sequence);
}

void Packet::beginParameter(std::uint16_t id) {
  add16(id);
  open_.push_back(bytes_.size());
  add16(0);
}

void Packet::endParameter(std::optional<std::uint16_t> length) {
  while ((bytes_.size() - open_.back() - 2) % 4 != 0) add8(0);
  close(length);
}

void Packet::close(std::optional<std::uint16_t> length) {
  const std::size_t place = open_.back();
  open_.pop_back();
  const std::uint16_t told = length.value_or(static_cast<std::uint16_t>(bytes_.size() - place - 2));
  bytes_[place] = static_cast<std::uint8_t>(told);
  bytes_[place + 1] = static_cast<std::uint8_t>(told >> 8);
}

void Packet::addText(std::uint16_t id, std::string_view text) {
  beginParameter(id);
  add32(static_cast<std::uint32_t>(text.size() + 1));
  bytes_.insert(bytes_.end(), text.begin(), text.end());
  add8(0);
  endParameter();
}

void Packet::addNumberParameter(std::uint16_t id, std::uint32_t number) {
  beginParameter(id);
  add32(number);
  endParameter();
}

void Packet::addGuid(std::uint16_t id, const Prefix& prefix, EntityId entityId) {
  beginParameter(id);
  addPrefix(prefix);
  addEntity(entityId);
  endParameter();
}

void Packet::addLocator(std::uint16_t id, std::uint32_t address, std::uint32_t port) {
  constexpr std::uint32_t kUdpV4 = 1;
  beginParameter(id);
  add32(kUdpV4);
  add32(port);
  addZeros(12);
  addEntity(address);
  endParameter();
}

void Packet::addSentinel() {
  add16(1);
  add16(0);
}

Packet goodbye(const Prefix& prefix) {
  constexpr std::uint16_t kKeyHash = 0x70, kStatus = 0x71;
  // status of an instance: disposed and unregistered, big-endian
  constexpr std::uint32_t kGone = 0x03000000;
  Packet packet(prefix);
  packet.beginData(entity::kSpdpReader, entity::kSpdpWriter, 2, kInlineQos);
  packet.addGuid(kKeyHash, prefix, entity::kParticipant);
  packet.addNumberParameter(kStatus, kGone);
  packet.addSentinel();
  packet.end();
  return packet;
}

}  // namespace pongsim::hostile
