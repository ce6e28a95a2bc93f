"""FRFs from arrays, and FRFs, poles and residual terms of results, against exact modes."""

import copy
import pickle

import numpy as np
import pytest

import percuss

BAND = (60, 3200)
FREQ_HZ = np.arange(1.0, 801.0)
MODES_HZ, DAMPING = np.array([150.0, 430.0]), np.array([0.01, 0.004])
ROUNDING = 1e-12  # a few operations per number; they leave less than 1e-15
FIT = 1e-9  # a fit to exact FRFs; it leaves less than 1e-15, relative or in 1/kg
RESIDUES = np.array([[[0.5, -0.2], [0.3, 0.4]], [[-0.1, 0.6], [0.2, 0.2]]])  # (modes, points, channels), 1/kg
POLES = 2 * np.pi * MODES_HZ * (-DAMPING + 1j * np.sqrt(1 - DAMPING**2))  # rad/s


def modal_sum(residues, s, power=2):
    """(…, lines): accelerance at s of residues (modes, …), with power 1 mobility, with 0 receptance."""
    omega = 2 * np.pi * MODES_HZ[:, None]
    return np.einsum("m...,ml->...l", residues, s**power / (s**2 + 2 * DAMPING[:, None] * omega * s + omega**2))


def exact(freq_hz, power=2):
    """(points, channels, lines): accelerance, with power 1 mobility, with 0 receptance."""
    return modal_sum(RESIDUES, 2j * np.pi * np.asarray(freq_hz), power)


@pytest.fixture(scope="module")
def found():
    return percuss.analyze(percuss.Frf(FREQ_HZ, exact(FREQ_HZ)), band=(60, 700), object="other")


@pytest.mark.parametrize("kind, power", [("accelerance", 2), ("mobility", 1), ("receptance", 0)])
def test_frfs_from_arrays_have_their_modes(kind, power):
    frf = percuss.Frf(FREQ_HZ, exact(FREQ_HZ, power), kind=kind)
    seen = percuss.analyze(frf, band=(60, 700))
    assert np.allclose(seen.frequency_hz, MODES_HZ, rtol=FIT) and np.allclose(seen.damping_ratio, DAMPING, rtol=FIT)
    assert np.allclose(seen.residues, RESIDUES, rtol=0, atol=FIT)


def test_poles_and_residual_terms_are_arrays(found):
    assert np.allclose(found.poles, POLES, rtol=FIT)
    assert found.lower.shape == found.upper.shape == found.upper_4.shape == found.upper_6.shape == found.frac.shape == (2, 2)
    fit = {(one["point"], one["channel"]): one for one in found.to_dict()["fit"]}
    for p in range(2):
        for c in range(2):
            one = fit[p, c]
            assert found.lower[p, c] == complex(one["lower"]["re"], one["lower"]["im"]) and found.frac[p, c] == one["frac"]
            assert found.upper[p, c] == complex(one["upper"]["re"], one["upper"]["im"])
            assert found.upper_4[p, c] == complex(one["upper_4"]["re"], one["upper_4"]["im"])
            assert found.upper_6[p, c] == complex(one["upper_6"]["re"], one["upper_6"]["im"])


@pytest.mark.parametrize("kind, power", [("accelerance", 2), ("mobility", 1), ("receptance", 0)])
def test_synthesised_frfs_are_exact(found, kind, power):
    freq_hz = [0.5, 150.0, 151.3, 640.0, 5000.0]  # within the band, and beyond it
    wanted = exact(freq_hz, power)
    made = found.synthesise(freq_hz, kind, residual_terms=False)
    assert made.shape == (2, 2, 5) and np.allclose(made, wanted, rtol=FIT, atol=0)
    within = found.synthesise(freq_hz[1:4], kind)
    assert np.allclose(within, wanted[..., 1:4], rtol=FIT, atol=FIT * abs(wanted).max())
    for bad in ([np.nan], [[1.0]]):
        with pytest.raises(percuss.InputError):
            found.synthesise(bad)


