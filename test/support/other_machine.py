"""A second machine for tests: a network namespace of its own, joined to this one by a pair of interfaces."""

import os
import pathlib
import shutil
import subprocess

HERE, THERE = "198.51.100.1", "198.51.100.2"
#: Runs a program on the other machine.
ON_THE_OTHER = ("ip", "netns", "exec", "other")

# A user namespace, in which any user may create interfaces.
_NAMESPACES = ["unshare", "--user", "--map-root-user", "--net", "--mount"]
_SET_UP = f"""
set -e
mount -t tmpfs none /run
ip link set lo up
ip netns add other
ip link add here type veth peer name there netns other
ip address add {HERE}/24 dev here
ip link set here up
ip netns exec other ip link set lo up
ip netns exec other ip address add {THERE}/24 dev there
ip netns exec other ip link set there up
exec "$@"
"""


class Unavailable(Exception):
    """No namespaces can be made, as in a chroot and in some containers."""


def beside_another(words, **environment):
    """Runs a command on a machine beside another one. Raises Unavailable, and AssertionError where a tool is missing."""
    for tool in ("ip", "unshare"):
        assert shutil.which(tool) or pathlib.Path("/usr/sbin", tool).exists(), f"{tool} is not installed"
    environment = {**os.environ, "PATH": os.environ["PATH"] + ":/usr/sbin:/sbin", **environment}
    possible = subprocess.run([*_NAMESPACES, "true"], env=environment, capture_output=True, text=True, timeout=60)
    if possible.returncode != 0:
        raise Unavailable(f"no namespaces can be made here: {possible.stderr.strip()}")
    return subprocess.run([*_NAMESPACES, "bash", "-c", _SET_UP, "bash", *words], env=environment, capture_output=True,
                          text=True, timeout=300)
