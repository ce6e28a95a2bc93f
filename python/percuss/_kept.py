"""What of a result goes to other processes and into files: all that was found, and no samples."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _percuss
from ._arrays import frozen


class PickledOutcome:
    """Stands where the compiled outcome stood, with its answers to the calls that were asked."""

    def __init__(self, outcome: Any, calls: list[tuple[Any, ...]]) -> None:
        self.code, self.document, self.tests = outcome.code, outcome.document, outcome.tests
        self.notes = list(outcome.notes)
        self._answers = {call: getattr(outcome, call[0])(*call[1:]) for call in calls}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        _freeze(self._answers)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *arguments: self._answer(name, *arguments)

    def _answer(self, *call: Any) -> Any:
        if call not in self._answers:
            raise _percuss.UsageError(f"{call[0]} did not go with the result when it was pickled; ask for it before, or analyze again")
        return self._answers[call]

    def save(self, path: bytes, force: bool) -> None:
        raise _percuss.UsageError("a result that was pickled writes no files; save() before, or write its to_dict() or json")


def _freeze(value: Any) -> None:
    if isinstance(value, np.ndarray):
        frozen(value)
    elif isinstance(value, dict):
        _freeze(list(value.values()))
    elif isinstance(value, (list, tuple)):
        for one in value:
            _freeze(one)
