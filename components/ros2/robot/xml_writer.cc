#include "ros2/robot/xml_writer.hh"

#include <charconv>
#include <cmath>

#include "pongsim/files/xml_text.hh"
#include "pongsim/math.hh"

namespace pongsim::ros2 {

namespace {

constexpr double kLargest = 1e9;

void append(double value, std::string& text) {
  if (std::isnan(value)) value = 0;
  if (std::isinf(value)) value = std::copysign(kLargest, value);
  char buffer[32];
  text.append(std::begin(buffer), std::to_chars(std::begin(buffer), std::end(buffer), value == 0 ? 0.0 : value).ptr);
}

}  // namespace

XmlWriter& XmlWriter::open(std::string_view element) {
  if (isTagOpen_) text_ += ">\n";
  text_.append(2 * elements_.size(), ' ').append("<").append(element);
  elements_.emplace_back(element);
  isTagOpen_ = true;
  return *this;
}

XmlWriter& XmlWriter::with(std::string_view attribute, std::string_view value) {
  text_.append(" ").append(attribute).append("=\"");
  appendXmlText(value, text_);
  text_ += '"';
  return *this;
}

XmlWriter& XmlWriter::with(std::string_view attribute, double value) {
  std::string text;
  append(value, text);
  return with(attribute, text);
}

XmlWriter& XmlWriter::with(std::string_view attribute, const Vector3& vector) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    if (i > 0) text += ' ';
    append(vector[i], text);
  }
  return with(attribute, text);
}

XmlWriter& XmlWriter::close() {
  const std::string element = std::move(elements_.back());
  elements_.pop_back();
  if (isTagOpen_) {
    text_ += "/>\n";
  } else {
    text_.append(2 * elements_.size(), ' ').append("</").append(element).append(">\n");
  }
  isTagOpen_ = false;
  return *this;
}

XmlWriter& XmlWriter::origin(const Pose& pose) {
  return open("origin").with("xyz", pose.position).with("rpy", exactRollPitchYawOf(pose.rotation)).close();
}

std::string XmlWriter::take() {
  while (!elements_.empty()) close();
  return std::move(text_);
}

Vector3 exactRollPitchYawOf(const Quaternion& rotation) {
  const Matrix3 matrix = rotation.toRotationMatrix();
  const double level = math::hypot(matrix(0, 0), matrix(1, 0));
  const double yaw = math::atan2(matrix(1, 0), matrix(0, 0));
  const double pitch = math::atan2(-matrix(2, 0), level);
  // the rotation that is left without yaw and pitch is about x, whatever yaw was chosen at a pitch of a quarter turn
  const Matrix3 rest = fromRollPitchYaw(0, pitch, yaw).toRotationMatrix().transpose() * matrix;
  return {math::atan2(rest(2, 1), rest(1, 1)), pitch, yaw};
}

}  // namespace pongsim::ros2
