"""Results of surveys: mode shapes."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._analyses import Analysis
from ._optional import table_frame


class Survey(Analysis):
    """A test of many points: an Analysis with mode shapes.

    Attributes
    ----------
    shapes, shapes_std : array (modes, places)
        Complex shapes in 1/√kg if a driving point is known, otherwise scaled to a largest value of 1.
    scale_std : array (modes,)
        Relative standard deviation of the scale of each shape in 1/√kg, common to its places; 0 for other shapes.
    shape_points, shape_channels : array (places,)
        Number of the point, and index of the channel from 0. With a roving hammer all channels contribute to a place, and
        its channel is 0.
    mac : array (modes, modes)
        0 … 1.
    cmif : array (lines, values)
        In (m/s²)/N over `cmif_frequency_hz` (lines,) in Hz.
    """

    def _of_test(self, test: int) -> list[tuple[Any, ...]]:
        return [*super()._of_test(test), ("shapes",)]

    def _shape(self, name: str) -> Any:
        self._require_hits()
        if "shapes" not in self._cache:
            self._cache["shapes"] = self._outcome.shapes()
        return self._cache["shapes"][name]

    @property
    def shapes(self) -> np.ndarray:
        """(modes, places) complex mode shapes: 1/√kg if a driving point is known, otherwise scaled to a largest value of 1."""
        return self._shape("shapes")

    @property
    def shapes_std(self) -> np.ndarray:
        """(modes, places) standard deviation of the real and of the imaginary part, in the unit of shapes. It includes the
        standard deviation of the scale, which the document states apart."""
        return self._shape("shapes_std")

    @property
    def scale_std(self) -> np.ndarray:
        """(modes,) relative standard deviation of the scale of each shape in 1/√kg, common to its places; 0 for other shapes."""
        return self._shape("scale_std")

    @property
    def shape_points(self) -> np.ndarray:
        """(places,) number of the point."""
        return self._shape("points")

    @property
    def shape_channels(self) -> np.ndarray:
        """(places,) index of the channel, from 0; 0 for all places of a roving hammer, to which all channels contribute."""
        return self._shape("channels")

    @property
    def mac(self) -> np.ndarray:
        """(modes, modes) modal assurance criterion between the shapes, 0 … 1."""
        return self._shape("mac")

    @property
    def cmif(self) -> np.ndarray:
        """(lines, values) complex mode indicator function: singular values of the FRFs in (m/s²)/N."""
        return self._shape("cmif")

    @property
    def cmif_frequency_hz(self) -> np.ndarray:
        """(lines,) frequencies of cmif in Hz."""
        return self._shape("cmif_frequency_hz")

    def to_dataframe(self) -> Any:
        """The table as a pandas.DataFrame, with the columns mpc, modal_mass_kg and modal_mass_std_kg where the modes have
        shapes (NaN for modes without a modal mass). Needs pandas."""
        shapes = [mode.get("shape") for mode in self.modes]
        columns = dict(self.table)
        if shapes and all(shapes):
            for name in ("mpc", "modal_mass_kg", "modal_mass_std_kg"):
                values = np.array([np.nan if shape.get(name) is None else shape[name] for shape in shapes], dtype=float)
                if not np.isnan(values).all():
                    columns[name] = values
        return table_frame(columns)

    @property
    def _shape_places(self) -> list[tuple[int, int]]:
        return list(zip(self.shape_points.tolist(), self.shape_channels.tolist()))

    @property
    def _shape_values(self) -> np.ndarray:
        return self.shapes