def test_residual_terms_stand_for_modes_outside_the_band():
    """A mode at 2 kHz and a rigid mass of 4 kg, with a fit from 60 to 700 Hz. The residual terms are three of a series in (f/2 kHz)²."""
    omitted = (700 / 2000) ** 6  # the first term that is left out, relative to the first one
    s = 2j * np.pi * FREQ_HZ
    outside = 0.3 * s**2 / (s**2 + 2 * 0.01 * 2 * np.pi * 2000 * s + (2 * np.pi * 2000) ** 2) + 1 / 4
    seen = percuss.analyze(percuss.Frf(FREQ_HZ, exact(FREQ_HZ)[0, 0] + outside), band=(60, 700), object="other")
    largest = 0.3 * (700 / 2000) ** 2 * omitted  # accelerance that the series leaves out, at the end of the band
    assert abs(seen.lower[0, 0] - 1 / 4) < largest
    assert abs(seen.upper[0, 0] * (2 * np.pi * 2000) ** 2 / 0.3 - 1) < 2 * omitted  # the fit changes it to make up for the omitted terms
    frf = seen.frf()
    assert abs(seen.synthesise(frf.frequency_hz) - frf.H).max() < largest


def test_a_result_gives_its_frfs(bat):
    seen = percuss.analyze(bat, band=BAND)
    frf = seen.frf()
    assert isinstance(frf, percuss.Frf) and frf.kind == "accelerance" and frf is seen.frf()
    assert np.array_equal(frf.H, percuss.frf(bat, band=BAND).H) and np.asarray(frf) is frf.H
    mobility = seen.frf("mobility")
    assert np.allclose(mobility.H * 2j * np.pi * mobility.frequency_hz, frf.H, rtol=ROUNDING) and mobility.unit == "(m/s)/N"
    again = percuss.analyze(frf, band=BAND)  # without the lines outside the band, which the first fit used
    assert (abs(again.frequency_hz - seen.frequency_hz) < seen.frequency_std_hz).all() and not again.hits
    assert np.allclose(percuss.analyze(mobility, band=BAND).residues, again.residues, rtol=FIT)
    assert np.array_equal(percuss.analyze(percuss.frf(bat, band=BAND), band=BAND).residues, again.residues)
    windowed = percuss.analyze(bat, band=BAND, exponential=0.01)
    # The FRFs carry the decay rate of their window.
    of_frfs = percuss.analyze(windowed.frf(), band=BAND).damping_ratio
    assert (abs(of_frfs - windowed.damping_ratio) < windowed.damping_ratio_std).all()


def test_reading_options_apply_to_frfs_of_arrays():
    frf = percuss.Frf(FREQ_HZ, exact(FREQ_HZ)[:1] / 9.80665)
    in_g = percuss.analyze(frf, band=(60, 700), unit="g", angle=(0, 90))
    assert np.allclose(in_g.residues, RESIDUES[:, :1], rtol=FIT)
    with pytest.raises(TypeError, match="percuss.read"):
        percuss.analyze(percuss.synth("wood-bat").record, unit="g")


def test_frfs_are_pickled_written_and_read(tmp_path, found):
    std = np.full((2, 2, 800), 1e-3)
    frf = percuss.Frf(FREQ_HZ, exact(FREQ_HZ), std=std, coherence=1 - std, points=[3, 1], names=["x", "y"], averages=4)
    assert frf.points.tolist() == [1, 3] and np.array_equal(frf.at(3, 1), exact(FREQ_HZ)[0, 1])
    for again in (pickle.loads(pickle.dumps(frf)), copy.deepcopy(frf), copy.copy(frf)):
        assert repr(again) == repr(frf) and again.names == ["x", "y"] and not again.H.flags.writeable
        assert all(np.array_equal(getattr(again, name), getattr(frf, name)) for name in ("frequency_hz", "H", "std", "coherence", "points"))
    percuss.write(tmp_path / "frfs.h5", frf)
    read = percuss.read(tmp_path / "frfs.h5")
    assert np.array_equal(read.H, frf.H) and read.format == "FRF HDF5" and read.stored_kind == "accelerance"
    assert np.array_equal(pickle.loads(pickle.dumps(read)).H, read.H)
    percuss.write(tmp_path / "again.h5", found.frf())
    assert np.array_equal(pickle.loads(pickle.dumps(found)).synthesise([100.0]), found.synthesise([100.0]))


