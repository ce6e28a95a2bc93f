"""Results of modal analysis."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._arrays import frozen
from ._plots import plot_analysis
from ._results import curves_of
from ._synthesis import laplace_of, synthesised
from ._tests import TestResult


class Analysis(TestResult):
    """Hits, FRFs and modes of a test.

    Attributes
    ----------
    frequency_hz, damping_ratio : array (modes,)
        Hz, and fractions of critical damping, with `frequency_std_hz` and `damping_ratio_std`.
    poles : array (modes,)
        Complex, in rad/s.
    residues, residues_std : array (modes, points, channels)
        1/kg; residues are complex.
    lower, upper, upper_4, upper_6 : array (points, channels)
        Complex residual terms of the modes below and above the band.
    family, order : list, array (modes,)
        "bending", "hoop" or "unknown", and the number of the mode within its family.
    hits, modes, warnings : list of dict
        As in the document.
    runs : list of Analysis
        One per test: of files="tests", or of a file with several runs.

    Notes
    -----
    `frf()` returns the FRFs, `synthesise()` computes them from the modes. Of a test without a force, the entry "input" is
    "response": residues are relative to one channel, and there are no FRFs. Reading modes or FRFs raises NoHitError if no hit
    can be used, and UsageError if the result holds several tests.
    """

    @property
    def runs(self) -> list[Analysis]:
        """A result per test, as if each had been analysed alone; a list of one if there is a single test."""
        if self._outcome.tests < 2:
            return [self]
        if "runs" not in self._cache:
            self._cache["runs"] = [type(self)(self._outcome.of_test(test)) for test in range(self._outcome.tests)]
        return list(self._cache["runs"])

    def _pickled_tests(self) -> list[Any]:
        return [one.__getstate__()["_outcome"] for one in self.runs] if self._outcome.tests > 1 else []

    def _of_test(self, test: int) -> list[tuple[Any, ...]]:
        deflected = [("deflections",)] if "deflection" in self._parsed() else []
        return [*super()._of_test(test), ("modes", test), ("residual_terms", test), ("stabilisation", test), *deflected]

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
    def poles(self) -> np.ndarray:
        """(modes,) complex poles s = −ζω + jω√(1 − ζ²) in rad/s."""
        omega, ratio = 2 * np.pi * self.frequency_hz, self.damping_ratio
        return frozen(omega * (-ratio + 1j * np.sqrt(1 - ratio**2)))

    def _residual_term(self, name: str) -> np.ndarray:
        self._require_hits()
        terms = self._computed("residual_terms")
        return terms[name].reshape(len({point for point, _ in terms["places"]}), -1)

    @property
    def lower(self) -> np.ndarray:
        """(points, channels) complex accelerance of the modes below the band and the rigid body, in 1/kg."""
        return self._residual_term("lower")

    @property
    def upper(self) -> np.ndarray:
        """(points, channels) complex receptance of the modes above the band, in m/N."""
        return self._residual_term("upper")

    @property
    def upper_4(self) -> np.ndarray:
        """(points, channels) complex, the next term of the modes above the band, in m·s²/N."""
        return self._residual_term("upper_4")

    @property
    def upper_6(self) -> np.ndarray:
        """(points, channels) complex, the term after `upper_4`, in m·s⁴/N."""
        return self._residual_term("upper_6")

    @property
    def frac(self) -> np.ndarray:
        """(points, channels) frequency response assurance criterion of measured and synthesised FRF: 1 if they are equal.

        Synthesised from all fitted modes, listed by `start` and `modes` or not; so are the residual terms.
        """
        return self._residual_term("frac")

    def synthesise(self, freq_hz: Any, kind: str = "accelerance", residual_terms: bool = True) -> np.ndarray:
        """Compute the FRFs of the modes at any frequencies.

        H(ω) = Σ A s² / (s² + 2ζωₙs + ωₙ²) + lower + upper s² + upper_4 s⁴ + upper_6 s⁶, s = jω.

        Parameters
        ----------
        freq_hz : array (lines,)
            Frequencies in Hz. The residual terms hold within the band only.
        kind : {'accelerance', 'mobility', 'receptance'}, optional
            Default: accelerance.
        residual_terms : bool, optional
            False leaves out `lower`, `upper`, `upper_4` and `upper_6`.

        Returns
        -------
        array (points, channels, lines)
            Complex, in (m/s²)/N, (m/s)/N or m/N.

        Raises
        ------
        InputError
            Frequencies that are not finite; residual terms of a test without a force.
        NoHitError
            No hit can be used.
        UsageError
            An unknown kind.

        Notes
        -----
        If the record ends before the decay, the measured FRF differs from this one by the missing part of the decay.
        Modes of the fit that `start` or `modes` do not list are not part of it.

        Examples
        --------
        >>> import numpy as np, percuss
        >>> found = percuss.analyze(percuss.synth("wood-bat"), band=(60, 3200))
        >>> found.synthesise([165.0, 170.0]).shape
        (1, 2, 2)
        """
        return synthesised(self, laplace_of(freq_hz), kind, residual_terms)

    @property
    def _shape_places(self) -> list[tuple[int, int]]:
        """The point and channel of each value of a shape."""
        if self._own().get("input") == "response":
            return [(one["point"], one["channel"]) for one in self.modes[0]["residues"]] if self.modes else []
        self._require_hits()
        return [(int(point), int(channel)) for point, channel in self._computed("modes")["places"]]

    @property
    def _shape_values(self) -> np.ndarray:
        """(modes, places)"""
        modes, points, channels = self.residues.shape
        return self.residues.reshape(modes, points * channels)

    def plot(self, what: str = "frf", *, point: int | None = None, channel: int | None = None, ax: Any = None) -> Any:
        """Draw the result with matplotlib.

        Parameters
        ----------
        what : {'frf', 'stabilisation', 'shapes'}, optional
            The measured FRFs with the fit; the stabilisation diagram; the shape of each mode (of a survey, or the residues over
            the channels).
        point, channel : int, optional
            Draw the FRFs of this point or channel only.
        ax : axes, or a sequence of them, optional
            Draw here; two axes for FRFs, one per mode for shapes. Default: a new figure.

        Returns
        -------
        axes, or a list of axes

        Raises
        ------
        ImportError
            Without matplotlib.
        KeyError
            No FRF of this point or channel.
        UsageError
            An unknown drawing; shapes without modes; axes that are too few or too many.
        """
        return plot_analysis(self, what, point, channel, ax)

    def _by_place(self, name: str) -> np.ndarray:
        values = self._column(name)
        if self._own().get("input") == "response":
            return values.reshape(len(values), 1, -1) if values.size else values.reshape(0, 0, 0)
        of = "modes" if len(values) else "residual_terms"  # without modes, only these hold the places
        places = [(int(point), int(channel)) for point, channel in self._computed(of)["places"]]
        points, channels = (len(set(one)) for one in zip(*places)) if places else (0, 0)
        return values.reshape(len(values), points, channels)

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
