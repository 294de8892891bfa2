#include "xml_writer.hh"

#include <algorithm>
#include <utility>

#include "pongsim/files/xml_text.hh"

namespace pongsim {

std::string escaped(std::string_view text) {
  std::string allowed(text);
  std::ranges::replace_if(
      allowed, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n'; }, '?');
  return xmlText(allowed);
}

XmlWriter::XmlWriter(std::ostream& out) : out_(out) { out_ << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"; }

void XmlWriter::open(std::string_view name, Attributes attributes) {
  out_ << std::string(2 * names_.size(), ' ') << '<' << name;
  for (const auto& [key, value] : attributes) out_ << ' ' << key << "=\"" << escaped(value) << '"';
}

void XmlWriter::begin(std::string_view name, Attributes attributes) {
  open(name, attributes);
  out_ << ">\n";
  names_.emplace_back(name);
}

void XmlWriter::end() {
  const std::string name = std::move(names_.back());
  names_.pop_back();
  out_ << std::string(2 * names_.size(), ' ') << "</" << name << ">\n";
}

void XmlWriter::add(std::string_view name, Attributes attributes, std::string_view text) {
  open(name, attributes);
  if (text.empty()) {
    out_ << "/>\n";
  } else {
    out_ << '>' << escaped(text) << "</" << name << ">\n";
  }
}

}  // namespace pongsim