@pytest.mark.parametrize("kind", ["h5", "mat", "csv", "uff"])
def test_write_lists_what_a_format_drops(tmp_path, kind):
    """What it does not list is read as it was written."""
    std = np.full((1, 2, 800), 1e-3)
    full = {"std": std, "coherence": 1 - std, "averages": 4, "names": ["x", "y"]}
    for options in (full, {**full, "averages": 0}, {"std": std}, {}):
        frf = percuss.Frf(FREQ_HZ, exact(FREQ_HZ)[:1], **options)
        notes = " ".join(percuss.write(tmp_path / f"frfs.{kind}", frf, force=True))
        read = percuss.read(tmp_path / f"frfs.{kind}")
        assert ("names" in notes) == (read.names != ["accel 1", "accel 2"] or "names" in options)
        assert ("standard deviations" in notes) == (frf.std is not None and read.std is None), options
        assert (frf.coherence is None) == (read.coherence is None)
        assert ("averages" in notes) == (frf._responses.min_averages != read._responses.min_averages), options


@pytest.mark.parametrize("given, options, wanted", [
    ((FREQ_HZ, exact(FREQ_HZ)[..., :-1]), {}, "799 values for 800 frequencies"),
    ((FREQ_HZ, np.zeros((1, 1, 1, 800))), {}, "give \\(points, channels, lines\\)"),
    ((FREQ_HZ**1.1, exact(FREQ_HZ)), {}, "frequency_hz"),
    ((FREQ_HZ[::-1], exact(FREQ_HZ)), {}, "frequency_hz"),
    ((FREQ_HZ[None], exact(FREQ_HZ)), {}, "frequency_hz"),
    ((FREQ_HZ, np.where(FREQ_HZ == 5, np.nan, exact(FREQ_HZ))), {}, "H, point 0, channel 0, line 4"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"std": np.ones(800)}, "give the shape of H"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"points": [1, 1]}, "twice"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"points": [1, -1]}, "-1 is no number of a point"),
    ((FREQ_HZ - 400, exact(FREQ_HZ)), {}, "-399 is no frequency \\(frequency_hz, line 0\\)"),
    ((np.where(FREQ_HZ == 5, np.nan, FREQ_HZ), exact(FREQ_HZ)), {}, "nan is no frequency \\(frequency_hz, line 4\\)"),
    ((FREQ_HZ[::-1], exact(FREQ_HZ)), {}, "do not rise: 800 Hz before 799 Hz"),
    ((FREQ_HZ + 0.1 * (FREQ_HZ == 9), exact(FREQ_HZ)), {}, "9.1 Hz is not a multiple"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"coherence": np.full((2, 2, 800), 1.1)}, "1.1 is impossible \\(coherence, point 0"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"coherence": np.full((2, 2, 800), -0.1)}, "-0.1 is impossible \\(coherence, point 0"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"std": np.full((2, 2, 800), -1)}, "-1 is impossible \\(std, point 0"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"std": np.full((2, 2, 800), np.nan)}, "not a finite number \\(std, point 0"),
    ((FREQ_HZ, np.ma.masked_less(exact(FREQ_HZ).real, 0)), {}, "masked numbers \\(H\\)"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"averages": -1}, "-1 is no number of hits"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"averages": 2.5}, "2.5 is no number of hits"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"averages": np.nan}, "nan is no number of hits"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"names": "xy"}, "'xy' is not a list of names"),
    ((FREQ_HZ, exact(FREQ_HZ)), {"names": ["x"]}, "1 names for 2 channels"),
])  # fmt: skip
def test_arrays_that_are_no_frfs_are_rejected(given, options, wanted):
    with pytest.raises(percuss.InputError, match=wanted):
        percuss.Frf(*given, **options)


