// What recordings in the encoding of ROS 2 are made with, in the library of the system.
#include "ros2/recording/ros2_encoder.hh"

PONGSIM_EXPORT_ENCODER(pongsim::ros2::Ros2Encoder::make);
