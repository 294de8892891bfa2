#include "core/added_systems.hh"

#include <memory>
#include <string>
#include <tuple>

namespace pongsim::python {

namespace py = pybind11;

namespace {

SourcePosition positionFrom(const py::handle& given) {
  const auto parts = given.cast<py::tuple>();
  SourcePosition position;
  position.file = std::make_shared<const std::string>(parts[0].cast<std::string>());
  position.line = parts[1].cast<int>();
  position.column = parts[2].cast<int>();
  return position;
}

Element elementFrom(const py::handle& given) {
  const auto parts = given.cast<py::tuple>();
  Element element;
  element.name = parts[0].cast<std::string>();
  element.position = positionFrom(parts[1]);
  for (const py::handle& attribute : parts[2]) {
    const auto [name, value, at] = attribute.cast<std::tuple<std::string, std::string, py::tuple>>();
    element.attributes.push_back({name, value, positionFrom(at)});
  }
  element.children = elementsFrom(parts[3]);
  return element;
}

}  // namespace

std::vector<Element> elementsFrom(const py::handle& given) {
  std::vector<Element> elements;
  for (const py::handle& each : given) elements.push_back(elementFrom(each));
  return elements;
}

}  // namespace pongsim::python
