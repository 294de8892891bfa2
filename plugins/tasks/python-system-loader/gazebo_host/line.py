"""Runs a system that is written for Gazebo's Python modules, for pongsim's PythonSystemLoader.

pongsim and this program take turns on a socket, whose number is the second argument: a call is answered when the system
has returned, and meanwhile the system's questions and commands go the other way. A line is one of them: words between
tabs. The other arguments are the module's name and the folders in which it is looked for.
"""

import sys

# the present folder is no place for modules
sys.path[:] = [folder for folder in sys.path if folder]

import re
import socket


class Line:
    """Words to and from pongsim."""

    def __init__(self, number):
        self.stream = socket.socket(fileno=number).makefile("rwb")

    def write(self, *words):
        escaped = (str(w).replace("\\", "\\\\").replace("\t", "\\t").replace("\n", "\\n") for w in words)
        self.stream.write("\t".join(escaped).encode(errors="replace") + b"\n")
        self.stream.flush()

    def read(self):
        """None at the end."""
        line = self.stream.readline().decode(errors="replace")
        if not line.endswith("\n"):
            return None
        plain = {"t": "\t", "n": "\n"}
        return [re.sub(r"\\(.)", lambda m: plain.get(m[1], m[1]), word) for word in line[:-1].split("\t")]

    def ask(self, *words):
        self.write("ask", *words)
        answer = self.read()
        if answer is None:
            sys.exit(0)
        if answer[0] != "ok":
            raise RuntimeError(answer[1])
        return answer[1:]


line = None


def numbers(words):
    return [float(word) for word in words]
