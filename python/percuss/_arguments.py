"""The data arguments of a command, and checks against its keywords."""

from __future__ import annotations

import os
from typing import Any

from ._argv import Command
from ._errors import InputError, UsageError
from ._frf import Frf
from ._records import Record
from ._results import Synthetic
from ._tests import AveragedFrf

_PATHS = (str, bytes, os.PathLike)
_MEASURED = (Record, Frf, Synthetic, AveragedFrf)


def handles_of(data: tuple[Any, ...], fs: Any) -> tuple[list[str], list[Any], bool]:
    """Paths, or handles of data in memory, and whether these are bare arrays."""
    if len(data) == 1 and isinstance(data[0], _MEASURED):
        return [], [_handle_of(data[0])], False
    given: list[Any] = list(data[0]) if len(data) == 1 and _is_list_of_inputs(data[0]) else list(data)
    if given and all(isinstance(one, _PATHS) for one in given):
        return [os.fsdecode(one) for one in given], [], False
    if given and all(isinstance(one, _MEASURED) for one in given):
        return [], [_handle_of(one) for one in given], False
    if any(isinstance(one, _PATHS + _MEASURED) for one in given):
        raise TypeError("give files, records or arrays, not a mixture")
    if not data:
        raise UsageError("no data is given", "give paths, arrays or Records")
    if len(data) != 2:
        raise TypeError("give two arrays, force and accel, with fs=; or paths; or records")
    if fs is None:
        raise TypeError("arrays need their sampling rate: fs= in Hz")
    return [], [Record(data[0], data[1], fs)._handle], True


def _handle_of(one: Any) -> Any:
    if isinstance(one, AveragedFrf):
        one = one.frf()
    return one.record._handle if isinstance(one, Synthetic) else one._handle


def _is_list_of_inputs(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and bool(value) and all(isinstance(one, _PATHS + _MEASURED) for one in value)


def reject_reading_options(name: str, command: Command, handles: list[Any], options: dict[str, Any], are_records: bool) -> None:
    """Rejects reading options for records and FRFs that were read before, or are synthetic. Records and FRFs of arrays
    still take reading options, except fs."""
    if are_records and options.get("fs") is not None:
        raise TypeError(f"{name}() cannot change the sampling rate of a record with 'fs'; give it to percuss.read() or percuss.Record()")
    if all(one.from_arrays for one in handles):
        return
    reading = [key for key in options if key in command.options and command.options[key].group == "Reading" and key != "files"]
    if reading:
        raise TypeError(f"{name}() cannot read a record again with {reading[0]!r}; give it to percuss.read()")


def reject_geometry_without_points(handle: Any, geometry: Any) -> None:
    """Rejects a geometry of several points for bare arrays, since it is unknown which point each hit struck."""
    description = handle.describe()
    places = 0 if geometry is None or isinstance(geometry, (str, bytes, os.PathLike, dict)) else len(geometry)
    if len(description["rows"]) > 1 and places > max(1, len(description["accel"])):
        raise InputError(
            f"all {len(description['rows'])} hits are at one point, but the geometry has {places} points",
            "arrays",
            "say which point each hit struck: percuss.survey(percuss.Record(force, accel, fs, points=...), geometry=...)",
        )
