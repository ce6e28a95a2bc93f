"""What the functions return."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from . import _percuss
from ._arrays import frozen
from ._kept import PickledOutcome
from ._records import Record
from ._words import in_python_terms

_WIDTH = 100
_STYLE = (
    "<style>.percuss table{border-collapse:collapse;font-variant-numeric:tabular-nums}"
    ".percuss th,.percuss td{padding:.2rem .9rem .2rem 0;text-align:left;vertical-align:top;white-space:nowrap}"
    ".percuss td:last-child{white-space:normal;min-width:12rem}"
    ".percuss .right{text-align:right}.percuss th{font-weight:600;border-bottom:1px solid #c9d1d9}"
    ".percuss .warnings{list-style:none;margin:1rem 0;padding:0}"
    ".percuss .warnings li{background:#fff4e5;color:#7a3e00;border-left:4px solid;padding:.4rem .8rem;margin:.4rem 0}</style>"
)


class Result(Mapping[str, Any]):
    """What a function found: the document that the command line's --json prints, and more.

    to_dict() is that document, json its text; a result is a mapping as well: result["key"], which is result.key too, "key"
    in result, items() and so on are its entries, lists of numbers as read-only arrays, with NaN where the document has
    none. Curves are lists of dictionaries there, and columns in table. A result is equal to itself alone.
    save(path) writes what the command's -o writes, by the path's extension; report(path) is its page. In Jupyter the
    main table is shown, elsewhere what a terminal would show. exit_code is what the command would have ended with.
    """

    def __init__(self, outcome: Any) -> None:
        self._outcome = outcome
        self._document: dict[str, Any] | None = None

    @property
    def json(self) -> str:
        """The document as the command line prints it with --json, to the byte."""
        return self._outcome.document

    def to_dict(self) -> dict[str, Any]:
        """The document as a dictionary of its own."""
        return json.loads(self.json)

    def _parsed(self) -> dict[str, Any]:
        if self._document is None:
            self._document = self.to_dict()
        return self._document

    def __iter__(self) -> Iterator[str]:
        return iter(self._parsed())

    def __len__(self) -> int:
        return len(self._parsed())

    __hash__ = object.__hash__  # a result is equal to itself: arrays know no better

    def __eq__(self, other: object) -> bool:
        return self is other

    def __bool__(self) -> bool:
        return True

    def _calls(self) -> list[tuple[Any, ...]]:
        """What to ask of the outcome before it stays behind."""
        return [("text", _WIDTH), ("html",), ("columns",)]

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_outcome": PickledOutcome(self._outcome, self._calls())}

    def __copy__(self) -> Any:
        made = type(self).__new__(type(self))
        made.__dict__.update(self.__dict__, _document=None)
        return made

    def __deepcopy__(self, memo: Any) -> Any:
        return self.__copy__()

    def __getitem__(self, key: str) -> Any:
        return _array_or_same(self._parsed()[key])

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if name in self._parsed():
            return self[name]
        near = _percuss.nearest(name, [*self._parsed(), *(one for one in dir(type(self)) if not one.startswith("_"))])
        hint = f"; did you mean {near!r}?" if near else ""
        raise AttributeError(f"{type(self).__name__} has no attribute {name!r}{hint}")

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._parsed()})

    @property
    def exit_code(self) -> int:
        """0; 4 where no hit can be used; 5 where a bat exceeds its limit."""
        return self._outcome.code

    @property
    def table(self) -> dict[str, np.ndarray]:
        """The columns of the command's .csv by name, (rows,) each; empty where it has none. pandas.DataFrame takes it."""
        return self._outcome.columns()

    def save(self, path: str | os.PathLike[str], force: bool = False) -> None:
        """Writes the result as the path's extension says, as -o of the command does.

        Raises InputError where the file exists, unless force; UsageError for extensions that the command does not know.
        What the file shows of the samples is read now: where they were given as arrays, these must be as they were.
        InputError where a few hundred of their numbers, looked at again, have changed; it cannot see every change. .json
        needs no samples, nor do results of files. A result that was pickled writes no files.
        """
        try:
            self._outcome.save(os.fsencode(path), force)
        except _percuss.InputError as error:
            raise in_python_terms(error) from None

    def report(self, path: str | os.PathLike[str], force: bool = False) -> None:
        """Writes the page: one .html file, the one that the command line writes. It shows the
        samples, so that arrays must be as they were. Raises as save()."""
        if os.path.splitext(os.fspath(path))[1].lower() != ".html":
            raise _percuss.UsageError(f"a page is not written to '{os.fspath(path)}'; use a name that ends in .html")
        self.save(path, force)

    def __str__(self) -> str:
        return self._outcome.text(_WIDTH) or self.json

    def __repr__(self) -> str:
        return str(self).rstrip("\n")

    def _repr_html_(self) -> str | None:
        html = self._outcome.html()
        return f'{_STYLE}<div class="percuss">{html}</div>' if html else None


class Synthetic(Result):
    """A made-up test and its truth: to_dict() is the truth, record what was measured."""

    @property
    def record(self) -> Record:
        """The samples as a Record."""
        return Record._of(self._outcome.record())

    def __reduce__(self) -> Any:
        raise TypeError("a made-up test is not pickled: make it again from its spec and seed, or give the arrays of its record")

    def __str__(self) -> str:
        modes = ", ".join(f"{freq_hz:g}" for freq_hz in self._parsed()["f_hz"])
        return f"{self.record!r}, modes at {modes} Hz"


class Deflection(Result):
    """Deflection under each impact: hits as in the document, curves() over time."""

    def _calls(self) -> list[tuple[Any, ...]]:
        return [*super()._calls(), ("deflections",)]

    def curves(self) -> list[dict[str, Any]]:
        """For each hit and channel: hit, channel, point, first_s, velocity_mps, deflection_m (samples,), std_m or None.

        The arrays are views of what was computed. Times: first_s + i / fs.
        """
        return curves_of(self._outcome)


class Nodes(Result):
    """Where bending modes have their nodes, along a scan of impacts."""


def curves_of(outcome: Any) -> list[dict[str, Any]]:
    names = ("hit", "channel", "point", "first_s", "velocity_mps", "deflection_m", "std_m")
    return [dict(zip(names, one)) for one in outcome.deflections()]


def _is_number(one: Any) -> bool:
    return isinstance(one, (int, float)) and not isinstance(one, bool)


def _array_or_same(value: Any) -> Any:
    """Lists of numbers as arrays, None among them as NaN; tables of equal rows as arrays of two dimensions."""
    if not isinstance(value, list) or not value:
        return value
    if all(_is_number(one) or one is None for one in value):
        whole = all(isinstance(one, int) for one in value)
        return frozen(np.array(value) if whole else np.array([np.nan if one is None else one for one in value], dtype=float))
    if all(isinstance(one, list) for one in value) and len({len(one) for one in value}) == 1:
        if all(_is_number(number) for one in value for number in one):
            return frozen(np.array(value))
    return value
