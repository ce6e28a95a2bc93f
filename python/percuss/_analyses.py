"""Results of modal analysis: modes and mode shapes."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._arrays import frozen
from ._frf import Frf
from ._results import curves_of


class Analysis(Frf):
    """Hits, FRFs and modes of a test.

    frequency_hz, damping_ratio          (modes,) Hz and fractions of critical damping, with frequency_std_hz and
                                         damping_ratio_std
    residues, residues_std               (modes, points, channels), 1/kg; residues are complex
    family, order                        "bending", "hoop" or "unknown" per mode, and its number within the family
    table                                the columns above except residues, a row per mode
    frf, frf_std                         (points, channels, lines) in (m/s²)/N over frf_frequency_hz (lines,) in Hz
    coherence                            (points, channels, lines), 0 … 1
    hits                                 a dictionary per hit, with its findings
    runs                                 an Analysis per test: of files="tests", or of a file with several runs

    Of a test without a force, the entry "input" is "response": residues are relative to one channel, and there are no FRFs.

    Reading modes or FRFs raises NoHitError if no hit can be used, and UsageError if the result holds several tests.
    """

    @property
    def runs(self) -> list[Analysis]:
        """A result per test; a list of one if there is a single test."""
        return [type(self)(self._outcome, test) for test in range(self._outcome.tests)]

    def _of_test(self, test: int) -> list[tuple[Any, ...]]:
        deflected = [("deflections",)] if "deflection" in self._parsed() else []
        return [*super()._of_test(test), ("modes", test), ("stabilisation", test), *deflected]

    def _own(self) -> dict[str, Any]:
        document, test = self._parsed(), self._test
        return document["runs"][test] if "runs" in document else document

    @property
    def hits(self) -> list[dict[str, Any]]:
        """A dictionary per hit, as in the document: time, peak force, findings."""
        return self._own().get("hits", [])

    @property
    def modes(self) -> list[dict[str, Any]]:
        """A dictionary per mode, as in the document: frequency, damping, family, split mode, residues."""
        return self._own().get("modes", [])

    @property
    def warnings(self) -> list[dict[str, str]]:
        """A dictionary per warning about the test and its results: code, severity, message, remedy."""
        return self._own().get("warnings", [])

    def _of_free_decays(self, name: str) -> np.ndarray:
        if name not in ("residues", "residues_std"):
            return frozen(np.array([mode[name] for mode in self.modes], dtype=float))
        rows = [mode["residues"] for mode in self.modes]
        if name == "residues_std":
            return frozen(np.array([[r["std"] for r in row] for row in rows], dtype=float))
        return frozen(np.array([[complex(r["re"], r["im"]) for r in row] for row in rows], dtype=complex))

    def _column(self, name: str) -> np.ndarray:
        if self._own().get("input") == "response":
            return self._of_free_decays(name)
        self._require_hits()
        return self._computed("modes")[name]

    @property
    def frequency_hz(self) -> np.ndarray:
        """(modes,) natural frequencies in Hz."""
        return self._column("frequency_hz")

    @property
    def frequency_std_hz(self) -> np.ndarray:
        """(modes,) standard deviation of the natural frequencies in Hz."""
        return self._column("frequency_std_hz")

    @property
    def damping_ratio(self) -> np.ndarray:
        """(modes,) damping ratios, fractions of critical damping."""
        return self._column("damping_ratio")

    @property
    def damping_ratio_std(self) -> np.ndarray:
        """(modes,) standard deviation of the damping ratios."""
        return self._column("damping_ratio_std")

    @property
    def residues(self) -> np.ndarray:
        """(modes, points, channels) complex residues in 1/kg."""
        return self._by_place("residues")

    @property
    def residues_std(self) -> np.ndarray:
        """(modes, points, channels) standard deviation of the real and of the imaginary part in 1/kg."""
        return self._by_place("residues_std")

    @property
    def frf_std(self) -> np.ndarray | None:
        """(points, channels, lines) standard deviation of the FRFs in (m/s²)/N; None if a point has a single hit."""
        return self._responses.std

    def _by_place(self, name: str) -> np.ndarray:
        values = self._column(name)
        if self._own().get("input") == "response":
            return values.reshape(len(values), 1, -1) if values.size else values.reshape(0, 0, 0)
        channels = len({channel for _, channel in self._computed("modes")["places"]}) or 1
        return values.reshape(len(values), -1, channels) if values.size else values.reshape(0, 0, 0)

    @property
    def frf_frequency_hz(self) -> np.ndarray:
        """(lines,) frequencies of the FRFs in Hz."""
        self._require_hits()
        return self._computed("frequency_hz")

    @property
    def family(self) -> list[str]:
        """A list: "bending", "hoop" or "unknown" for each mode."""
        return [mode["family"] for mode in self.modes]

    @property
    def order(self) -> np.ndarray:
        """(modes,) number of the mode within its family, from 1; 0 if the family is unknown."""
        return frozen(np.array([mode["order"] or 0 for mode in self.modes], dtype=int))

    @property
    def confidence(self) -> np.ndarray:
        """(modes,) probability of the family."""
        return frozen(np.array([mode["confidence"] for mode in self.modes], dtype=float))

    @property
    def table(self) -> dict[str, np.ndarray]:
        """Columns (modes,): frequency_hz, damping_ratio and their standard deviations; also family, order and confidence if the
        document holds them. pandas.DataFrame accepts it."""
        names = ("frequency_hz", "frequency_std_hz", "damping_ratio", "damping_ratio_std")
        out = {name: self._column(name) for name in names}
        if len(self.modes) == len(self.frequency_hz) and all("family" in mode for mode in self.modes):
            out |= {"family": frozen(np.array(self.family, dtype=str)), "order": self.order, "confidence": self.confidence}
        return out

    def stabilisation(self) -> dict[str, Any]:
        """The stabilisation diagram as a dictionary: order, frequency_hz in Hz and damping_ratio, (poles,) each; stability, a list
        of texts. Raises NoHitError if no hit can be used."""
        self._require_hits()
        return self._computed("stabilisation")

    def deflections(self) -> list[dict[str, Any]]:
        """Deflection over time, as Deflection.curves(). Raises TypeError unless only= includes deflection."""
        return curves_of(self._outcome)


class Survey(Analysis):
    """A test of many points: an Analysis with mode shapes.

    shapes, shapes_std             (modes, places): complex shapes in 1/√kg if a driving point is known, otherwise scaled
                                   to a largest value of 1
    shape_points, shape_channels   (places,)
    mac                            (modes, modes), 0 … 1
    cmif                           (lines, values) in (m/s²)/N over cmif_frequency_hz (lines,) in Hz
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
        """(modes, places) standard deviation of the real and of the imaginary part, in the unit of shapes."""
        return self._shape("shapes_std")

    @property
    def shape_points(self) -> np.ndarray:
        """(places,) index of the point, from 0."""
        return frozen(np.array(self._shape("points")))

    @property
    def shape_channels(self) -> np.ndarray:
        """(places,) index of the channel, from 0."""
        return frozen(np.array(self._shape("channels")))

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