def test_unknown_kinds_are_usage_errors(found):
    for call in (
        lambda: percuss.Frf(FREQ_HZ, exact(FREQ_HZ), kind="inertance"),
        lambda: found.frf("inertance"),
        lambda: found.synthesise([100.0], "inertance"),
    ):
        with pytest.raises(percuss.UsageError, match="kind= cannot be 'inertance'; give accelerance, mobility or receptance"):
            call()


def test_mac_compares_results():
    a, b = (percuss.analyze(percuss.synth("wood-bat", seed=seed), band=BAND) for seed in (1, 2))
    noise = (max((one.residues_std / abs(one.residues)).max() for one in (a, b))) ** 2  # 1 − MAC is at most about this
    assert (1 - percuss.mac(a, b).diagonal() < noise).all() and noise < 1e-6 and percuss.mac is percuss.metrics.mac
    assert np.array_equal(percuss.mac(a), percuss.mac(a, a)) and np.allclose(percuss.mac(a, b.residues.reshape(3, -1)), percuss.mac(a, b))
    barrel = percuss.survey(percuss.synth("roving-barrel"), band=BAND, effort="quick")
    assert np.allclose(percuss.mac(barrel, barrel), barrel.mac, atol=ROUNDING)
    # Places in common: points 0 and 2 of three.
    shapes = np.array([[1.0, 2.0, -1.0], [0.5, -1.0, 1.0]])
    part = {points: percuss.analyze(percuss.Frf(FREQ_HZ, responses_of(shapes[:, list(points)]), points=points), band=(60, 700), object="other")
            for points in [(0, 1, 2), (0, 2)]}  # fmt: skip
    assert np.allclose(percuss.mac(part[0, 1, 2], part[0, 2]), percuss.mac(shapes[:, [0, 2]]), atol=FIT)
    other = percuss.analyze(percuss.Frf(FREQ_HZ, responses_of(shapes[:, :1]), points=[7]), band=(60, 700), object="other")
    with pytest.raises(percuss.InputError, match="no point and channel in common"):
        percuss.mac(part[0, 2], other)


def test_mac_matches_points_by_their_coordinates():
    shapes = np.array([[1.0, 2.0, -1.0, 0.5, 3.0], [0.5, -1.0, 1.0, 2.0, 0.3]])
    places = np.array([[0.1 * p, 0.05 * p**2, 0.0] for p in range(5)])

    def survey(order):
        order = list(order)
        return percuss.survey(percuss.Frf(FREQ_HZ, responses_of(shapes[:, order])), band=(60, 700), object="other", geometry=places[order])

    whole, part = survey(range(5)), survey([4, 0, 3, 2])
    assert np.allclose(percuss.mac(whole, part), percuss.mac(shapes[:, [4, 0, 3, 2]]), atol=FIT)
    compared = percuss.compare(whole, part)
    assert compared["places"] == {"matched_by": "coordinates", "common": 4, "points_a": 5, "points_b": 4, "coordinates_differ": False}
    assert all(pair["mac"] > 1 - FIT for pair in compared["pairs"])


