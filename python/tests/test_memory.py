"""A large survey is analysed without a second copy of its samples."""

import subprocess
import sys

import percuss

ROWS, CHANNELS, SAMPLES = 120, 1, 81920  # 150 MiB with the force

MAKE = f"""
import numpy as np, percuss
def peak_mib():  # of this program only; getrusage includes the size of its parent
    return next(int(line.split()[1]) for line in open("/proc/self/status") if line.startswith("VmHWM")) / 1024
rows, channels, samples = {ROWS}, {CHANNELS}, {SAMPLES}
fs = 25600.0
def fill(force, accel):
    t = np.arange(samples) / fs
    for row in range(rows):
        force[row] = 0
        force[row, 100:112] = 200 * np.hanning(12)
        for channel in range(channels):
            accel[row, channel] = 0
            for f in (165.0, 568.0):
                accel[row, channel, 106:] += np.cos(0.1 * row * f) * np.exp(-40 * t[:-106]) * np.sin(2 * np.pi * f * t[:-106])
"""

OF_ARRAYS = MAKE + """
force, accel = np.empty((rows, samples)), np.empty((rows, channels, samples))
fill(force, accel)
record = percuss.Record(force, accel, fs=fs, points=range(rows))
before = peak_mib()
found = percuss.survey(record, band=(60, 1500), effort="quick")
found.frf().H, found.shapes, found.frequency_hz
print((force.nbytes + accel.nbytes) / 2**20, before, peak_mib(), len(found.frequency_hz))
"""

OF_A_FILE = MAKE + """
before = peak_mib()
found = percuss.survey("survey.h5", band=(60, 1500), effort="quick")
print(before, peak_mib(), len(found.frequency_hz))
"""

OF_THE_TOOL = """
import resource, subprocess, sys
subprocess.run([sys.argv[1], "survey", "survey.h5", "--band", "60:1500", "--effort", "quick", "--json"], check=True, stdout=subprocess.DEVNULL)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024)
"""


def numbers(script, *words):
    ran = subprocess.run([sys.executable, "-c", script, *words], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    return [float(one) for one in ran.stdout.split()]


def test_a_survey_of_150_mib_is_not_copied(tool, record_property):
    from conftest import TOOL

    scripts = MAKE + "force, accel = np.empty((rows, samples)), np.empty((rows, channels, samples))\nfill(force, accel)\n"
    scripts += "percuss.write('survey.h5', percuss.Record(force, accel, fs=fs, points=range(rows)))\n"
    assert numbers(scripts) == []
    [tool_mib] = numbers(OF_THE_TOOL, str(TOOL))
    file_before_mib, file_mib, file_modes = numbers(OF_A_FILE)
    data_mib, before_mib, peak_mib, modes = numbers(OF_ARRAYS)
    assert data_mib > 149 and modes == file_modes == 2
    text = (
        f"{data_mib:.0f} MiB: the tool {tool_mib:.0f} MiB; the module {file_mib:.0f} MiB, of which Python {file_before_mib:.0f} MiB; "
        f"of arrays {peak_mib:.0f} MiB, of which {before_mib:.0f} MiB before the call"
    )
    print(text)
    record_property("peak", text)
    slack_mib = 40  # allocator overhead and the Python objects of the results
    assert file_mib - file_before_mib <= tool_mib + slack_mib
    assert peak_mib - before_mib <= tool_mib + slack_mib


def test_memory_is_released(bat):
    """Five hundred analyses need no more memory than the first hundred. The measured growth is 0 MiB. It would be
    81 MiB if each analysis leaked its FRFs, and 1172 MiB if each leaked its record."""
    max_growth_mib = 16  # of the allocator
    script = MAKE + (
        "test = percuss.synth('wood-bat').record\n"
        "def work(n):\n"
        "    for _ in range(n): percuss.analyze(test, only='hits').frf().at(0, 0)\n"
        "work(100); first = peak_mib(); work(400); print(peak_mib() - first)\n"
    )
    assert bat is not None and numbers(script)[0] < max_growth_mib
