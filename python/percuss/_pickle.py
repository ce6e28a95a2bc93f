"""Pickling of results: everything that was computed, without the samples."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ._arrays import frozen
from ._errors import UsageError


class PickledResult:
    """Replaces a CommandResult in a pickled result. It stores the return value of each call in `calls`."""

    def __init__(self, outcome: Any, calls: list[tuple[Any, ...]], tests: list[Any]) -> None:
        self.code, self.document, self.tests = outcome.code, outcome.document, outcome.tests
        self.notes = list(outcome.notes)
        self._tests = tests  # a PickledResult for each of several tests
        self._values = {call: getattr(outcome, call[0])(*call[1:]) for call in calls}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        _freeze(self._values)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *arguments: self._value(name, *arguments)

    def _value(self, *call: Any) -> Any:
        if call not in self._values:
            raise UsageError(f"{call[0]} was not pickled with the result", "read it before pickling, or analyze again")
        return self._values[call]

    def of_test(self, test: int) -> Any:
        return self._tests[test]

    def save(self, path: bytes, force: bool, page: Sequence[tuple[str, bytes]] = ()) -> None:
        raise UsageError("a result that was pickled cannot write this file", "call save() before pickling, or write its to_dict() or json")


def _freeze(value: Any) -> None:
    if isinstance(value, np.ndarray):
        frozen(value)
    elif isinstance(value, dict):
        _freeze(list(value.values()))
    elif isinstance(value, (list, tuple)):
        for one in value:
            _freeze(one)