def test_mac_compares_documents(tmp_path):
    a, b = (percuss.analyze(percuss.synth("wood-bat", seed=seed), band=BAND) for seed in (1, 2))
    path = tmp_path / "b.json"
    b.save(path)
    wanted = percuss.mac(a, b)
    for pair in ((a.to_dict(), b), (a, path), (a.to_dict(), str(path))):
        assert np.allclose(percuss.mac(*pair), wanted, atol=ROUNDING)
    assert np.allclose(percuss.mac(path), percuss.mac(b), atol=ROUNDING)
    # The shape of a survey is over its points, to which all sensors contribute.
    barrel = percuss.survey(percuss.synth("roving-barrel"), band=BAND, effort="quick")
    assert np.allclose(percuss.mac(barrel.to_dict()), barrel.mac, atol=ROUNDING)
    shapes = np.array([[1.0, 2.0, -1.0], [0.5, -1.0, 1.0]])
    sensors = np.array([[1.0, 0.5], [-0.7, 1.0]])  # (modes, channels)
    frfs = np.concatenate([responses_of(shapes * sensors[:, [c]]) for c in (0, 1)], axis=1)
    whole = percuss.survey(percuss.Frf(FREQ_HZ, frfs), band=(60, 700), object="other", roving="hammer")
    document = whole.to_dict()
    assert np.allclose(percuss.mac(document, shapes), percuss.mac(shapes), atol=FIT)
    assert np.allclose(percuss.mac(document, whole), percuss.mac(whole), atol=FIT)
    # A document without the middle point is matched at the other two.
    for mode in document["modes"]:
        mode["residues"] = [one for one in mode["residues"] if one["point"] != 1]
    assert np.allclose(percuss.mac(document, whole), percuss.mac(shapes[:, [0, 2]]), atol=FIT)


def test_mac_refuses_other_documents(tmp_path):
    beam = percuss.models.beam(support="free", length=0.84, modes=4).to_dict()
    not_json, scalar = tmp_path / "notes.json", tmp_path / "three.json"
    not_json.write_text("# notes")
    scalar.write_text("3")
    modes = {"schema": "percuss/analysis/1", "modes": [{"frequency_hz": 100.0, "residues": [{"point": 0, "channel": 0, "re": None}]}]}
    for value, wanted in [
        (beam, "a percuss/model-beam/1 has no mode shapes (a); give a document that percuss.analyze() or percuss.survey() wrote"),
        ({}, "a dictionary without a schema has no mode shapes (a)"),
        ({"schema": "percuss/analysis/1", "modes": []}, "the document has no modes (a); choose a band"),
        ({"schema": "percuss/analysis/1", "runs": [{}, {}]}, "the document holds 2 tests (a); give one of them"),
        (modes, "the modes have no residues at points and channels (a)"),
        (not_json, f"not a JSON document ({not_json})"),
        (scalar, f"not a document of percuss ({scalar})"),
        (tmp_path / "none.json", "check the path"),
    ]:
        with pytest.raises(percuss.InputError) as caught:
            percuss.mac(value)
        assert wanted in str(caught.value)


def responses_of(shapes):
    """(points, 1, lines) of shapes (modes, points), struck at each point and measured at one sensor."""
    return modal_sum(shapes, 2j * np.pi * FREQ_HZ)[:, None]


def test_frfs_of_a_result_keep_the_channels(bat):
    found = percuss.analyze(percuss.Record(bat.record.force_n, bat.record.accel_mps2, bat.record.fs_hz, names=["hammer", "tip", "grip"]),
                            band=BAND, angle=(0, 45), position=(0.1, 0.2))  # fmt: skip
    frf = found.frf()
    assert frf.names == ["tip", "grip"]
    for one in (frf, pickle.loads(pickle.dumps(found)).frf(), pickle.loads(pickle.dumps(frf)), found.frf("mobility")):
        assert [signal["name"] for signal in one.signals] == ["tip", "grip"]
        assert np.allclose([signal["angle_rad"] for signal in one.signals], np.radians([0, 45]))
        assert np.allclose([signal["position_m"] for signal in one.signals], [0.1, 0.2])
    again = percuss.analyze(frf, band=BAND)
    assert again.family == found.family  # which the angles decide


