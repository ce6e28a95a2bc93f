#!/usr/bin/env python3
"""Measures the time that the Python module adds to the library, for one small record.

Prints the shortest of many calls of each, in µs, and the difference. A test limits the difference to 100 µs.
"""

import time

import numpy as np

import percuss
from percuss import _percuss

REPEATS = 2000


def small_record():
    """One hit of 256 samples."""
    force, accel = np.zeros(256), np.random.default_rng(1).normal(size=(1, 256))
    force[20:30] = 100 * np.hanning(10)
    return percuss.Record(force, accel, fs=25600.0)


def shortest_s(call, repeats=REPEATS):
    """The shortest time of a call in seconds."""
    least = float("inf")
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        least = min(least, time.perf_counter() - start)
    return least


def measured(repeats=REPEATS):
    """Seconds of the library alone, and of the module's call."""
    record = small_record()
    library = _percuss.library_seconds(record._handle, repeats)
    return library, shortest_s(lambda: percuss.analyze(record, only="hits", threads=1), repeats)


if __name__ == "__main__":
    library_s, module_s = measured()
    print(f"library {1e6 * library_s:.1f} µs, percuss.analyze {1e6 * module_s:.1f} µs, overhead {1e6 * (module_s - library_s):.1f} µs")
    print(f"percuss.metrics.performance {1e6 * shortest_s(lambda: percuss.metrics.performance(length_in=34, weight_oz=31)):.1f} µs in all")
    print(f"percuss.models.shell {1e6 * shortest_s(percuss.models.shell):.1f} µs in all")
