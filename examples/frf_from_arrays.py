"""FRFs from arrays of force and acceleration, for a program that acquires its own data.

    python3 frf_from_arrays.py [MOBILITY.csv]

The signals are those of a synthetic wood bat: three hits, two accelerometers.
"""

import sys

import numpy as np
import percuss

made = percuss.synth("wood-bat").record
force_n, accel_mps2 = made.force_n[:3], made.accel_mps2[:3]  # (hits, samples), (hits, channels, samples)

frfs = percuss.frf(force_n, accel_mps2, fs=25600.0, band=(60, 1000))
response = np.abs(frfs.H[0, 0])  # point 0, channel 0
peak = int(np.argmax(response))
print(
    f"peak at {frfs.frequency_hz[peak]:.1f} Hz: {response[peak]:.1f} ± {frfs.std[0, 0, peak]:.2g} (m/s²)/N,"
    f" coherence {frfs.coherence[0, 0, peak]:.6f}"
)
mobility = percuss.frf(force_n, accel_mps2, fs=25600.0, band=(60, 1000), kind="mobility")
print(f"there the mobility is {abs(mobility.H[0, 0, peak]):.4f} (m/s)/N")

found = percuss.analyze(force_n, accel_mps2, fs=25600.0, band=(60, 1000), angle=(0, 90))
for frequency_hz, damping_ratio in zip(found.frequency_hz, found.damping_ratio):
    print(f"mode at {frequency_hz:.2f} Hz, damping ratio {damping_ratio:.5f}")
if len(sys.argv) > 1:
    mobility.save(sys.argv[1], force=True)
