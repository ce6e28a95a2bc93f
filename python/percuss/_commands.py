"""The functions of the package, made from the declarations of the commands."""

from __future__ import annotations

import inspect
import os
from typing import Any, Callable

from . import _percuss
from ._analyses import Analysis, Survey
from ._argv import declared
from ._arrays import rate_of
from ._docs import READS_DATA, docstring, signature
from ._errors import note_in_python
from ._frf import Frf
from ._arguments import handles_of, reject_geometry_without_points, reject_reading_options
from ._measured import MeasuredFrf
from ._records import Record
from ._results import Deflection, Nodes, Result, Synthetic

COMMANDS = declared()


def _given(options: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in options.items() if value is not None and value is not False}


def make(
    name: str, command: str, result: Callable[..., Any], intro: str, example: str, leading: list[inspect.Parameter]
) -> Callable[..., Any]:
    """Makes the function that runs a command. `leading` are its positional parameters."""
    declaration = COMMANDS[command]
    reads_data = command in READS_DATA

    def function(*data: Any, **options: Any) -> Any:
        given = _given(options)
        if reads_data:
            paths, handles = handles_of(data, options.get("fs"))
            are_records = bool(handles) and not (len(data) == 2 and not isinstance(data[0], (Record, MeasuredFrf)))
            reject_reading_options(name, declaration, handles, given, are_records)
            if handles and "fs" in given:
                given["fs"] = rate_of(given["fs"])
            if name == "survey" and handles and not are_records:
                reject_geometry_without_points(handles[0], given.get("geometry"))
        else:
            paths, handles = list(data), []
        outcome = declaration.run(name, paths, handles, given)
        return result(outcome, **({"kind": given["kind"]} if name == "frf" and "kind" in given else {}))

    function.__name__ = function.__qualname__ = name.rpartition(".")[2]
    function.__module__ = "percuss." + name.rpartition(".")[0] if "." in name else "percuss"
    function.__signature__ = signature(declaration, leading)  # type: ignore[attr-defined]
    function.__doc__ = docstring(declaration, intro, example)
    return function


def _positional(name: str, several: bool) -> inspect.Parameter:
    kind = inspect.Parameter.VAR_POSITIONAL if several else inspect.Parameter.POSITIONAL_ONLY
    return inspect.Parameter(name, kind)


_SETTINGS: dict[str, tuple[str, Callable[..., Any], list[inspect.Parameter], str, str]] = {
    "analyze": (
        "analyze",
        Analysis,
        [_positional("data", True)],
        "Returns an Analysis: frequency_hz, damping_ratio ... (modes,), frf (points, channels, lines), hits, warnings.",
        """
Example:

    >>> test = percuss.synth("wood-bat")
    >>> found = percuss.analyze(test.record, band=(60, 3200))
    >>> found.frequency_hz.round(1).tolist()
    [165.0, 568.0, 1177.0]
    >>> found.family[0], int(found.order[0])
    ('bending', 1)
""",
    ),
    "frf": (
        "frf",
        Frf,
        [_positional("data", True)],
        "Returns a Frf: frequency_hz (lines,), frf, std, coherence (points, channels, lines).",
        """
Example:

    >>> responses = percuss.frf(percuss.synth("wood-bat").record, band=(60, 3200))
    >>> responses.frf.shape == (1, 2, len(responses.frequency_hz))
    True
""",
    ),
    "survey": (
        "survey",
        Survey,
        [_positional("data", True)],
        "Returns a Survey: an Analysis with shapes (modes, places), mac (modes, modes) and cmif (lines, values). geometry may be\n"
        "an array (points, 3) in m.",
        """
Example:

    >>> found = percuss.survey(percuss.synth("roving-barrel").record, band=(60, 3200), effort="quick")
    >>> found.mac.shape == (len(found.frequency_hz),) * 2
    True
""",
    ),
    "nodes": (
        "nodes",
        Nodes,
        [_positional("data", True)],
        "Returns a Nodes result: positions, and modes with frequency_hz and nodes (position_m and std_m in m).",
        "",
    ),
    "deflect": (
        "deflect",
        Deflection,
        [_positional("data", True)],
        "Returns a Deflection: hits with peak_m and peak_std_m in m; curves() over time. If no force was recorded, pass None as the force.",
        """
Example:

    >>> seen = percuss.deflect(percuss.synth("wood-bat").record)
    >>> seen.hits[0]["peak_m"] > 0
    True
""",
    ),
    "calibrate": (
        "calibrate",
        Result,
        [_positional("data", True)],
        "Returns a Result: force_scale and force_scale_std in N per unit of the force channel, n_per_unit (without the sign), hits.",
        "",
    ),
    "synth": (
        "synth",
        Synthetic,
        [_positional("spec", False)],
        "spec is the name of a preset, a path, or a dictionary; docs/guides/synth.md describes its keys.\n"
        "Returns a Synthetic: record, a Record; to_dict() is the truth.",
        """
Example:

    >>> test = percuss.synth("wood-bat", seed=7)
    >>> test.record.channels, test.record.fs_hz
    (2, 25600.0)
    >>> test["f_hz"][:3].tolist()
    [165.0, 568.0, 1177.0]
""",
    ),
}