def test_frfs_under_an_exponential_window_have_the_damping_without_it():
    """H of a window exp(−a t) over force and response is H(jω + a)."""
    fraction, spacing_hz = 0.01, 1.0
    decay_per_s = -np.log(fraction) * spacing_hz
    seen = modal_sum(RESIDUES, 2j * np.pi * FREQ_HZ + decay_per_s)
    found = percuss.analyze(percuss.Frf(FREQ_HZ, seen, exponential=fraction), band=(60, 700), object="other")
    assert np.allclose(found.damping_ratio, DAMPING, rtol=FIT)
    unstated = percuss.analyze(percuss.Frf(FREQ_HZ, seen), band=(60, 700), object="other")
    # The numerators then differ from the model's; the residual terms describe the difference to about 1e-9.
    assert np.allclose(unstated.poles, POLES - decay_per_s, rtol=1e-7)
    later = percuss.analyze(percuss.Frf(FREQ_HZ, seen), band=(60, 700), object="other", exponential=fraction)
    assert np.allclose(later.damping_ratio, DAMPING, rtol=FIT)
    with pytest.raises(percuss.InputError, match="contradicts the FRFs, which state 4.6052 1/s"):
        percuss.analyze(percuss.Frf(FREQ_HZ, seen, exponential=fraction), band=(60, 700), exponential=0.1)
    for wrong in (0, 1, -0.1, "x", np.nan):
        with pytest.raises(percuss.InputError, match="is no fraction \\(exponential\\)"):
            percuss.Frf(FREQ_HZ, seen, exponential=wrong)


def test_averages_are_stated_when_the_frfs_are_made_or_later():
    coherence = np.full((1, 2, 800), 0.99)
    known = percuss.Frf(FREQ_HZ, exact(FREQ_HZ)[:1], coherence=coherence, averages=6)
    unknown = percuss.Frf(FREQ_HZ, exact(FREQ_HZ)[:1], coherence=coherence)
    options = {"band": (60, 700), "object": "other"}
    own, later, without = percuss.analyze(known, **options), percuss.analyze(unknown, averages=6, **options), percuss.analyze(unknown, **options)
    assert np.array_equal(later.residues_std, own.residues_std)
    assert (later.residues_std > 10 * without.residues_std).all()
    with pytest.raises(percuss.InputError, match="of 5 contradicts the file, which states 6"):
        percuss.analyze(known, averages=5, **options)


def test_deviations_that_the_lines_do_not_show_widen_the_residues_alone():
    noise = np.random.default_rng(1).normal(size=(2, 1, 2, 800)) * 1e-4
    seen = exact(FREQ_HZ)[:1] + noise[0] + 1j * noise[1]  # standard deviation of a complex value: 1.4e-4

    def modes(std):
        frf = percuss.Frf(FREQ_HZ, seen, std=None if std is None else np.full(seen.shape, std))
        return percuss.analyze(frf, band=(60, 700), object="other")

    own, less, more, most = [modes(std) for std in (None, 1e-6, 1e-3, 1e-2)]
    for name in ("frequency_std_hz", "damping_ratio_std", "residues_std"):
        assert np.array_equal(getattr(less, name), getattr(own, name))  # the residual shows more noise than stated
    # Noise of the lines would show in the residual. The lines share the rest, which moves no pole.
    residual_std = 0.1  # the residual near a mode is known to 10 % in amplitude
    for name in ("frequency_std_hz", "damping_ratio_std"):
        assert np.array_equal(getattr(most, name), getattr(more, name))
        assert np.allclose(getattr(more, name), getattr(own, name), rtol=2 * residual_std)
    assert np.allclose(most.residues_std, 10 * more.residues_std, rtol=0.02)  # noise is 2 % of the variance in `more`
    assert np.all(more.residues_std > 5 * own.residues_std)
    assert np.array_equal(most.frequency_hz, own.frequency_hz)
