"""Modal assurance criterion of results or arrays."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from . import _percuss
from ._analyses import Analysis
from ._arrays import frozen
from ._errors import InputError
from ._shape_documents import ShapeDocument, is_document


_WITH_PLACES = (Analysis, ShapeDocument)


def mac(a: Any, b: Any = None) -> np.ndarray:
    """Compute the modal assurance criterion of mode shapes.

    MAC = abs(aᴴb)² / (aᴴa · bᴴb): 1 for the same shape, 0 for orthogonal ones, whatever the scale of each.

    Parameters
    ----------
    a, b : Analysis, Survey, dict, path or array (modes, places)
        Results of `analyze` and `survey` or their documents (a dictionary, or the path of a JSON file), whose residues or
        shapes are compared at the places (point and channel) that both have; or real or complex arrays of the same places in
        the same order. Without b, a is compared with itself. The points of results and documents are matched by their
        coordinates if both state them, else by the numbers of the geometry or of the files' names, as `compare` does.

    Returns
    -------
    array (modes of a, modes of b)
        Read-only; 0 if a shape is zero everywhere.

    Raises
    ------
    InputError
        Places that do not agree, empty arrays, NaN and infinity; files and dictionaries that are no document of one test.
    TypeError
        Values that are not numbers.

    See Also
    --------
    compare : pairs of modes of tests and models

    Notes
    -----
    Equation (5.4) of docs/theory/theory.md.

    Examples
    --------
    >>> import percuss
    >>> percuss.mac([[1, 2, 3]], [[2, 4, 6], [3, 0, -1]]).round(3).tolist()
    [[1.0, 0.0]]
    >>> a = percuss.analyze(percuss.synth("wood-bat", seed=1), band=(60, 3200))
    >>> b = percuss.analyze(percuss.synth("wood-bat", seed=2), band=(60, 3200))
    >>> percuss.mac(a, b).diagonal().round(3).tolist()
    [1.0, 1.0, 1.0]
    >>> percuss.mac(a.to_dict(), b).diagonal().round(3).tolist()
    [1.0, 1.0, 1.0]
    """
    a, b = (ShapeDocument(one, name) if is_document(one) else one for one, name in ((a, "a"), (b, "b")))
    if isinstance(a, _WITH_PLACES) and isinstance(b, _WITH_PLACES):
        a, b = _at_common_places(a, b)
    first = _shapes(a, "a")
    return frozen(_percuss.mac(first, first if b is None else _shapes(b, "b")))


def _at_common_places(a: Analysis | ShapeDocument, b: Analysis | ShapeDocument) -> tuple[np.ndarray, np.ndarray]:
    mine, others = a._shape_places, b._shape_places
    matched = {theirs: (own, sign) for own, theirs, sign in _percuss.common_points(_document_of(a, mine), _document_of(b, others))}
    signs = [matched[point][1] if point in matched else 0.0 for point, _ in others]
    others = [(matched[point][0] if point in matched else -1, channel) for point, channel in others]
    common = [place for place in mine if place in set(others)]
    if not common:
        raise InputError("the results have no point and channel in common", "mac", "compare tests of the same points and channels")
    if len(common) < 2:
        raise InputError(
            "the results have only one point and channel in common", "mac", "compare tests of several: of one place, MAC is always 1"
        )
    pick = lambda values, places: values[:, [places.index(one) for one in common]]  # noqa: E731
    return pick(a._shape_values, mine), pick(b._shape_values * np.array(signs), others)


def _document_of(result: Analysis | ShapeDocument, places: list[tuple[int, int]]) -> str:
    """A document with one shape of ones at the places, and what the result states of them."""
    residues = [{"point": point, "channel": channel, "re": 1} for point, channel in places]
    mode = {"frequency_hz": 1, "residues": residues}
    document = {"schema": "percuss/analysis/1", "roving": "sensor", "modes": [mode], "places": result._own().get("places") or []}
    return json.dumps(document)


def _shapes(values: Any, name: str) -> np.ndarray:
    """(modes, places), each shape divided by its largest real or imaginary part: squares cannot overflow, and MAC does not change."""
    if isinstance(values, _WITH_PLACES):
        values = values._shape_values
    try:
        array = np.atleast_2d(np.asarray(values))
    except ValueError:
        raise InputError("rows of different lengths", name, "give an array (modes, places)") from None
    if array.dtype.kind not in "biufc":
        raise TypeError(f"{name} holds no numbers: give an array (modes, places), real or complex, or a result or document of analyze() or survey()")
    if array.ndim != 2 or array.size == 0:
        dimensions = " × ".join(str(one) for one in array.shape)
        raise InputError(f"shapes of {dimensions}", name, "give an array (modes, places) with at least one mode and one place")
    bad = np.argwhere(~np.isfinite(array))
    if len(bad):
        raise InputError("not a finite number", f"{name}, mode {bad[0][0]}, place {bad[0][1]}", "remove the place from every shape")
    parts = np.ascontiguousarray(array, dtype=complex).view(float)
    largest = abs(parts).max(axis=1, keepdims=True)
    return (parts / np.where(largest > 0, largest, 1)).view(complex)
