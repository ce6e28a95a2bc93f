"""Tables with named columns in place of a file: dictionaries of columns, structured arrays and data frames."""

from __future__ import annotations

import csv
import io
from typing import Any

import numpy as np

from ._arrays import frozen
from ._errors import InputError

# Keywords that take a dictionary as columns; for other keywords a dictionary is a JSON document.
_TABLES = ("profile", "geometry", "bats")


def columns_of(value: Any, name: str) -> dict[str, np.ndarray] | None:
    """The columns by name; None for a value that is no such table."""
    if isinstance(value, np.ndarray) and value.dtype.names:
        return {str(one): value[one] for one in value.dtype.names}
    if hasattr(value, "columns") and hasattr(value, "to_numpy"):  # pandas.DataFrame
        return {str(one): np.asarray(value[one]) for one in value.columns}
    if name not in _TABLES or not isinstance(value, dict) or not value:
        return None
    columns = {str(key): np.asarray(one) for key, one in value.items()}
    return columns if all(one.ndim == 1 and one.dtype.kind in "iufU" for one in columns.values()) else None


def columns_text(columns: dict[str, np.ndarray], name: str) -> str:
    """The table as CSV, its numbers with all their digits."""
    lengths = {key: len(one) for key, one in columns.items() if one.ndim == 1}
    if len(lengths) < len(columns) or len(set(lengths.values())) != 1:
        told = ", ".join(f"{key} {one.shape[0] if one.ndim else 1}" for key, one in columns.items())
        raise InputError(f"columns of different lengths: {told}", name, "give each column a value for each row")
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*(one.tolist() for one in columns.values())))
    return out.getvalue()


def columns_of_csv(text: str) -> dict[str, np.ndarray]:
    """The columns of a table that the library wrote as CSV: numbers, with NaN for empty fields, or texts."""
    names, *rows = list(csv.reader(io.StringIO(text))) or [[]]
    return {name: frozen(_numbers_or_texts(name, [row[i] for row in rows])) for i, name in enumerate(names)}


def _numbers_or_texts(name: str, fields: list[str]) -> np.ndarray:
    if name in ("id", "bat"):  # texts, also where they look like numbers
        return np.array(fields, dtype=str)
    try:
        return np.array([float(field) if field else np.nan for field in fields])
    except ValueError:
        return np.array(fields, dtype=str)
