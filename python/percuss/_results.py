"""Results of the functions."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterator, Mapping
from typing import Any, Literal

import numpy as np

from . import _percuss
from ._arrays import frozen
from ._columns import columns_of_csv
from ._errors import UsageError
from ._optional import STYLE, rows_frame, table_frame
from ._pickle import PickledResult
from ._plots import plot_curves
from ._records import Record

_WIDTH = 100
_SHOWN = 12  # modes or lines of repr()


class Result(Mapping[str, Any]):
    """The result of a function: the JSON document of the command, its table, its files.

    to_dict()     the document that the command line prints with --json; json is its text
    result[key]   an entry of the document, also result.key. A list of numbers becomes a read-only array, with NaN for null.
                  A curve is a list of dictionaries here, and columns in table.
    table         the columns of the command's .csv; to_dataframe() is the same for pandas
    save(path)    writes the file that -o of the command writes, by the extension of the path
    report(path)  writes the HTML page
    exit_code     the exit code of the command

    A result is a read-only mapping and equal to itself only. Jupyter shows its main table; str() is the text that a
    terminal shows, repr() at most twelve of its modes or lines.
    """

    def __init__(self, outcome: Any) -> None:
        self._outcome = outcome
        self._document: dict[str, Any] | None = None

    @property
    def json(self) -> str:
        """The document, byte for byte as the command line prints it with --json."""
        return self._outcome.document

    def to_dict(self) -> dict[str, Any]:
        """The document as a new dictionary."""
        return json.loads(self.json)

    def _parsed(self) -> dict[str, Any]:
        if self._document is None:
            self._document = self.to_dict()
        return self._document

    def __iter__(self) -> Iterator[str]:
        return iter(self._parsed())

    def __len__(self) -> int:
        return len(self._parsed())

    __hash__ = object.__hash__  # equality is identity, since arrays do not compare to one truth value

    def __eq__(self, other: object) -> bool:
        return self is other

    def __bool__(self) -> bool:
        return True

    def _calls(self) -> list[tuple[Any, ...]]:
        """Calls of the CommandResult whose values are pickled."""
        return [("text", _WIDTH), ("html",), ("columns",), ("table_csv",)]

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_outcome": PickledResult(self._outcome, self._calls(), self._pickled_tests())}

    def _pickled_tests(self) -> list[PickledResult]:
        return []

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
        """0; 3 if info() could not read a file; 4 if no hit can be used; 5 if a bat fails certify() or abi()."""
        return self._outcome.code

    @property
    def table(self) -> dict[str, np.ndarray]:
        """The columns of the command's .csv by name, (rows,) each; empty if it has none."""
        return self._outcome.columns() or columns_of_csv(self._outcome.table_csv())

    def to_dataframe(self) -> Any:
        """The table as a pandas.DataFrame. Needs pandas. Raises TypeError if the result has no table."""
        return table_frame(self.table)

    def save(self, path: str | os.PathLike[str], force: bool = False) -> None:
        """Write the result in the format of the path's extension, as -o of the command does.

        Raises InputError if the file exists and force is False, UsageError for an extension that the command does not
        write. Formats other than .json may need samples, which are read now. Arrays must not have changed since the
        call: save() compares a few hundred of their numbers and raises InputError if one differs; it cannot detect
        every change. A result that was pickled writes no files.
        """
        self._write(path, force, [])

    def _write(self, path: str | os.PathLike[str], force: bool, page: list[tuple[str, bytes]]) -> None:
        """save() with the options of the page, by name."""
        self._outcome.save(os.fsencode(path), force, page)

    def report(
        self,
        path: str | os.PathLike[str],
        force: bool = False,
        *,
        title: str | None = None,
        customer: str | None = None,
        operator: str | None = None,
        specimen: str | None = None,
        date: str | None = None,
        note: str | None = None,
        logo: str | os.PathLike[str] | None = None,
        paper: Literal["a4", "letter"] | None = None,
    ) -> None:
        """Write the page of the command line: one .html file. It may show samples, so arrays must not have changed.

        title     the title of the page (default: the name of the file)
        customer, operator, specimen   who ordered the test, who did it, what was tested
        date      when it was done (default: the date that the file states)
        note      a text at the top of the page, or "@FILE": the text of a file
        logo      a picture at the top of the page: a PNG, JPEG or SVG file of at most 200 kB
        paper     the paper on which the page is printed: "a4" (default) or "letter"

        They replace the options of these names of the function that made the result. Raises as save(); UsageError also
        for a text that is too long, InputError for a note or a logo that cannot be read."""
        if os.path.splitext(os.fspath(path))[1].lower() != ".html":
            raise UsageError(f"cannot write a page to '{os.fspath(path)}'", "use a name that ends in .html")
        stated = {
            "title": title,
            "customer": customer,
            "operator": operator,
            "specimen": specimen,
            "date": date,
            "note": note,
            "logo": logo,
            "paper": paper,
        }
        self._write(path, force, [(name, os.fsencode(value)) for name, value in stated.items() if value is not None])

    def __str__(self) -> str:
        return self._outcome.text(_WIDTH) or self.json

    def __repr__(self) -> str:
        lines = str(self).rstrip("\n").split("\n")
        if len(lines) <= _SHOWN:
            return "\n".join(lines)
        modes = self._parsed().get("modes")
        if not isinstance(modes, list):
            return "\n".join([*lines[:_SHOWN], f"… {len(lines) - _SHOWN} more lines: print() shows all"])
        warnings = self._parsed().get("warnings", [])
        counts = f"{_counted(len(modes), 'mode')}, {_counted(len(warnings), 'warning')}: print() shows all"
        rows = [_mode_line(mode) for mode in modes[:_SHOWN]]
        return "\n".join([lines[0], counts, *rows, *(["…"] if len(modes) > _SHOWN else [])])

    def _repr_html_(self) -> str | None:
        html = self._outcome.html()
        return f'{STYLE}<div class="percuss">{html}</div>' if html else None


