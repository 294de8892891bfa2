"""Processes without an identity of the keystore, or without permission, can't list, subscribe, publish or call."""

import os
import unittest

from secured import PATIENCE, Place, until

# Time limits for commands that wait for discovery and authentication, which on a busy machine take longer than the
# default of a second.
SECONDS = ("--timeout", str(PATIENCE / 2))
MILLISECONDS = ("--timeout", str(int(PATIENCE * 500)))

ODOMETRY = "/model/pong_bot/odometry"
CONTROL = "/world/pong_world/control"


class Access(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = Place()
        cls.addClassCleanup(cls.place.close)
        cls.place.world("--secure", "keys")

    def secured(self, *words, name="keys", code=0):
        return self.place.run(*words, "--secure", name, code=code)

    def test_an_identity_lists_hears_publishes_and_calls(self):
        until(lambda: ODOMETRY in self.secured("topic", "-l").splitlines(), "a list with the odometry")
        self.assertIn("pong_bot/odom", self.secured("topic", "-e", "-t", ODOMETRY, "-n", "1"))
        self.secured("topic", "-t", "/cmd_vel", "-m", "Twist", "-p", "linear: {x: 0.1}", *SECONDS)
        self.assertIn("data: true", self.secured("service", "-s", CONTROL, "--req", "pause: false", *MILLISECONDS))
        self.assertIn("pong_bot", self.secured("model", "--list", *MILLISECONDS))
        self.assertIn("iterations", self.secured("world", "stats", "-n", "1", *MILLISECONDS))
        until(lambda: CONTROL in self.place.run("service", "-l", PONGSIM_SECURITY="keys/pongsim"), "a list of services")

    def no_entry(self, **environment):
        """Checks that a process with this environment, without a valid identity, gets no access."""
        run = self.place.run
        self.assertEqual(run("topic", "-l", **environment), "")
        self.assertEqual(run("service", "-l", **environment), "")
        self.assertIn("no service", run("service", "-s", CONTROL, "--req", "pause: true", code=1, **environment))
        self.assertIn("no subscriber", run("topic", "-t", "/cmd_vel", "-m", "Twist", "-p", "", code=1, **environment))
        for topic in ("/clock", ODOMETRY):
            run("topic", "wait", "-t", topic, "--timeout", "2", code=1, **environment)

    def test_who_is_not_secured_is_alone(self):
        self.no_entry()

    def test_a_foreign_authority_is_none(self):
        self.place.run("security", "init", "foreign")
        # the leak sanitizer needs complete stacks to recognize Fast DDS's leak of refused certificates:
        # test/support/lsan.supp
        sanitizer = os.environ.get("ASAN_OPTIONS", "") + ":fast_unwind_on_malloc=0"
        self.no_entry(PONGSIM_SECURITY="foreign", ASAN_OPTIONS=sanitizer)

    def test_the_secured_hear_nothing_of_the_others(self):
        publisher = self.place.start("topic", "-t", "/open", "-m", "StringMsg", "-p", "data: 'x'", "--rate", "20",
                                     *SECONDS)
        listener = self.place.start("topic", "-e", "-t", "/open", "-n", "1")
        until(lambda: "data" in listener.output(), "a message among the open ones")
        self.assertNotIn("/open", self.secured("topic", "-l"))
        self.secured("topic", "wait", "-t", "/open", "--timeout", "1", code=1)
        publisher.kill()

    def test_permissions_count_for_each_topic(self):
        run = self.place.run
        run("security", "add", "viewer", "--keystore", "keys", "--allow-subscribe", ODOMETRY, "--allow-call", "/none")
        self.assertIn("position", self.secured("topic", "-e", "-t", ODOMETRY, "-n", "1", name="keys/viewer"))
        said = self.secured("topic", "-e", "-t", "/clock", "-n", "1", name="keys/viewer", code=1)
        self.assertIn("identity '/viewer' may not subscribe to topic '/clock'", said)
        self.assertIn("hint: 'pongsim security list'", said)
        said = self.secured("topic", "-t", "/cmd_vel", "-m", "Twist", "-p", "", name="keys/viewer", code=1)
        self.assertIn("identity '/viewer' may not publish topic '/cmd_vel'", said)
        said = self.secured("service", "-s", CONTROL, "--req", "pause: true", name="keys/viewer", code=1)
        self.assertIn("may not", said)

    def test_an_identity_that_may_call_calls(self):
        self.place.run("security", "add", "caller", "--keystore", "keys", "--allow-call", "/world/*")
        said = self.secured("service", "-s", CONTROL, "--req", "pause: false", *MILLISECONDS, name="keys/caller")
        self.assertIn("data: true", said)

    def test_a_mistake_ends_the_run_before_it_starts(self):
        said = self.place.run("run", "--secure", "nowhere", code=1)
        self.assertEqual(said, "pongsim: error: there is no keystore at 'nowhere'\n"
                               "  hint: 'pongsim security init nowhere' makes one\n")
        said = self.place.run("run", code=1, PONGSIM_SECURITY="keys/nobody")
        self.assertIn("keystore 'keys' has no identity 'nobody', but ", said)
        self.place.run("run", "--secure", code=2)

    def test_only_a_run_without_it_warns_that_a_network_is_open(self):
        def said(*words):
            process = self.place.start("run", "-z", "0", "--iterations", "1", "--network", address, *words)
            process.wait(timeout=PATIENCE)
            return process.said()

        import socket
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            try:
                # connect of a UDP socket sends nothing, and shows the local address of the route
                probe.connect(("198.51.100.1", 9))
            except OSError:
                self.skipTest("this machine has no network")
            address = probe.getsockname()[0]
        self.assertIn("anybody there can command it, since topics are not secured", said())
        secured = said("--secure", "keys")
        self.assertIn("for identities of its keystore", secured)
        self.assertNotIn("anybody", secured)


if __name__ == "__main__":
    unittest.main(verbosity=2)
