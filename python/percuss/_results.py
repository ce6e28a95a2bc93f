"""What the functions return."""

from __future__ import annotations

import json
import os
from typing import Any

import numpy as np

from . import _percuss
from ._records import Record

_WIDTH = 100
_STYLE = (
    "<style>.percuss table{border-collapse:collapse;font-variant-numeric:tabular-nums}"
    ".percuss th,.percuss td{padding:.2rem .9rem .2rem 0;text-align:left;vertical-align:top;white-space:nowrap}"
    ".percuss td:last-child{white-space:normal;min-width:12rem}"
    ".percuss .right{text-align:right}.percuss th{font-weight:600;border-bottom:1px solid #c9d1d9}"
    ".percuss .warnings{list-style:none;margin:1rem 0;padding:0}"
    ".percuss .warnings li{background:#fff4e5;color:#7a3e00;border-left:4px solid;padding:.4rem .8rem;margin:.4rem 0}</style>"
)


class Result:
    """What a function found: the document that the command line's --json prints, and more.

    to_dict() is that document, json its text; result["key"] and result.key are its entries, lists of numbers as arrays,
    with NaN where the document has none. Curves are lists of dictionaries there, and columns in table.
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

    def keys(self) -> list[str]:
        """The document's keys."""
        return list(self._parsed())

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
        """
        self._outcome.save(os.fsencode(path), force)

    def report(self, path: str | os.PathLike[str], force: bool = False) -> None:
        """Writes the page: one .html file, the one that the command line writes. Raises as save()."""
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

    def __str__(self) -> str:
        modes = ", ".join(f"{freq_hz:g}" for freq_hz in self._parsed()["f_hz"])
        return f"{self.record!r}, modes at {modes} Hz"


class Deflection(Result):
    """Deflection under each impact: hits as in the document, curves() over time."""

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
        return np.array(value) if whole else np.array([np.nan if one is None else one for one in value], dtype=float)
    if all(isinstance(one, list) for one in value) and len({len(one) for one in value}) == 1:
        if all(_is_number(number) for one in value for number in one):
            return np.array(value)
    return value
