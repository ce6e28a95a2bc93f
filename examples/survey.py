"""Mode shapes from a test of many points, and which modes are alike (MAC).

    python3 survey.py [RECORD GEOMETRY.csv [SHAPES.csv]]

Without RECORD it makes the test of a barrel that is struck at 24 points; that record holds its geometry.
"""

import sys

import percuss

record = sys.argv[1] if len(sys.argv) > 1 else percuss.synth("roving-barrel").record
geometry = sys.argv[2] if len(sys.argv) > 2 else None
found = percuss.survey(record, geometry=geometry, band=(60, 3200))
if not found.possible:
    sys.exit(1)

for frequency_hz, shape in zip(found.frequency_hz, found.shapes):
    print(f"{frequency_hz:9.3f} Hz at {len(shape)} places, largest component {max(abs(shape)):.3f}")

# Off the diagonal, a MAC near 1 means that two modes have the same shape.
for row in found.mac:
    print(" ".join(f"{mac:6.3f}" for mac in row))
if len(sys.argv) > 3:
    found.save(sys.argv[3], force=True)
