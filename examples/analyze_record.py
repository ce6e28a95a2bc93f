"""Analyses one hammer test: hits, modes with their standard deviations, bending or hoop, a report.

    python3 analyze_record.py [RECORD [REPORT.html]]

Without RECORD it makes the test of a composite bat whose modes are known.
"""

import sys

import percuss

record = sys.argv[1] if len(sys.argv) > 1 else percuss.synth("composite-bat").record
found = percuss.analyze(record, band=(60, 3200))

# Findings explain why a hit is rejected; FRFs and modes use the accepted hits.
for hit in found["hits"]:
    print(f"hit {hit['index'] + 1}: {hit['peak_force_n']:5.0f} N, {'accepted' if hit['accepted'] else 'rejected'}")
    for finding in hit["findings"]:
        print(f"  {finding['message']}")
if not found.possible:
    sys.exit(1)

for mode in found["modes"]:
    print(
        f"{mode['frequency_hz']:10.4f} ± {mode['frequency_std_hz']:.4f} Hz"
        f"  {100 * mode['damping_ratio']:.4f} %  {mode['family']} {mode['order']}"
    )
for warning in found["warnings"]:
    print(f"! {warning['message']}")

if len(sys.argv) > 2:
    found.save(sys.argv[2], force=True)
