"""Several Python threads may use the module at once, without deadlocks, leaks or mixed results."""

import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import percuss

BAND = (60, 3200)
ROUNDS = 150  # for each thread


def open_files():
    return len(os.listdir("/proc/self/fd"))


def children():
    with open(f"/proc/self/task/{os.getpid()}/children", encoding="ascii") as file:
        return file.read().split()


def test_four_threads_read_foreign_files(tool, bat):
    """Sandboxed files are read in forked processes; a lock that another thread holds at the fork stays locked in the child."""
    kinds = ["h5", "csv", "uff", "mat"]
    short = percuss.Record(bat.record.force_n[:2, :4096], bat.record.accel_mps2[:2, :, :4096], bat.record.fs_hz)
    for kind in kinds:
        percuss.write(f"bat.{kind}", short)
    wanted = {kind: percuss.analyze(f"bat.{kind}", band=BAND, effort="quick").json for kind in kinds}
    before, readers = open_files(), children()

    def work(first):
        for i in range(ROUNDS):
            kind = kinds[(first + i) % len(kinds)]
            assert percuss.analyze(f"bat.{kind}", band=BAND, effort="quick").json == wanted[kind]
            np.linalg.norm(np.random.default_rng(i).normal(size=1000))  # uses memory and locks of its own
        return first

    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(work, range(4), timeout=300)) == [0, 1, 2, 3]
    assert open_files() == before
    assert children() == readers


def test_several_threads_may_share_a_result(bat):
    found = percuss.analyze(bat.record, band=BAND, only="hits")
    with ThreadPoolExecutor(4) as pool:
        many = list(pool.map(lambda _: (found.frf().at(0, 0).sum(), found.frequency_hz.tolist(), found.confidence.tolist() == []), range(40)))
    assert all(one == many[0] for one in many)


def test_the_interpreter_lock_is_released(bat):
    """Another thread keeps counting during a computation."""
    counted, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.0005)

    thread = threading.Thread(target=count)
    thread.start()
    record = percuss.Record(np.tile(bat.record.force_n, (4, 1)), np.tile(bat.record.accel_mps2, (4, 1, 1)), bat.record.fs_hz)
    start, at_start = time.perf_counter(), counted[0]
    for _ in range(4):
        percuss.analyze(record, band=BAND, effort="best", per_hit=True)
    seconds, steps = time.perf_counter() - start, counted[0] - at_start
    done.set()
    thread.join()
    # The thread counts up to 2000 steps a second. If a call held the lock, it would count only between the calls.
    assert steps >= 20 * seconds, f"{steps} steps in {seconds:.2f} s"


def test_processes_forked_by_python_compute(tool, bat):
    bat.save("bat.h5")
    wanted = percuss.analyze("bat.h5", band=BAND, threads=1, effort="quick").json
    script = (
        "import multiprocessing, sys, percuss\n"
        "def work(_): return percuss.analyze('bat.h5', band=(60, 3200), threads=1, effort='quick').json\n"
        "work(0)\n"
        "with multiprocessing.get_context('spawn' if len(sys.argv) > 1 else 'fork').Pool(2) as pool:\n"
        "    print(*set(pool.map(work, range(8))), sep='', end='')\n"
    )
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120, check=False)
    assert ran.stdout == wanted, ran.stderr


@pytest.mark.parametrize("delay_s", [0.02, 0.1, 0.3])
def test_an_interrupt_raises_keyboard_interrupt(tool, bat, delay_s):
    bat.save("bat.h5")
    script = (
        "import percuss, signal\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # a shell without job control starts background jobs with SIGINT ignored
        "print('begun', flush=True)\n"
        "try:\n"
        "    found = None\n"  # Python 3.11 may raise the interrupt of the loop here, so this line lies in the try block
        "    while True: found = percuss.analyze('bat.h5', band=(60, 3200))\n"
        "except KeyboardInterrupt: pass\n"
        "print(len(percuss.analyze('bat.h5', band=(60, 3200)).frequency_hz))\n"
    )
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "begun\n"
        time.sleep(delay_s)
        process.send_signal(signal.SIGINT)
        try:
            out, err = process.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            process.kill()
            raise
    assert out == "3\n", err


def test_nothing_is_printed(tool, bat, capfd):
    bat.save("bat.h5")
    percuss.analyze("bat.h5", band=BAND, trace=True, explain=True)
    open("none.csv", "w").close()
    percuss.info("bat.h5", "none.csv")
    percuss.write("bat.wav", bat)
    percuss.models.beam(support="free")
    percuss.example("synth")
    percuss.presets()
    assert capfd.readouterr() == ("", "")
