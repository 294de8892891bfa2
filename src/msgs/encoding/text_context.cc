#include "msgs/encoding/text_context.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

#include <vector>

namespace pongsim::msgs {

namespace {

namespace protobuf = google::protobuf;
using Tokenizer = protobuf::io::Tokenizer;

class Silent : public protobuf::io::ErrorCollector {
  void AddError(int, int, const std::string&) override {}
};

/// One pair of braces.
struct Level {
  const protobuf::Descriptor* type = nullptr;
  const protobuf::FieldDescriptor* field = nullptr;
  std::string opener{};
  std::string name{};
  bool inValue = false;
  bool inList = false;
};

void readSymbol(char symbol, std::vector<Level>& levels) {
  Level& level = levels.back();
  switch (symbol) {
    case ':':
      level.inValue = true;
      break;
    case '[':
      level.inList = level.inValue;
      break;
    case ']':
      level.inList = level.inValue = false;
      break;
    case '{':
    case '<': {
      level.inValue = level.inList;
      const protobuf::Descriptor* type = level.field == nullptr ? nullptr : level.field->message_type();
      levels.push_back({.type = type, .opener = level.name});
      break;
    }
    case '}':
    case '>':
      if (levels.size() > 1) levels.pop_back();
      break;
    default:
      break;
  }
}

}  // namespace

TextContext contextOf(std::string_view text, const protobuf::Descriptor& root, TokenPosition end) {
  protobuf::io::ArrayInputStream stream(text.data(), static_cast<int>(text.size()));
  Silent silent;
  Tokenizer tokenizer(&stream, &silent);
  tokenizer.set_comment_style(Tokenizer::SH_COMMENT_STYLE);
  tokenizer.set_allow_f_after_float(true);
  tokenizer.set_require_space_after_number(false);
  tokenizer.set_allow_multiline_strings(true);

  TextContext context;
  std::vector<Level> levels = {{.type = &root}};
  while (tokenizer.Next()) {
    const Tokenizer::Token& token = tokenizer.current();
    const TokenPosition position{token.line, token.column};
    if (position >= end) break;
    Level& level = levels.back();
    if (token.type == Tokenizer::TYPE_SYMBOL) {
      // The sign belongs to the number.
      if (token.text != "-") readSymbol(token.text[0], levels);
    } else if (level.inValue || token.type != Tokenizer::TYPE_IDENTIFIER) {
      context.lastValue = position;
      level.inValue = level.inList;
    } else {
      context.lastName = position;
      level.name = token.text;
      level.field = level.type == nullptr ? nullptr : level.type->FindFieldByName(token.text);
    }
  }
  context.type = levels.back().type;
  context.field = levels.back().field;
  context.opener = levels.back().opener;
  return context;
}

}  // namespace pongsim::msgs
