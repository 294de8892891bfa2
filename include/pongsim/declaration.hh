#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/export.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A parameter of a system: an element in its `<plugin>`, the variable for its value, and its meaning.
class PONGSIM_API Parameter {
 public:
  /// The variable for the value; its initial value is the default. An `optional` shows whether the parameter was given,
  /// a `vector` takes all elements of the name, `monostate` is for an element that the system reads itself.
  using Target = std::variant<std::monostate, double*, int*, bool*, std::string*, Vector3*, std::optional<double>*,
                              std::vector<double>*, std::vector<std::string>*>;

  /// @param unit "m/s", or empty.
  Parameter(std::string name, Target target, std::string unit, std::string text);

  // Constraints on the value. Each function returns the parameter itself.

  /// The parameter must be given; otherwise the system is left out.
  Parameter& required();
  /// Must be greater than `bound`.
  Parameter& above(double bound);
  /// Must be `bound` or greater.
  Parameter& atLeast(double bound);
  /// Must be `bound` or less.
  Parameter& atMost(double bound);
  /// Allows infinity; otherwise numbers must be finite.
  Parameter& mayBeInfinite();
  /// Must be one of these words.
  Parameter& oneOf(std::vector<std::string> words);
  /// Describes the default in the documentation if the initial value does not: "/model/M/cmd_vel".
  Parameter& otherwise(std::string fallback);
  /// Makes the documentation show one row for consecutive parameters of the same family instead of their names:
  /// "{xyz}{UVW}" for xU, xV and so on.
  Parameter& inFamily(std::string pattern);

  const std::string& name() const { return name_; }
  const std::string& unit() const { return unit_; }
  const std::string& text() const { return text_; }
  bool isRequired() const { return isRequired_; }
  /// Whether the element may occur several times.
  bool isRepeated() const;
  /// @return "number", "whole number", "true or false", "text", "three numbers", or "element".
  std::string type() const;
  /// @return The default as text; empty if there is none.
  const std::string& fallback() const { return fallback_; }
  /// @return The family's pattern; empty without one.
  const std::string& family() const { return family_; }

  /// Reads the value from `plugin` into the target. An empty element counts as not given.
  /// @throws Error with the position of an invalid value.
  void read(const Element& plugin) const;

 private:
  void readElement(const Element& element) const;
  double number(const Element& element) const;
  std::string word(const Element& element) const;

  std::string name_;
  Target target_;
  std::string unit_;
  std::string text_;
  std::string fallback_;
  std::string family_;
  bool isRequired_ = false;
  bool isFinite_ = true;
  std::optional<double> above_;
  std::optional<double> atLeast_;
  std::optional<double> atMost_;
  std::vector<std::string> words_;
};

/// A topic on which a system publishes readings of each sensor of a type.
struct SensorReadings {
  // Kinds with a meaning of their own.
  /// Distances along beams: an ignition.msgs.LaserScan.
  static constexpr const char* kRanges = "ranges";
  /// Points: an ignition.msgs.PointCloudPacked.
  static constexpr const char* kPoints = "points";
  /// Colours or brightness: an ignition.msgs.Image.
  static constexpr const char* kImage = "image";
  /// Distances along the x axis [m]: an ignition.msgs.Image of 32-bit floating-point numbers.
  static constexpr const char* kDepth = "depth";
  /// Any other message.
  static constexpr const char* kMessage = "message";

  /// Type of the `<sensor>`.
  std::string sensorType;
  /// What programs call the readings: one of the above, or another word.
  std::string kind = kMessage;
  /// Of the sensor's default topic (`Sensor::topic`).
  std::string suffix = {};
  /// Appended to the sensor's topic, default or not.
  std::string behind = {};
  /// Full name.
  std::string messageType = {};
};

/// A system's description of itself: its place, parameters, topics and services. It is used to read the parameters, for
/// `pongsim plugin -i`, and for the documentation.
class PONGSIM_API Declaration {
 public:
  enum class Place { kAnywhere, kWorld, kModel, kActor };

  /// A topic or a service. In its name, W, M, L, J and S stand for the names of the world, model, link, joint and
  /// sensor, and `<topic>` for the value of that parameter.
  struct Endpoint {
    enum class Kind { kPublished, kSubscribed, kService };
    Kind kind;
    std::string name;
    /// Full name of the message type; for a service, of the request.
    std::string type;
    /// Full name of a service's reply type.
    std::string replyType;
    std::string text;
  };

  /// @param text What the system does, in a sentence.
  /// @param place Where its `<plugin>` belongs.
  void is(std::string text, Place place);

  /// Adds a parameter, whose target must outlive this.
  /// @param text Its meaning in a few words, without a full stop.
  Parameter& parameter(std::string name, Parameter::Target target, std::string unit, std::string text);
  /// Adds an element that the system reads itself.
  Parameter& element(std::string name, std::string text);

  /// Allows several systems of this kind to publish on one topic; otherwise that is a warning.
  void sharesTopics() { sharesTopics_ = true; }

  /// Says that the system reads or writes files that its parameters or the world name. Then it is left out of models
  /// and worlds from outside: see `InsertOptions::isFromOutside`.
  void usesFiles() { usesFiles_ = true; }

  /// Says that the system stands outside the simulated world, which it connects with other programs or records: what it
  /// publishes and requests is input of the world. A replay of a run leaves it out.
  void standsOutside() { isOutside_ = true; }

  void publishes(std::string topic, std::string type, std::string text);
  void subscribes(std::string topic, std::string type, std::string text);
  void serves(std::string service, std::string requestType, std::string replyType, std::string text);

  /// Adds readings that programs find by the sensor's type (`Simulation::readings`). The topic is documented by
  /// `publishes`.
  void measures(SensorReadings readings) { readings_.push_back(std::move(readings)); }

  /// Says that the system reads sensors of a type itself: then there is no warning that nothing simulates them.
  void reads(std::string sensorType) { readTypes_.push_back(std::move(sensorType)); }

  const std::string& text() const { return text_; }
  Place place() const { return place_; }
  const std::deque<Parameter>& parameters() const { return parameters_; }
  bool topicsAreShared() const { return sharesTopics_; }
  bool hasFiles() const { return usesFiles_; }
  bool isOutside() const { return isOutside_; }
  const std::vector<Endpoint>& endpoints() const { return endpoints_; }
  const std::vector<SensorReadings>& readings() const { return readings_; }
  const std::vector<std::string>& readTypes() const { return readTypes_; }

  /// Reads all parameters and warns about unknown elements.
  /// @param system The system's name, for messages.
  /// @return Whether all values are valid; otherwise `diagnostics` has the errors.
  bool read(const Element& plugin, std::string_view system, Diagnostics& diagnostics) const;

 private:
  void warnOfUnknown(const Element& plugin, std::string_view system, Diagnostics& diagnostics) const;

  std::string text_;
  Place place_ = Place::kAnywhere;
  bool sharesTopics_ = false;
  bool usesFiles_ = false;
  bool isOutside_ = false;
  // references to its elements are given away
  std::deque<Parameter> parameters_;
  std::vector<Endpoint> endpoints_;
  std::vector<SensorReadings> readings_;
  std::vector<std::string> readTypes_;
};

}  // namespace pongsim
