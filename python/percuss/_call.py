"""Runs the command of a function."""

from __future__ import annotations

import atexit
import functools
import inspect
import numbers
import os
from typing import Any, Callable, TypeVar

import numpy as np

from . import _percuss
from ._argv import declared
from ._arguments import handles_of, reject_geometry_without_points, reject_reading_options
from ._arrays import rate_of
from ._frf import Frf
from ._records import Record
from ._results import Synthetic

COMMANDS = declared()

atexit.register(_percuss.stop_calls)  # daemon threads may still compute

_Function = TypeVar("_Function", bound=Callable[..., Any])


def command_function(name: str, command: str) -> Callable[[_Function], _Function]:
    """Decorates the function of a command. An unknown keyword raises a TypeError that names the nearest one, and a missing
    keyword the UsageError of the command. help() shows the signature without types, which the docstring states in words."""

    def decorate(function: _Function) -> _Function:
        own = inspect.signature(function)
        keywords = {one.name: one.default for one in own.parameters.values() if one.kind is one.KEYWORD_ONLY}
        required = [key for key, default in keywords.items() if default is inspect.Parameter.empty]

        @functools.wraps(function)
        def checked(*data: Any, **options: Any) -> Any:
            for key in options:
                if key not in keywords:
                    raise COMMANDS[command].unknown_keyword(name, key)
            for key in required:
                options.setdefault(key, None)
            return function(*data, **options)

        empty = inspect.Parameter.empty
        checked.__signature__ = own.replace(  # type: ignore[attr-defined]
            parameters=[one.replace(annotation=empty) for one in own.parameters.values()], return_annotation=empty
        )
        module, _, short = name.rpartition(".")
        checked.__module__ = f"percuss.{module}" if module else "percuss"
        checked.__qualname__ = short
        return checked  # type: ignore[return-value]

    return decorate


def _given(options: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in options.items() if value is not None and value is not False}


def run_on_data(name: str, command: str, data: tuple[Any, ...], options: dict[str, Any]) -> _percuss.CommandResult:
    """The outcome of a command that reads files, records, FRFs or arrays."""
    declaration, given = COMMANDS[command], _given(options)
    paths, handles, are_arrays = handles_of(data, options.get("fs"))
    reject_reading_options(name, declaration, handles, given, bool(handles) and not are_arrays)
    if handles and "fs" in given:
        given["fs"] = rate_of(given["fs"])
    if name == "survey" and are_arrays:
        reject_geometry_without_points(handles[0], given.get("geometry"))
    return declaration.run(name, paths, handles, given)


def run_on_documents(name: str, command: str, documents: tuple[Any, ...], options: dict[str, Any]) -> _percuss.CommandResult:
    """The outcome of a command that reads documents or tables, or nothing. Raises TypeError for arrays in compare()."""
    if command == "compare" and any(_is_array(one) for one in documents):
        raise TypeError(f"{name}() takes results, their documents or files; percuss.mac() compares arrays of shapes")
    return COMMANDS[command].run(name, list(documents), [], _given(options))


def _is_array(value: Any) -> bool:
    """An array, or numbers in lists and tuples."""
    while isinstance(value, (list, tuple)) and value:
        value = value[0]
    return isinstance(value, (np.ndarray, numbers.Number))


def read_files(name: str, command: str, paths: tuple[Any, ...], options: dict[str, Any]) -> Any:
    """The records and FRFs of files; a list if there are several."""
    flat = list(paths[0]) if len(paths) == 1 and isinstance(paths[0], (list, tuple)) else list(paths)
    opened = COMMANDS[command].run(name, flat, [], _given(options)).opened()
    again = [os.path.abspath(os.fsdecode(one)) for one in flat], _given(options)
    made = [
        Record._from_handle(one, (_read_again, (*again, i))) if isinstance(one, _percuss.RecordHandle) else Frf._from_handle(one)
        for i, one in enumerate(opened)
    ]
    return made[0] if len(made) == 1 else made


def _read_again(paths: list[str], options: dict[str, Any], index: int) -> Any:
    made = read_files("read", "read", tuple(paths), options)
    return made[index] if isinstance(made, list) else made


def synthesise_spec(name: str, command: str, spec: tuple[Any, ...], options: dict[str, Any]) -> Synthetic:
    """A synthetic test."""
    one = spec[0]
    if isinstance(one, (str, bytes, os.PathLike)) and os.path.exists(one):
        spec = (os.path.abspath(os.fsdecode(one)),)
    return Synthetic(run_on_documents(name, command, (one,), options), (_make_again, (spec, _given(options))))


def _make_again(spec: tuple[Any, ...], options: dict[str, Any]) -> Synthetic:
    return synthesise_spec("synth", "synth", spec, options)
