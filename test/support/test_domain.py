"""DDS domains for tests in Python, shared out with those of test_domain.cc."""

import fcntl
import os
import struct
import tempfile

DOMAINS = 100
F_OFD_SETLK = 37


def take_domain():
    """A domain from 1 to 100 that no other test process of this user has, for this process's life."""
    locks = os.open(os.path.join(tempfile.gettempdir(), f"pongsim-test-domains-{os.getuid()}"), os.O_RDWR | os.O_CREAT, 0o600)
    for i in range(DOMAINS):
        domain = 1 + (os.getpid() + i) % DOMAINS
        try:
            # struct flock: type, whence, start, length, process
            fcntl.fcntl(locks, F_OFD_SETLK, struct.pack("hhqqi4x", fcntl.F_WRLCK, os.SEEK_SET, domain, 1, 0))
        except OSError:
            continue
        return domain
    raise RuntimeError("all test domains are taken")
