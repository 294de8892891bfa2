#include "scaling_field.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

#include "pongsim/parameters.hh"

namespace pongsim {

namespace {

/// @return The number in an attribute; `fallback` without it.
double attributeNumber(const Element& element, const std::string& name, double fallback) {
  const Element::Attribute* attribute = element.attribute(name);
  if (attribute == nullptr) return fallback;
  Element text;
  text.name = name;
  text.text = attribute->value;
  text.position = attribute->position;
  const double value = text.as<double>();
  if (std::isnan(value)) refuse(text, name + " must be a number");
  return value;
}

double finiteOf(const Element& element, double value) {
  if (!std::isfinite(value)) refuse(element, "<" + element.name + "> must be a finite number");
  return value;
}

}  // namespace

ScalingField::Interval ScalingField::intervalOf(const Element& when, char axis) {
  const std::string prefix(1, axis);
  for (const char* side : {"g", "l"}) {
    if (when.attribute(prefix + side + "e") != nullptr && when.attribute(prefix + side + "t") != nullptr) {
      refuse(when, "<when> has " + prefix + side + "e and " + prefix + side + "t: one of them is enough");
    }
  }
  Interval interval;
  interval.hasFrom = when.attribute(prefix + "ge") != nullptr;
  interval.hasTo = when.attribute(prefix + "le") != nullptr;
  interval.from = attributeNumber(when, prefix + (interval.hasFrom ? "ge" : "gt"), interval.from);
  interval.to = attributeNumber(when, prefix + (interval.hasTo ? "le" : "lt"), interval.to);
  return interval;
}

ScalingField::Piece ScalingField::pieceOf(const Element& element) {
  Piece piece;
  if (element.children.empty()) {
    piece.polynomials[0][3] = finiteOf(element, element.as<double>());
    return piece;
  }
  if (const Element* factor = element.child("k")) piece.factor = finiteOf(*factor, factor->as<double>());
  constexpr std::array<const char*, 3> kNames{"px", "qy", "rz"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Element* given = element.child(kNames[axis]);
    if (given == nullptr) continue;
    std::istringstream stream(given->text);
    for (double& coefficient : piece.polynomials[axis]) {
      Element word;
      word.name = given->name;
      word.position = given->position;
      if (!(stream >> word.text)) refuse(*given, "<" + given->name + "> needs four numbers");
      coefficient = finiteOf(word, word.as<double>());
    }
  }
  return piece;
}

ScalingField::ScalingField(const Element& element) {
  const std::vector<const Element*> whens = element.childrenNamed("when");
  if (whens.empty()) pieces_.push_back(pieceOf(element));
  for (const Element* when : whens) {
    Piece piece = pieceOf(*when);
    for (std::size_t axis = 0; axis < 3; ++axis) piece.region[axis] = intervalOf(*when, "xyz"[axis]);
    pieces_.push_back(piece);
  }
}

double ScalingField::at(const Vector3& position) const {
  const auto coordinate = [&position](std::size_t axis) { return position[static_cast<Eigen::Index>(axis)]; };
  for (const Piece& piece : pieces_) {
    double sum = 0;
    bool isIn = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = coordinate(axis);
      const Polynomial& c = piece.polynomials[axis];
      isIn = isIn && piece.region[axis].contains(x);
      sum += ((c[0] * x + c[1]) * x + c[2]) * x + c[3];
    }
    if (isIn) return std::max(0.0, piece.factor * sum);
  }
  return 0;
}

}  // namespace pongsim
