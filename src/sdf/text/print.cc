#include "sdf/text/print.hh"

#include <tinyxml2.h>

namespace pongsim::sdf {

namespace {

/// Indents by two spaces.
class Printer : public tinyxml2::XMLPrinter {
 protected:
  void PrintSpace(int depth) override {
    for (int i = 0; i < depth; ++i) Write("  ");
  }
};

void print(const Element& element, Printer& printer) {
  printer.OpenElement(element.name.c_str());
  for (const Element::Attribute& attribute : element.attributes) {
    printer.PushAttribute(attribute.name.c_str(), attribute.value.c_str());
  }
  if (!element.text.empty()) printer.PushText(element.text.c_str());
  for (const Element& child : element.children) print(child, printer);
  printer.CloseElement();
}

}  // namespace

std::string printDocument(const Element& root) {
  Printer printer;
  printer.PushHeader(false, true);
  print(root, printer);
  return printer.CStr();
}

std::string printChildren(const Element& element) {
  std::string text;
  for (const Element& child : element.children) {
    // a printer for each, because one for all would put empty lines between top-level elements
    Printer printer;
    print(child, printer);
    text += printer.CStr();
  }
  return text;
}

}  // namespace pongsim::sdf
