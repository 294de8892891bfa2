#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace pongsim::test {

/// Content of a drone's model in addition to its body and rotors.
struct DroneParts {
  std::string pose = "0 0 0 0 0 0";
  /// Content of each motor's `<plugin>`.
  std::string motor = {};
  /// Content of the model, after the motors.
  std::string rest = {};
};

/// Positions of the rotors on the body [m]; the first two turn anticlockwise.
inline constexpr std::array<std::array<double, 2>, 4> kDroneRotors{
    {{0.13, -0.2}, {-0.13, 0.2}, {0.13, 0.2}, {-0.13, -0.2}}};
/// Total mass [kg].
inline constexpr double kDroneMass = 1.5;
/// Default thrust of a rotor, divided by the square of its speed [N s^2/rad^2].
inline constexpr double kDroneThrust = 8.54858e-6;

/// @return Model "d": a body of 1.48 kg and four rotors of 5 g, whose motors listen to
/// /d/motor_speed.
inline std::string drone(const DroneParts& parts) {
  std::string text = "<model name='d'><pose>" + parts.pose +
                     "</pose><link name='body'><inertial><mass>1.48</mass><inertia><ixx>0.035</ixx><iyy>0.07</iyy>"
                     "<izz>0.098</izz></inertia></inertial></link>";
  for (std::size_t i = 0; i < kDroneRotors.size(); ++i) {
    const std::string number = std::to_string(i);
    text += "<link name='rotor" + number + "'><pose>" + std::to_string(kDroneRotors[i][0]) + " " +
            std::to_string(kDroneRotors[i][1]) +
            " 0.06 0 0 0</pose><inertial><mass>0.005</mass><inertia><ixx>4e-05</ixx><iyy>4e-05</iyy><izz>8e-05</izz>"
            "</inertia></inertial></link><joint name='joint" +
            number + "' type='revolute'><parent>body</parent><child>rotor" + number +
            "</child><axis><xyz>0 0 1</xyz></axis></joint>";
  }
  for (std::size_t i = 0; i < kDroneRotors.size(); ++i) {
    const std::string number = std::to_string(i);
    text +=
        "<plugin filename='ignition-gazebo-multicopter-motor-model-system' "
        "name='ignition::gazebo::systems::MulticopterMotorModel'><jointName>joint" +
        number + "</jointName><linkName>rotor" + number + "</linkName><motorNumber>" + number +
        "</motorNumber><turningDirection>" + (i < 2 ? "ccw" : "cw") +
        "</turningDirection><commandSubTopic>motor_speed</commandSubTopic>" + parts.motor + "</plugin>";
  }
  return text + parts.rest + "</model>";
}

}  // namespace pongsim::test
