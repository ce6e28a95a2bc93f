"""Mode shapes in documents of analyze and survey."""

from __future__ import annotations

import json
import math
import os
from typing import Any

import numpy as np

from . import _percuss
from ._errors import InputError

_SCHEMA = "percuss/analysis/1"
_REMEDY = "give a document that percuss.analyze() or percuss.survey() wrote, or an array (modes, places)"


def is_document(value: Any) -> bool:
    """A document as a dictionary, or the path of a file."""
    return isinstance(value, (dict, str, bytes, os.PathLike))


class ShapeDocument:
    """The shapes of a document of one test, at their places as Analysis and Survey have them. Raises InputError."""

    def __init__(self, value: Any, name: str) -> None:
        self._document, self._where = (value, name) if isinstance(value, dict) else _read(value)
        self._require_one_test()
        try:
            modes = [{(int(r["point"]), int(r["channel"])): r for r in mode["residues"]} for mode in self._document["modes"]]
            # The places that all modes have.
            self._shape_places = [one for one in modes[0] if all(one in mode for mode in modes)]
            rows = np.array([[_parts(mode[place]) for place in self._shape_places] for mode in modes])
        except (KeyError, TypeError, ValueError, AttributeError):
            raise InputError("the modes have no residues at points and channels", self._where, _REMEDY) from None
        if not self._shape_places:
            raise InputError("the modes have no residues at points and channels", self._where, _REMEDY)
        self._shape_values = rows[..., 0] + 1j * rows[..., 1]
        if self._document.get("roving") == "hammer":
            self._join_channels(rows)

    def _require_one_test(self) -> None:
        if not isinstance(self._document, dict):
            raise InputError("not a document of percuss", self._where, _REMEDY)
        schema = self._document.get("schema", _SCHEMA if "modes" in self._document else "dictionary without a schema")
        if schema != _SCHEMA:
            raise InputError(f"a {schema} has no mode shapes", self._where, _REMEDY)
        if "runs" in self._document:
            tests = len(self._document["runs"])
            raise InputError(f"the document holds {tests} tests", self._where, 'give one of them, such as document["runs"][0]')
        if not self._document.get("modes"):
            raise InputError("the document has no modes", self._where, "choose a band with modes; see the warnings of the document")

    def _join_channels(self, rows: np.ndarray) -> None:
        """The shapes over the points: with a roving hammer, all channels contribute to the value of a point."""
        places = np.array(self._shape_places, dtype=float)
        if not np.isfinite(rows).all():
            return  # mac() refuses the value and names it
        shapes = [_percuss.shape_over_points(np.column_stack([places, mode])) for mode in rows]
        self._shape_places = [(point, 0) for point in sorted({point for point, _ in self._shape_places})]
        self._shape_values = np.array(shapes)

    def _own(self) -> dict[str, Any]:
        return self._document


def _parts(residue: dict[str, Any]) -> tuple[float, float, float]:
    return float(residue["re"]), float(residue.get("im") or 0), float(residue.get("std") or 0)


def _read(path: Any) -> tuple[Any, str]:
    where = os.fsdecode(path)
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file, parse_constant=lambda _: math.nan), where
    except OSError as error:
        raise InputError(f"cannot read the file: {error.strerror}", where, "check the path") from None
    except ValueError:  # also an encoding that is not UTF-8
        raise InputError("not a JSON document", where, _REMEDY + "; for a record, the document of percuss.analyze()") from None
    except RecursionError:
        raise InputError("nested too deeply for a document", where, _REMEDY) from None
