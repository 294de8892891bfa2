#include "log/command/decoder.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>

#include <limits>

#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

namespace protobuf = google::protobuf;

/// Collects the errors in the description of a type.
class FirstError final : public protobuf::DescriptorPool::ErrorCollector {
 public:
  void AddError(const std::string&, const std::string& element, const protobuf::Message*, ErrorLocation,
                const std::string& message) override {
    if (text_.empty()) text_ = element + ": " + message;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

class ProtobufDecoder : public Decoder {
 public:
  const Message& decode(std::string_view payload) override {
    if (payload.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()) ||
        !message_->ParseFromArray(payload.data(), static_cast<int>(payload.size()))) {
      throw Failure("its " + std::to_string(payload.size()) + " bytes are not of type " + message_->GetTypeName());
    }
    return *message_;
  }
  const Message& prototype() const override { return *message_; }
  std::string jsonOf(const Message& message) const override { return messageJson(message); }

 protected:
  MessagePointer message_;
};

class KnownDecoder final : public ProtobufDecoder {
 public:
  explicit KnownDecoder(const std::string& type) {
    message_ = newMessage(type);
    if (message_ == nullptr || message_->GetTypeName() != type) {
      throw Failure("the message type '" + type + "' is unknown, and the log does not describe it");
    }
  }
};

/// For a type described in the file.
class DescribedDecoder final : public ProtobufDecoder {
 public:
  DescribedDecoder(const std::string& schema, const std::string& type) {
    protobuf::FileDescriptorSet set;
    if (!set.ParseFromString(schema)) throw Failure("the log's description of '" + type + "' is damaged");
    FirstError error;
    for (const protobuf::FileDescriptorProto& file : set.file()) {
      if (pool_.FindFileByName(file.name()) != nullptr) continue;
      if (pool_.BuildFileCollectingErrors(file, &error) == nullptr) {
        throw Failure("the log's description of '" + type + "' is damaged: " + error.text());
      }
    }
    const protobuf::Descriptor* descriptor = pool_.FindMessageTypeByName(type);
    if (descriptor == nullptr) throw Failure("the log's description of '" + type + "' lacks that type");
    message_ = MessagePointer(factory_.GetPrototype(descriptor)->New());
  }
  // the message is destroyed before its type
  ~DescribedDecoder() override { message_.reset(); }
  DescribedDecoder(const DescribedDecoder&) = delete;
  DescribedDecoder& operator=(const DescribedDecoder&) = delete;

 private:
  protobuf::DescriptorPool pool_;
  protobuf::DynamicMessageFactory factory_{&pool_};
};

}  // namespace

std::unique_ptr<Decoder> makeDecoder(const Definition& definition, const std::string& type) {
  if (definition.messageEncoding != "protobuf") {
    throw Failure("messages of '" + type + "' can't be read: their encoding is '" + definition.messageEncoding +
                      "', not protobuf",
                  definition.messageEncoding == "cdr" ? "read it with the tools of ROS 2" : "");
  }
  if (definition.schemaEncoding == "protobuf") return std::make_unique<DescribedDecoder>(definition.schema, type);
  return std::make_unique<KnownDecoder>(type);
}

}  // namespace pongsim::log
