"""Types of the functions' parameters."""

from __future__ import annotations

import os
from typing import Any, Dict, List, Mapping, Sequence, Tuple, Union

import numpy as np

from ._frf import Frf
from ._records import Record
from ._results import Result

Path = Union[str, bytes, os.PathLike[str]]
Paths = Union[Path, Sequence[Path]]
Array = Union[np.ndarray, Sequence[Any]]
# Files, records, FRFs, results that hold them, or arrays.
Data = Union[Path, Record, Frf, Result, Array, None]
# A file, or its content: an array, a dictionary, a result.
File = Union[Path, Dict[str, Any], Result, Array]
Band = Union[str, Tuple[float, float]]
# LO:HI, LO:STEP:HI and such: a tuple, a text, or a list of them.
Range = Union[str, Sequence[Union[float, str]], Sequence[Sequence[Union[float, str]]]]
Numbers = Union[float, Sequence[float], np.ndarray]
# A number in SI, or a text with a unit: "136mph".
Quantity = Union[float, str]
Quantities = Union[Quantity, Sequence[Quantity], np.ndarray]
Rate = Union[float, str, np.ndarray]
Texts = Union[str, int, Sequence[Union[str, int]]]
Assignments = Union[str, Mapping[str, Any], Sequence[str]]
Measured = Union[Record, Frf, List[Union[Record, Frf]]]
