#include "msgs/types/described_types.hh"

#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/io/coded_stream.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace pongsim::msgs {

namespace {

namespace io = google::protobuf::io;

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open()) throw std::runtime_error("the message types in '" + file.string() + "' can't be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

DescribedTypes::DescribedTypes(const std::filesystem::path& file) : bytes_(contentOf(file)) {
  // a FileDescriptorSet: each file is a length-delimited field 1
  constexpr std::uint32_t kFileTag = google::protobuf::FileDescriptorSet::kFileFieldNumber << 3U | 2U;
  io::CodedInputStream stream(reinterpret_cast<const std::uint8_t*>(bytes_.data()), static_cast<int>(bytes_.size()));
  while (stream.CurrentPosition() < static_cast<int>(bytes_.size())) {
    std::uint32_t length = 0;
    const bool isFile = stream.ReadTag() == kFileTag && stream.ReadVarint32(&length);
    const char* const begin = bytes_.data() + stream.CurrentPosition();
    if (!isFile || !stream.Skip(static_cast<int>(length)) || !database_.Add(begin, static_cast<int>(length))) {
      throw std::runtime_error("'" + file.string() + "' does not describe message types");
    }
  }
}

}  // namespace pongsim::msgs
