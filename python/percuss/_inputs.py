"""What a command is given to read, and what of it contradicts the keywords."""

from __future__ import annotations

import os
from typing import Any

from . import _percuss
from ._measured import MeasuredFrf
from ._records import Record
from ._results import Synthetic
from ._words import Command


def handles_of(data: tuple[Any, ...], fs: Any) -> tuple[list[str], list[Any]]:
    """What a command is given: paths, or handles of what is in memory."""
    given: list[Any] = list(data[0]) if len(data) == 1 and _is_several(data[0]) else list(data)
    flat = [one.record if isinstance(one, Synthetic) else one for one in given]
    if flat and all(isinstance(one, (str, bytes, os.PathLike)) for one in flat):
        return [os.fsdecode(one) for one in flat], []
    if flat and all(isinstance(one, (Record, MeasuredFrf)) for one in flat):
        return [], [one._handle for one in flat]
    if any(isinstance(one, (str, bytes, os.PathLike, Record, MeasuredFrf)) for one in flat):
        raise TypeError("give files, records or arrays, not some of each")
    if not data:
        raise _percuss.UsageError("no data; give paths, arrays or Records")
    if len(data) != 2:
        raise TypeError("give two arrays, force and accel, with fs=; or paths; or records")
    if fs is None:
        raise TypeError("arrays need their sampling rate: fs= in Hz")
    return [], [Record(data[0], data[1], fs)._handle]


def _is_several(value: Any) -> bool:
    known = (str, bytes, os.PathLike, Record, MeasuredFrf, Synthetic)
    return isinstance(value, (list, tuple)) and bool(value) and all(isinstance(one, known) for one in value)


def reject_reading_options(name: str, command: Command, handles: list[Any], options: dict[str, Any], are_records: bool) -> None:
    """How a file is read was settled when it was read, and the rate of arrays when they became a record."""
    if are_records and options.get("fs") is not None:
        raise TypeError(f"{name}() cannot give a record another rate with 'fs'; give it to percuss.read() or percuss.Record()")
    if all(getattr(one, "from_arrays", False) for one in handles):
        return
    settled = [key for key in options if key in command.options and command.options[key].group == "Reading" and key != "files"]
    if settled:
        raise TypeError(f"{name}() cannot read a record again with {settled[0]!r}; give it to percuss.read()")


def reject_single_point(handle: Any, geometry: Any) -> None:
    """Arrays by themselves do not say which points were struck."""
    told = handle.describe()
    places = 0 if geometry is None or isinstance(geometry, (str, bytes, os.PathLike, dict)) else len(geometry)
    if len(told["rows"]) > 1 and places > max(1, len(told["accel"])):
        raise _percuss.InputError(
            f"{len(told['rows'])} hits are all at one point, and the geometry has {places} (arrays); "
            "say which point each struck: percuss.survey(percuss.Record(force, accel, fs, points=...), geometry=...)"
        )
