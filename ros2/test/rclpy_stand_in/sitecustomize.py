"""Python imports this before any program: messages are there as if their packages were installed."""

import ros_messages

ros_messages.install()
