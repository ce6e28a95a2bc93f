"""Analyses many records in one process, on several threads. A record that cannot be analysed does not end the batch.

    python3 in_process_batch.py [RECORD...]

Without records it makes eight tests of one bat, which differ in their noise.
"""

import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import percuss

records = sys.argv[1:] or [percuss.synth("wood-bat", seed=seed).record for seed in range(1, 9)]


def analyze(record):
    """The analysis of one record, or the error. Each analysis uses one thread."""
    try:
        return percuss.analyze(record, band=(60, 3200), effort="standard", threads=1)
    except percuss.InputError as error:
        return error


with ThreadPoolExecutor() as pool:
    results = list(pool.map(analyze, records))

first_hz = []
for index, found in enumerate(results):
    if isinstance(found, percuss.InputError):
        print(f"{index}: {found}")
    elif found.possible and len(found.frequency_hz) > 0:
        print(
            f"{index}: {len(found.frequency_hz)} modes, the first at"
            f" {found.frequency_hz[0]:.5f} ± {found.frequency_std_hz[0]:.5f} Hz"
        )
        first_hz.append(found.frequency_hz[0])
if len(first_hz) > 1:
    print(f"mean {np.mean(first_hz):.5f} Hz, scatter {np.std(first_hz, ddof=1):.5f} Hz")
