"""What the long run takes for a fault."""

import threading
import types
import unittest

from daemon import Daemon, Fault, Footprint
from soak import FASTER, GROWTH, WAITING, WARM_UP, WARM_UP_PART, WINDOW, Bound, Record, WarmUp, go_on


class Hashes(unittest.TestCase):
    def test_of_a_kind_are_the_same_in_all_cycles(self):
        record = Record()
        record.check("w", "plain", ["a", "b"])
        record.check("w", "plain", ["a", "b"])
        record.check("w", "spawned", ["a", "c"])
        record.check("v", "plain", ["d", "e"])
        with self.assertRaisesRegex(Fault, "'w', cycle 'plain'"):
            record.check("w", "plain", ["x", "b"])

    def test_of_a_restored_state_are_those_of_the_plain_cycle(self):
        record = Record()
        record.check("w", "saved", ["b"])
        record.check("w", "plain", ["a", "b"])
        record.check("w", "loaded", ["b"])
        record.check("w", "interrupted", ["a", "b"])
        with self.assertRaises(Fault):
            record.check("w", "interrupted", ["x", "b"])

    def test_show_a_reset_that_was_missed(self):
        daemon = Daemon.__new__(Daemon)
        daemon._reading, daemon._end = threading.Condition(), None
        daemon._hashes = {"w": [(500, "a"), (750, "b")]}
        with self.assertRaisesRegex(Fault, "missed a reset"):
            daemon.hashes("w", [250, 500])


class Bounds(unittest.TestCase):
    def setUp(self):
        self.now = Footprint(100 << 20, 14, 15)
        self.bound = Bound("it", lambda: self.now, patience=0)
        self.bound.measure(is_warm=False)

    def measure(self, memory, is_warm=True, times=WINDOW):
        self.now = Footprint(memory, 14, 15)
        for _ in range(times):
            self.bound.measure(is_warm)

    def test_are_of_the_least_memory_of_the_warm_ups_last_window(self):
        self.measure(200 << 20, is_warm=False, times=10 * WINDOW)
        self.measure((200 << 20) + GROWTH)
        for _ in range(3):
            self.measure((220 << 20) + GROWTH, times=WINDOW - 1)
            self.measure((200 << 20) + GROWTH, times=1)
        with self.assertRaisesRegex(Fault, "memory of it grows"):
            self.measure((200 << 20) + GROWTH + 4096)

    def test_are_set_anew_whenever_the_run_is_twice_as_long(self):
        self.measure(200 << 20, is_warm=False)
        for times in WINDOW, 2 * WINDOW:
            self.measure(self.now.memory + GROWTH, times=times + 1)
        with self.assertRaisesRegex(Fault, "memory of it grows"):
            self.measure(self.now.memory + GROWTH + 4096)

    def test_find_what_grows_in_each_round(self):
        self.measure(200 << 20, is_warm=False)
        with self.assertRaisesRegex(Fault, "memory of it grows"):
            for _ in range(30 * WINDOW):
                self.measure(self.now.memory + GROWTH // (8 * WINDOW), times=1)

    def test_are_of_the_memory_at_any_time(self):
        self.measure(200 << 20, is_warm=False)
        self.measure((200 << 20) + WAITING, times=1)
        with self.assertRaisesRegex(Fault, "memory of it grows"):
            self.measure((200 << 20) + WAITING + 4096, times=1)

    def test_are_of_descriptors_and_threads(self):
        for now in Footprint(100 << 20, 15, 15), Footprint(100 << 20, 14, 14):
            self.now = now
            with self.assertRaisesRegex(Fault, "it takes"):
                self.bound.measure(is_warm=False)


class Warmth(unittest.TestCase):
    def test_comes_after_so_many_rounds(self):
        warm_up = WarmUp(now=0)
        self.assertTrue(warm_up.goes_on(now=WARM_UP, rounds=WARM_UP))
        self.assertFalse(warm_up.goes_on(now=WARM_UP + 10, rounds=WARM_UP + 10))

    def test_comes_after_a_part_of_the_run(self):
        warm_up = WarmUp(now=0, seconds=WARM_UP / WARM_UP_PART + 100)
        self.assertTrue(warm_up.goes_on(now=WARM_UP, rounds=WARM_UP))
        self.assertTrue(warm_up.goes_on(now=WARM_UP + 5, rounds=WARM_UP + 5))
        self.assertFalse(warm_up.goes_on(now=WARM_UP + 20, rounds=WARM_UP + 20))

    def test_begins_anew_where_rounds_come_faster_than_ever(self):
        warm_up = WarmUp(now=0)
        warm_up.goes_on(now=WARM_UP, rounds=WARM_UP)
        now, rounds = WARM_UP + 10, WARM_UP + 11
        self.assertFalse(warm_up.goes_on(now, rounds))
        faster = 20 * FASTER
        self.assertTrue(warm_up.goes_on(now + 20, rounds + faster + 1))
        # at that speed or slower, for as many rounds as in the first warm-up
        self.assertTrue(warm_up.goes_on(now + 1000, rounds + faster + 1 + WARM_UP))
        self.assertFalse(warm_up.goes_on(now + 1020, rounds + faster + 2 + WARM_UP + faster))


class Counted:
    """A long run in which something is measured in the third round."""

    def __init__(self):
        self.rounds = self.measures = 0

    def round(self):
        self.rounds += 1
        self.measures += self.rounds == 3

    def line(self, _):
        return ""

    def end(self):
        pass


class Run(unittest.TestCase):
    def test_goes_on_until_something_was_measured(self):
        soak = Counted()
        go_on(soak, None, types.SimpleNamespace(minutes=0, rounds=1, every=60))
        self.assertEqual(soak.rounds, 3)


if __name__ == "__main__":
    unittest.main()
