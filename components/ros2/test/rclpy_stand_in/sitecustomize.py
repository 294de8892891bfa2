"""Python imports this before any program: makes the message packages importable."""

import ros_messages

ros_messages.install()
