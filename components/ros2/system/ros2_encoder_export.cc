// Exports the encoder for recordings of ROS messages from the system's library.
#include "ros2/recording/ros2_encoder.hh"

PONGSIM_EXPORT_ENCODER(pongsim::ros2::Ros2Encoder::make);