class Synthetic(Result):
    """A synthetic test: record holds the measured signals, to_dict() the exact truth. Pickled as its spec and seed."""

    def __init__(self, outcome: Any, again: tuple[Any, tuple[Any, ...]]) -> None:
        super().__init__(outcome)
        self._again = again  # the function that makes this result, and its arguments

    @property
    def record(self) -> Record:
        """The samples as a Record."""
        return Record._from_handle(self._outcome.record(), (_record_of, self._again))

    def __reduce__(self) -> Any:
        return self._again

    def __str__(self) -> str:
        modes = ", ".join(f"{freq_hz:g}" for freq_hz in self._parsed()["f_hz"])
        return f"{self.record!r}, modes at {modes} Hz"


def _record_of(make: Any, given: tuple[Any, ...]) -> Record:
    return make(*given).record


class Deflection(Result):
    """Deflection under each impact: hits holds the peaks, curves() the time series."""

    def _calls(self) -> list[tuple[Any, ...]]:
        return [*super()._calls(), ("deflections",)]

    def curves(self) -> list[dict[str, Any]]:
        """A dictionary per hit and channel: hit, channel, point, first_s, velocity_mps and deflection_m (samples,), std_m or None.

        The arrays are read-only views of the result. Sample i lies at the time first_s + i / fs.
        """
        return curves_of(self._outcome)

    def to_dataframe(self) -> Any:
        """The peaks as a pandas.DataFrame: a row per hit and channel, a column per key of hits. Needs pandas."""
        return rows_frame(self._parsed()["hits"])

    def plot(self, ax: Any = None) -> Any:
        """Draw the deflection under each impact over time. Needs matplotlib. Returns the axes."""
        return plot_curves(self.curves(), self._parsed()["fs_hz"], ax)


class Nodes(Result):
    """Nodes of the bending modes along a scan of impacts."""


def curves_of(outcome: Any) -> list[dict[str, Any]]:
    names = ("hit", "channel", "point", "first_s", "velocity_mps", "deflection_m", "std_m")
    return [dict(zip(names, one)) for one in outcome.deflections()]


def _counted(count: int, what: str) -> str:
    return f"{count} {what}{'' if count == 1 else 's'}"


def _with_std(value: float, std: float | None) -> str:
    """The number and its ± with two digits of the ±."""
    if not std or not math.isfinite(std):
        return f"{value:.6g}"
    decimals = max(0, 1 - math.floor(math.log10(std)))
    return f"{value:.{decimals}f} ± {std:.{decimals}f}"


def _mode_line(mode: Mapping[str, Any]) -> str:
    freq = f"{_with_std(mode['frequency_hz'], mode.get('frequency_std_hz'))} Hz"
    std = mode.get("damping_ratio_std")
    damping = f"{_with_std(100 * mode['damping_ratio'], None if std is None else 100 * std)} %"
    return f"{freq:>28}  {damping:>26}  {mode.get('family') or ''} {mode.get('order') or ''}".rstrip()


def _is_number(one: Any) -> bool:
    return isinstance(one, (int, float)) and not isinstance(one, bool)


def _array_or_same(value: Any) -> Any:
    """A list of numbers as an array, None as NaN; a list of equally long lists as a two-dimensional array."""
    if not isinstance(value, list) or not value:
        return value
    if all(_is_number(one) or one is None for one in value):
        whole = all(isinstance(one, int) for one in value)
        return frozen(np.array(value) if whole else np.array([np.nan if one is None else one for one in value], dtype=float))
    if all(isinstance(one, list) for one in value) and len({len(one) for one in value}) == 1:
        if all(_is_number(number) for one in value for number in one):
            return frozen(np.array(value))
    return value
