"""Ctrl-C stops a computation soon, and the process and its results stay usable."""

import subprocess
import sys
import time

import pytest

import percuss

SOON_S = 2.0  # the module looks for signals every 20 ms; the rest is for a busy machine

HEAD = """
import signal, time, numpy as np, percuss
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell without job control starts background jobs with SIGINT ignored
def timed(call):
    begun = time.monotonic()
    try: call()
    except KeyboardInterrupt: print("stopped", time.monotonic() - begun, flush=True)
    else: print("ended", time.monotonic() - begun, flush=True)
"""
MANY = "many = percuss.Record(np.tile(r.force_n, (40, 1)), np.tile(r.accel_mps2, (40, 1, 1)), r.fs_hz)\n"
SPEC = """
modes = [{"frequency_hz": 100 + 90 * i, "damping_ratio": 0.001, "family": "bending", "order": i + 1, "residue_per_kg": [0.3]} for i in range(20)]
spec = {"schema": "percuss/synth/1", "name": "long", "fs_hz": 25600, "duration_s": 30, "hits": 40, "modes": modes,
        "structure": {"length_m": 0.84, "barrel_m": 0.33, "mass_kg": 0.85, "inertia_kgm2": 0.045, "cm_m": 0.378},
        "sensors": [{"position_m": 0.05, "angle_deg": 0}], "impact": {"position_m": 0.15, "angle_deg": 0},
        "pulse": {"kind": "haversine", "width_s": 0.00025, "peak_n": 300}, "noise": {"force": 1e-4, "accel": 1e-3}}
"""
# Each call takes seconds on two cores: an interrupt that acts only between two calls would come too late.
LONG = {
    "analyze": "percuss.analyze(many, band=(60, 3200), per_hit=True)",
    "several tests": "percuss.analyze([many] * 4, files='tests', band=(60, 3200), per_hit=True)",
    "reading a result": "percuss.analyze(many, band=(60, 3200), only='hits').residues",
    "a synthetic test": "percuss.synth(spec)",
    "a long row": "percuss.synth({**spec, 'hits': 1, 'duration_s': 600})",
    "a model": "percuss.models.impact(sweep={'ei': '1000:1:6000'}, modes=60)",
}


@pytest.fixture(scope="module")
def modes():
    """The number of modes that an undisturbed process finds."""
    return len(percuss.analyze(percuss.synth("composite-bat").record, band=(60, 3200), effort="quick").frequency_hz)


@pytest.mark.parametrize("name", LONG)
def test_an_interrupt_stops_a_computation(name, modes):
    script = HEAD + "r = percuss.synth('composite-bat').record\n" + MANY + SPEC + f"def work():\n    while True: {LONG[name]}\n"
    script += "print('begun', flush=True)\ntimed(work)\nprint(len(percuss.analyze(r, band=(60, 3200), effort='quick').frequency_hz))\n"
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "begun\n"
        time.sleep(1)
        process.send_signal(2)
        sent = time.monotonic()
        line = process.stdout.readline().split()
        took_s = time.monotonic() - sent
        out, err = process.communicate(timeout=60)
    assert line[:1] == ["stopped"] and took_s < SOON_S, (line, took_s, err)
    assert int(out) == modes > 0 and not err


def test_the_interpreter_ends_while_a_daemon_thread_computes():
    script = HEAD + "import threading\nr = percuss.synth('composite-bat').record\n" + MANY + "def work():\n    while True: " + LONG["analyze"]
    script += "\nthreading.Thread(target=work, daemon=True).start()\ntime.sleep(1)\nprint('end', flush=True)\n"
    ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
    assert ended.stdout == "end\n" and ended.returncode == 0, ended
