#include "core/steering.hh"

#include <google/protobuf/message.h>

#include <array>
#include <cstring>
#include <utility>

#include "core/errors.hh"
#include "core/field_setter.hh"
#include "core/topics.hh"

namespace pongsim::python {

namespace {

void checkAxis(const Joint& joint) {
  if (joint.axisCount() == 0) {
    throw py::value_error("joint '" + std::string(joint.name()) + "' has no axis that can be driven");
  }
}

}  // namespace

Steering messageSteering(const std::shared_ptr<Life>& life, const std::string& topic, const std::string& type,
                         const std::vector<std::string>& paths) {
  struct Speaker {
    Publisher publisher;
    MessagePointer message;
    std::vector<FieldSetter> fields;
  };
  const std::string full = typeFor(*life, topic, type);
  auto speaker = std::make_shared<Speaker>();
  for (const std::string& path : paths) speaker->fields.emplace_back(full, path);
  speaker->publisher = life->use().transport().node().advertise(topic, full);
  speaker->message = newMessage(full);
  return {.size = paths.size(),
          .apply =
              [speaker](const double* numbers) {
                for (const FieldSetter& field : speaker->fields) field.set(*speaker->message, *numbers++);
                speaker->publisher.publish(*speaker->message);
              },
          .isForEachStep = false};
}

Steering velocitySteering(PyJoint& joint) {
  checkAxis(joint.use());
  return {.size = 1,
          .apply = [joint = joint.use()](const double* number) mutable { joint.setVelocityTarget(*number); },
          .isForEachStep = false};
}

Steering positionSteering(PyJoint& joint, std::shared_ptr<Memory> gains) {
  checkAxis(joint.use());
  return {.size = 1,
          .apply =
              [joint = joint.use(), gains = std::move(gains)](const double* target) mutable {
                std::array<double, 2> now{};
                std::memcpy(now.data(), gains->bytes.data(), sizeof now);
                const auto [stiffness, damping] = now;
                joint.addForce(stiffness * (*target - joint.position()) - damping * joint.velocity());
              },
          .isForEachStep = true};
}

Steering forceSteering(PyJoint& joint) {
  checkAxis(joint.use());
  return {.size = 1,
          .apply = [joint = joint.use()](const double* number) mutable { joint.addForce(*number); },
          .isForEachStep = true};
}

}  // namespace pongsim::python
