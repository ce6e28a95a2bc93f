"""Modal analysis of hammer tests: natural frequencies, damping and mode shapes, with standard deviations.

Make a synthetic test with known modes, and find them:

    >>> import percuss
    >>> test = percuss.synth("wood-bat")                       # synthetic, with its truth
    >>> found = percuss.analyze(test.record, band=(60, 3200))
    >>> for f, s, z in zip(found.frequency_hz, found.frequency_std_hz, found.damping_ratio):
    ...     print(f"{f:8.2f} Hz, known to {s:.0e} Hz, damping {100 * z:.2f} %")
      165.00 Hz, known to 4e-05 Hz, damping 1.00 %
      568.00 Hz, known to 4e-05 Hz, damping 0.70 %
     1177.00 Hz, known to 4e-05 Hz, damping 0.60 %

Analyse your own data from a file, or from arrays in memory, which are not copied:

    found = percuss.analyze("bat.h5", band=(60, 3200))
    found = percuss.analyze(force, accel, fs=25600.0)          # N and m/s²; (hits, samples), (hits, channels, samples)

A result holds arrays and a JSON document:

    found.frequency_hz, found.damping_ratio     (modes,)
    found.table, found.to_dataframe()           columns with a row per mode
    found.poles, found.residues                 (modes,) rad/s and (modes, points, channels) 1/kg, complex
    found.frf()                                 frequency_hz (lines,), and H (points, channels, lines) in (m/s²)/N
    found.synthesise(freq_hz)                   the FRFs of the modes, at any frequencies
    found.hits, found.modes, found.warnings     lists of dictionaries
    found.to_dict()                             the document that `percuss analyze … --json` prints
    found.report("bat.html")                    writes the HTML page; found.save("modes.uff") writes other formats
    found.plot(), found.plot("stabilisation")   pictures, with matplotlib

Functions:

    read, info, write          read records and FRFs: HDF5, MAT, UFF, LabVIEW, sound, CSV; write all but LabVIEW
    Record, Frf                make a record, or frequency responses, from arrays
    analyze, frf, survey       identify modes, average FRFs, identify mode shapes
    nodes, deflect, calibrate  locate nodes, compute deflection under an impact, calibrate a hammer
    synth, presets             make synthetic tests
    models                     beam, impact, rigid, trampoline, bat, shell
    metrics                    performance, certify, abi, study
    compare, mac               compare tests and models side by side; modal assurance criterion
    example                    return example input files

Keywords are the options of the command line with underscores (`--accel-channel` is accel_channel), with the same
defaults and checks. A band is a tuple (low, high). A keyword with several values takes a sequence.
help(percuss.analyze) lists the keywords of analyze. Unusable data raise percuss.InputError, a ValueError with the
attributes problem, where, remedy and options.

Functions release Python's lock and may be called by several threads. Ctrl-C stops a call of the main thread; calls of other threads
end by themselves, or at the end of the interpreter if they are daemon threads. MAT, HDF5 and sound files are read in sandboxed
processes, so a hostile file cannot harm this one.
"""

from __future__ import annotations

from ._percuss import version as __version__

from ._analyses import Analysis
from ._errors import InputError, NoHitError, UsageError
from ._examples import example, presets
from ._frf import Frf
from ._functions.analyze import analyze
from ._functions.calibrate import calibrate
from ._functions.compare import compare
from ._functions.deflect import deflect
from ._functions.frf import frf
from ._functions.info import info
from ._functions.nodes import nodes
from ._functions.read import read
from ._functions.survey import survey
from ._functions.synth import synth
from ._mac import mac
from ._records import Record
from ._results import Deflection, Nodes, Result, Synthetic
from ._surveys import Survey
from ._tests import AveragedFrf
from ._write import write
from . import metrics, models

__all__ = [
    "Analysis", "AveragedFrf", "Deflection", "Frf", "InputError", "NoHitError", "Nodes", "Record", "Result", "Survey",
    "Synthetic", "UsageError", "analyze", "calibrate", "compare", "deflect", "example", "frf", "info", "mac", "metrics", "models",
    "nodes", "presets", "read", "survey", "synth", "write",
]  # fmt: skip

for _one in (
    Analysis, AveragedFrf, Deflection, Frf, InputError, NoHitError, Nodes, Record, Result, Survey, Synthetic, UsageError,
    example, mac, presets, write,
):  # fmt: skip
    _one.__module__ = "percuss"  # the public name
del _one