FUNCTIONS = {
    name: make(name, command, result, intro, example, leading)
    for name, (command, result, leading, intro, example) in _SETTINGS.items()
}


def _read(*paths: Any, **options: Any) -> Any:
    command = COMMANDS["read"]
    flat = paths[0] if len(paths) == 1 and isinstance(paths[0], (list, tuple)) else paths
    outcome = command.run("read", list(flat), [], _given(options))
    opened = [Record._from_handle(one) if isinstance(one, _percuss.RecordHandle) else MeasuredFrf(one) for one in outcome.opened()]
    return opened[0] if len(opened) == 1 else opened


_read.__name__ = _read.__qualname__ = "read"
_read.__module__ = "percuss"
_read.__signature__ = signature(COMMANDS["read"], [_positional("paths", True)])  # type: ignore[attr-defined]
_read.__doc__ = docstring(
    COMMANDS["read"],
    "paths: HDF5, MAT, UFF, LabVIEW, sound, CSV or text. Returns a Record or a MeasuredFrf, depending on the file; for several files a list. Samples are read on demand.",
    "",
)
FUNCTIONS["read"] = _read


def write(path: str | os.PathLike[str], data: Any, *, force: bool = False) -> list[str]:
    """Write a record or FRFs in the format of the path's extension.

    path   .h5, .hdf5, .csv, .mat, .uff, .unv; records also .wav, .rf64, .w64.
    data   a Record, a MeasuredFrf, or a Synthetic (its record).
    force  overwrite an existing file.

    Returns the information that the format cannot store, one line each. Raises InputError if the file exists or cannot be
    written, UsageError for an unknown extension. The file is written completely or not at all.

    >>> import os, tempfile, percuss
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = percuss.write(os.path.join(folder, "bat.h5"), percuss.synth("wood-bat"))
    ...     percuss.read(os.path.join(folder, "bat.h5")).rows
    5
    """
    one = data.record if isinstance(data, Synthetic) else data
    if not isinstance(one, (Record, MeasuredFrf)):
        raise TypeError(f"data cannot be {type(data).__name__}: give a Record, a MeasuredFrf or a Synthetic")
    words = ["convert", "--quiet", f"--output={os.fsdecode(path)}"] + (["--force"] if force else [])
    return [note_in_python(note) for note in _percuss.run([os.fsencode(word) for word in words], [one._handle]).notes]


def info(*paths: Any, **options: Any) -> Result:
    """Describe files: kind, channels, units, rate, rows, and parts that cannot be read.

    paths    files of any kind that read() accepts.
    options  the keywords of read().

    Returns a Result; files describes each file. A file that cannot be read is listed with its error, without an
    exception. Only the descriptions of the files are read. Raises UsageError if no file is given.

    >>> import os, tempfile, percuss
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     percuss.synth("wood-bat").save(os.path.join(folder, "bat.csv"))
    ...     percuss.info(os.path.join(folder, "bat.csv")).files[0]["kind"]
    'CSV'
    """
    return Result(COMMANDS["info"].run("info", list(paths), [], _given(options)))


def compare(*documents: Any, **options: Any) -> Result:
    """Compare modes or deflections of tests and models side by side.

    documents  two or more results of analyze, survey, deflect or models, their dictionaries, or paths of such documents.
    options    furthest: pair modes only if their frequencies differ by at most this many percent; least_mac: pair modes
               only if their MAC is at least this.

    Returns a Result: pairs, unpaired_a, unpaired_b. Raises UsageError for fewer than two documents.

    >>> import percuss
    >>> a = percuss.models.beam(support="free", length=0.84, modes=4)
    >>> b = percuss.models.beam(support="free", length=0.85, modes=4)
    >>> len(percuss.compare(a, b).to_dict()["pairs"]) > 0
    True
    """
    return Result(COMMANDS["compare"].run("compare", list(documents), [], _given(options)))
