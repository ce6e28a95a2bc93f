"""Hammer tests of structures: natural frequencies, damping and mode shapes, each with its standard deviation.

Start with a test whose modes are known, and find them:

    >>> import percuss
    >>> test = percuss.synth("wood-bat")                       # made up, with its truth
    >>> found = percuss.analyze(test.record, band=(60, 3200))
    >>> for f, s, z in zip(found.frequency_hz, found.frequency_std_hz, found.damping_ratio):
    ...     print(f"{f:8.2f} Hz, known to {s:.0e} Hz, damping {100 * z:.2f} %")
      165.00 Hz, known to 4e-05 Hz, damping 1.00 %
      568.00 Hz, known to 4e-05 Hz, damping 0.70 %
     1177.00 Hz, known to 4e-05 Hz, damping 0.60 %

Your own data come from a file, or from arrays in memory, which are not copied:

    found = percuss.analyze("bat.h5", band=(60, 3200))
    found = percuss.analyze(force, accel, fs=25600.0)          # N and m/s²; (hits, samples), (hits, channels, samples)

What a result holds is arrays and a document:

    found.frequency_hz, found.damping_ratio     (modes,)
    found.table                                 the same and more, a row per mode: pandas.DataFrame(found.table)
    found.residues                              (modes, points, channels) complex, 1/kg
    found.frf, found.frf_frequency_hz           (points, channels, lines) complex (m/s²)/N, and (lines,) Hz
    found.hits, found.modes, found.warnings     lists of dictionaries
    found.to_dict()                             exactly what `percuss analyze … --json` prints
    found.report("bat.html")                    the page; found.save("modes.uff") and others by extension

What there is:

    read, info, write          records and FRFs: HDF5, MAT, UFF, LabVIEW, sound, CSV
    Record                     arrays as a record: points, names, geometry
    analyze, frf, survey       modes, frequency responses, shapes of many points
    nodes, deflect, calibrate  nodes along a scan, deflection under an impact, a hammer's calibration
    synth, presets             made-up tests
    models                     beam, impact, rigid, trampoline, bat, shell
    metrics                    performance, certify, abi, study, mac
    compare                    tests and models side by side
    example                    texts to start from

Keywords are the options of the command line with underscores (`--accel-channel` is accel_channel), with the same
defaults and checks; bands are tuples, lists are lists. help(percuss.analyze) shows those of analyze. Unusable data raise
percuss.InputError, which is a ValueError, in the words of the command line: problem (where); remedy.

Functions release Python's lock and may be called by several threads. Files of MAT, HDF5 and sound are read in small
processes of their own, which hostile files cannot leave.
"""

from __future__ import annotations

from ._percuss import InputError, NoHitError, UsageError
from ._percuss import version as __version__

from . import _commands
from ._analyses import Analysis, Survey
from ._commands import compare, info, write
from ._frf import Frf
from ._measured import MeasuredFrf
from ._records import Record
from ._results import Deflection, Nodes, Result, Synthetic
from ._texts import example, presets
from . import metrics, models

analyze = _commands.FUNCTIONS["analyze"]
calibrate = _commands.FUNCTIONS["calibrate"]
deflect = _commands.FUNCTIONS["deflect"]
frf = _commands.FUNCTIONS["frf"]
nodes = _commands.FUNCTIONS["nodes"]
read = _commands.FUNCTIONS["read"]
survey = _commands.FUNCTIONS["survey"]
synth = _commands.FUNCTIONS["synth"]

__all__ = [
    "Analysis", "Deflection", "Frf", "InputError", "MeasuredFrf", "NoHitError", "Nodes", "Record", "Result", "Survey",
    "Synthetic", "UsageError", "analyze", "calibrate", "compare", "deflect", "example", "frf", "info", "metrics", "models",
    "nodes", "presets", "read", "survey", "synth", "write",
]  # fmt: skip

for _one in (Analysis, Deflection, Frf, MeasuredFrf, Nodes, Record, Result, Survey, Synthetic, compare, example, info, presets, write):
    _one.__module__ = "percuss"  # where users find them
del _one
