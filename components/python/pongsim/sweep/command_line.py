"""What the commands of this package say on the command line, `pongsim sweep` and `pongsim test` alike."""

from __future__ import annotations

import argparse
import sys
from typing import NoReturn

#: Exit code for a wrong command line.
MISUSED = 2


class Parser(argparse.ArgumentParser):
    """Says what is wrong with a command line in the words of the program's other commands."""

    def error(self, message: str) -> NoReturn:
        print(f"{self.prog}: error: {message}", file=sys.stderr)
        print(f"Run with --help for more: {self.prog} --help", file=sys.stderr)
        sys.exit(MISUSED)


def say_error(command: str, text: object) -> None:
    """Prints an error of a command, "sweep"; one with a position in a file starts with that, as everywhere."""
    words = str(text)
    print(words if ": error: " in words else f"pongsim {command}: error: {words}", file=sys.stderr)
