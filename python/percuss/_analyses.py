"""Results that are made of an analysis: modes, shapes."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._arrays import frozen
from ._frf import Frf
from ._results import curves_of


class Analysis(Frf):
    """Hits, FRFs and modes of a test.

    frequency_hz, frequency_std_hz, damping_ratio, damping_ratio_std (modes,): every mode with one standard deviation.
    residues, residues_std (modes, points, channels): complex, 1/kg. family, a list, and order (modes,): "bending" or "hoop"
    and its number. table: all of these but the residues, a row per mode.
    frf, frf_std, coherence (points, channels, lines) over frf_frequency_hz (lines,). hits: what was found about each.
    runs: the tests, where the files were several (files="tests").
    """

    @property
    def runs(self) -> list[Analysis]:
        """Each test as a result of its own; of one test it alone."""
        return [type(self)(self._outcome, test) for test in range(self._outcome.tests)]

    def _of_test(self, test: int) -> list[tuple[Any, ...]]:
        deflected = [("deflections",)] if "deflection" in self._parsed() else []
        return [*super()._of_test(test), ("modes", test), ("stabilisation", test), *deflected]

    def _own(self) -> dict[str, Any]:
        document, test = self._parsed(), self._test
        return document["runs"][test] if "runs" in document else document

    @property
    def hits(self) -> list[dict[str, Any]]:
        """What was found out about each hit, as in the document."""
        return self._own().get("hits", [])

    @property
    def modes(self) -> list[dict[str, Any]]:
        """Each mode as in the document: frequency, damping, family, double peaks, residues."""
        return self._own().get("modes", [])

    @property
    def warnings(self) -> list[dict[str, str]]:
        """What to be aware of: code and message."""
        return self._own().get("warnings", [])

    def _column(self, name: str) -> np.ndarray:
        self._require_hits()
        return self._computed("modes")[name]

    @property
    def frequency_hz(self) -> np.ndarray:
        """(modes,) natural frequencies, Hz."""
        return self._column("frequency_hz")

    @property
    def frequency_std_hz(self) -> np.ndarray:
        """(modes,) standard deviation, Hz."""
        return self._column("frequency_std_hz")

    @property
    def damping_ratio(self) -> np.ndarray:
        """(modes,) of critical damping, 0 … 1."""
        return self._column("damping_ratio")

    @property
    def damping_ratio_std(self) -> np.ndarray:
        """(modes,) standard deviation."""
        return self._column("damping_ratio_std")

    @property
    def residues(self) -> np.ndarray:
        """(modes, points, channels) complex, 1/kg."""
        return self._by_place("residues")

    @property
    def residues_std(self) -> np.ndarray:
        """(modes, points, channels) of real and imaginary part, 1/kg."""
        return self._by_place("residues_std")

    @property
    def frf_std(self) -> np.ndarray | None:
        """(points, channels, lines) (m/s²)/N, or None."""
        return self._responses.std

    def _by_place(self, name: str) -> np.ndarray:
        values = self._column(name)
        channels = len({channel for _, channel in self._computed("modes")["places"]}) or 1
        return values.reshape(len(values), -1, channels) if values.size else values.reshape(0, 0, 0)

    @property
    def frf_frequency_hz(self) -> np.ndarray:
        """(lines,) frequencies of the FRFs, Hz."""
        self._require_hits()
        return self._computed("frequency_hz")

    @property
    def family(self) -> list[str]:
        """A list, for each mode "bending", "hoop" or "unknown"."""
        return [mode["family"] for mode in self.modes]

    @property
    def order(self) -> np.ndarray:
        """(modes,) counts from 1 within the family; 0 where the family is unknown."""
        return frozen(np.array([mode["order"] or 0 for mode in self.modes], dtype=int))

    @property
    def confidence(self) -> np.ndarray:
        """(modes,) probability of the family."""
        return frozen(np.array([mode["confidence"] for mode in self.modes], dtype=float))

    @property
    def table(self) -> dict[str, np.ndarray]:
        """A row per mode: frequency_hz, damping_ratio, their std, and where the document has them family, order, confidence,
        (modes,) each. pandas.DataFrame takes it."""
        names = ("frequency_hz", "frequency_std_hz", "damping_ratio", "damping_ratio_std")
        out = {name: self._column(name) for name in names}
        if len(self.modes) == len(self.frequency_hz) and all("family" in mode for mode in self.modes):
            out |= {"family": frozen(np.array(self.family, dtype=str)), "order": self.order, "confidence": self.confidence}
        return out

    def stabilisation(self) -> dict[str, Any]:
        """The stabilisation diagram: order, frequency_hz and damping_ratio (poles,) and stability, a word for each."""
        self._require_hits()
        return self._computed("stabilisation")

    def deflections(self) -> list[dict[str, Any]]:
        """With deflection among the sections: as Deflection.curves()."""
        return curves_of(self._outcome)


class Survey(Analysis):
    """A test of many points: as Analysis, and the modes' shapes.

    shapes, shapes_std (modes, places), complex: 1/√kg where a driving point is known, else 1 at the largest; the places
    are shape_points and shape_channels (places,). mac (modes, modes). cmif (lines, values) over cmif_frequency_hz.
    """

    def _of_test(self, test: int) -> list[tuple[Any, ...]]:
        return [*super()._of_test(test), ("shapes",)]

    def _shape(self, name: str) -> Any:
        self._require_hits()
        if "shapes" not in self._kept:
            self._kept["shapes"] = self._outcome.shapes()
        return self._kept["shapes"][name]

    @property
    def shapes(self) -> np.ndarray:
        """(modes, places) complex."""
        return self._shape("shapes")

    @property
    def shapes_std(self) -> np.ndarray:
        """(modes, places) of real and imaginary part."""
        return self._shape("shapes_std")

    @property
    def shape_points(self) -> np.ndarray:
        """(places,) index of the point, from 0."""
        return frozen(np.array(self._shape("points")))

    @property
    def shape_channels(self) -> np.ndarray:
        """(places,) the channel, from 0."""
        return frozen(np.array(self._shape("channels")))

    @property
    def mac(self) -> np.ndarray:
        """(modes, modes) how alike the shapes are, 0 … 1."""
        return self._shape("mac")

    @property
    def cmif(self) -> np.ndarray:
        """(lines, values) singular values of the FRFs, (m/s²)/N."""
        return self._shape("cmif")

    @property
    def cmif_frequency_hz(self) -> np.ndarray:
        """(lines,) Hz."""
        return self._shape("cmif_frequency_hz")
