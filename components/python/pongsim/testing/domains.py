"""Domains of DDS for runs side by side."""

from __future__ import annotations

import contextlib
import fcntl
import os
import struct
import tempfile
from typing import Iterator

#: Above 101, a domain's ports are those of outgoing connections.
_DOMAINS = 100
_F_OFD_SETLK = 37


@contextlib.contextmanager
def domain() -> Iterator[int]:
    """A domain from 1 to 100 that no other test of this user has, on this machine, until the end of the block."""
    path = os.path.join(tempfile.gettempdir(), f"pongsim-test-domains-{os.getuid()}")
    locks = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC | os.O_NOFOLLOW, 0o600)
    try:
        yield _lock(locks)
    finally:
        os.close(locks)


def _lock(locks: int) -> int:
    for i in range(_DOMAINS):
        number = 1 + (os.getpid() + i) % _DOMAINS
        try:
            # struct flock: type, whence, start, length, process
            fcntl.fcntl(locks, _F_OFD_SETLK, struct.pack("hhqqi4x", fcntl.F_WRLCK, os.SEEK_SET, number, 1, 0))
        except OSError:
            continue
        return number
    raise OSError(None, "all 100 domains are taken by other tests")
