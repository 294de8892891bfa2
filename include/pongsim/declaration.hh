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

/// One parameter of a system: an element below its `<plugin>`, where its value goes, and what it means.
class PONGSIM_API Parameter {
 public:
  /// Where the value goes. What stands there at first is the default. An `optional` tells whether the parameter is
  /// given, a `vector` takes all elements of the name, and nothing is for an element that the system reads itself.
  using Target = std::variant<std::monostate, double*, int*, bool*, std::string*, Vector3*, std::optional<double>*,
                              std::vector<double>*, std::vector<std::string>*>;

  /// @param unit "m/s", or empty.
  Parameter(std::string name, Target target, std::string unit, std::string text);

  // What holds for the value. Each gives back the parameter itself.

  /// Without it the system is left out.
  Parameter& required();
  /// More than `bound`.
  Parameter& above(double bound);
  /// `bound` or more.
  Parameter& atLeast(double bound);
  /// `bound` or less.
  Parameter& atMost(double bound);
  /// Infinity is a value too; numbers must be finite otherwise.
  Parameter& mayBeInfinite();
  /// One of these words.
  Parameter& oneOf(std::vector<std::string> words);
  /// What pages say of the default, where the value at first does not tell: "/model/M/cmd_vel".
  Parameter& otherwise(std::string fallback);
  /// Pages show one row for all parameters of that family that follow each other, in place of their names:
  /// "{xyz}{UVW}" for xU, xV and so on.
  Parameter& inFamily(std::string pattern);

  const std::string& name() const { return name_; }
  const std::string& unit() const { return unit_; }
  const std::string& text() const { return text_; }
  bool isRequired() const { return isRequired_; }
  /// Whether the element may stand there several times.
  bool isRepeated() const;
  /// @return "number", "whole number", "true or false", "text", "three numbers", or "element".
  std::string type() const;
  /// @return The default as text; empty where there is none.
  const std::string& fallback() const { return fallback_; }
  /// @return The family's pattern; empty where it stands for itself.
  const std::string& family() const { return family_; }

  /// Puts what stands below `plugin` into the target. An element without text is as one that is not there.
  /// @throws Error naming the position of a value that can't be used.
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

/// What a system says of itself: where it stands, its parameters, what it speaks of. Its parameters are read with it,
/// `pongsim plugin -i` prints it, and so do the pages of the documentation.
class PONGSIM_API Declaration {
 public:
  enum class Place { kAnywhere, kWorld, kModel, kActor };

  /// A topic or a service. In its name stand W, M, L, J and S for the names of the world, model, link, joint and
  /// sensor, and `<topic>` for what that parameter says.
  struct Way {
    enum class Kind { kPublished, kSubscribed, kService };
    Kind kind;
    std::string name;
    /// Full name of the message type; of the request for a service.
    std::string type;
    /// Of a service's reply.
    std::string replyType;
    std::string text;
  };

  /// @param text What the system does, in a sentence.
  /// @param place What its `<plugin>` stands in.
  void is(std::string text, Place place);

  /// Adds a parameter, whose target must outlive this.
  /// @param text What it means, in a few words, without a full stop.
  Parameter& parameter(std::string name, Parameter::Target target, std::string unit, std::string text);
  /// Adds an element that the system reads itself.
  Parameter& element(std::string name, std::string text);

  /// Systems of this kind may well publish on one topic; of others a second one on a topic is warned of.
  void sharesTopics() { sharesTopics_ = true; }

  void publishes(std::string topic, std::string type, std::string text);
  void subscribes(std::string topic, std::string type, std::string text);
  void serves(std::string service, std::string requestType, std::string replyType, std::string text);

  const std::string& text() const { return text_; }
  Place place() const { return place_; }
  const std::deque<Parameter>& parameters() const { return parameters_; }
  bool topicsAreShared() const { return sharesTopics_; }
  const std::vector<Way>& ways() const { return ways_; }

  /// Reads all parameters and warns of elements that are none.
  /// @param system Its name, for the messages.
  /// @return Whether all could be used; else `diagnostics` says of each why not.
  bool read(const Element& plugin, std::string_view system, Diagnostics& diagnostics) const;

 private:
  void warnOfUnknown(const Element& plugin, std::string_view system, Diagnostics& diagnostics) const;

  std::string text_;
  Place place_ = Place::kAnywhere;
  bool sharesTopics_ = false;
  // references to its elements are given away
  std::deque<Parameter> parameters_;
  std::vector<Way> ways_;
};

}  // namespace pongsim
