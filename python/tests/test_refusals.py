"""Errors for arrays that do not form a test, with what to give instead."""

import numpy as np
import pytest

import percuss

FS = 25600.0


@pytest.fixture(scope="module")
def signals(bat):
    return bat.record.force_n, bat.record.accel_mps2


def message_of(kind, call):
    with pytest.raises(kind) as error:
        call()
    assert "\n" not in str(error.value)
    return str(error.value)


@pytest.mark.parametrize(
    "keywords, wanted",
    [
        ({"points": [0.5, 1, 1, 1, 1]}, "whole numbers"),
        ({"points": ["0"] * 5}, "whole numbers"),
        ({"points": [True] * 5}, "whole numbers"),
        ({"points": [0, np.nan, 1, 1, 1]}, "whole numbers"),
        ({"points": [0, 1e30, 1, 1, 1]}, "from 0 up"),
        ({"names": "force"}, "give a list of texts"),
        ({"names": ["force", "a"]}, "2 names for 3 signals.*one for the force"),
        ({"names": ["force", 1, 2]}, "give a list of texts"),
        ({"geometry": [1, 2, 3]}, "array of 3 .*points, 3"),
        ({"geometry": [[1, 2, 3], [1, 2]]}, "rows of different lengths"),
        ({"geometry": np.eye(4)}, "4 × 4"),
        ({"geometry": np.zeros((9, 3))}, "9 places for 1 point struck.*points="),
        ({"geometry": np.zeros((2, 3)), "points": [0, 1, 2, 0, 0]}, "2 places for 3 points"),
        ({"geometry": np.zeros((4, 3)), "points": [0, 1, 2, 0, 0]}, "4 places for 3 points"),
        ({"geometry": np.full((1, 3), np.nan)}, "row 0 is not finite"),
    ],
    ids=str,
)
def test_points_names_and_geometry_must_fit_the_record(signals, keywords, wanted):
    with pytest.raises(percuss.InputError, match=wanted):
        percuss.Record(*signals, FS, **keywords)


def test_geometry_may_belong_to_the_accelerometers(signals):
    assert percuss.Record(*signals, FS, geometry=np.eye(3)[:2]).geometry.shape == (2, 3)


def test_surveys_of_plain_arrays_ask_for_points(signals):
    message = message_of(percuss.InputError, lambda: percuss.survey(*signals, fs=FS, geometry=np.zeros((9, 3))))
    assert "percuss.Record(force, accel, fs, points=" in message


def test_samples_before_channels_are_refused(signals):
    message = message_of(percuss.InputError, lambda: percuss.analyze(np.ones((3, 4000)), np.ones((3, 4000, 2)), fs=FS))
    assert "np.swapaxes(accel, -2, -1)" in message


def test_points_from_one_are_named():
    signals = np.ones((3, 4000)), np.ones((3, 4000))
    message = message_of(percuss.InputError, lambda: percuss.Record(*signals, FS, points=[1, 2, 3], geometry=np.zeros((3, 3))))
    assert message.startswith("3 places for points 1 to 3, but point 0 has the first row") and "points - 1" in message


@pytest.mark.parametrize("name", ["std", "coherence"])
def test_deviations_and_coherences_are_real(name):
    line = np.arange(1, 401.0)
    assert "complex numbers" in message_of(percuss.InputError, lambda: percuss.Frf(line, 1j * line, **{name: 1j * line}))


def test_geometry_is_finite_and_compare_takes_no_frfs():
    line = np.arange(1, 401.0)
    frf = percuss.Frf(line, np.ones((3, 1, 400), dtype=complex), points=[3, 1, 2])
    places = np.eye(3)
    places[1, 2] = np.nan
    message = message_of(percuss.InputError, lambda: percuss.survey(frf, band=(60, 300), geometry=places))
    assert message.startswith("a number that is not finite: nan (geometry[1, 2])")
    assert "percuss.analyze()" in message_of(TypeError, lambda: percuss.compare(frf, frf))


def test_arrays_are_compared_by_mac():
    beam = percuss.models.beam(support="free", length=0.84, modes=4)
    for arrays in ((beam, np.eye(2)), ([[1.0, 2.0]], beam)):
        message = message_of(TypeError, lambda: percuss.compare(*arrays))
        assert message == "compare() takes results, their documents or files; percuss.mac() compares arrays of shapes"
    assert percuss.compare(beam, beam.to_dict())["pairs"]


def test_records_keep_their_sampling_rate(signals):
    record = percuss.Record(*signals, FS)
    assert "percuss.read() or percuss.Record()" in message_of(TypeError, lambda: percuss.analyze(record, fs=1.0))
    assert "did you mean 'fs_hz'?" in message_of(AttributeError, lambda: record.fs)
    assert "did you mean 'channels'?" in message_of(AttributeError, lambda: record.chanels)


@pytest.mark.parametrize("fs", [np.array(FS), np.array([[FS]]), np.float32(FS), np.array([25600])])
def test_sampling_rates_may_be_arrays_of_one_number(signals, fs):
    assert percuss.Record(*signals, fs).fs_hz == FS
    assert percuss.frf(*signals, fs=fs, band=(60, 3200)).json == percuss.frf(*signals, fs=FS, band=(60, 3200)).json
    for wrong in (np.array([FS, FS]), "25600", True, None, np.array([True])):
        with pytest.raises(TypeError):
            percuss.Record(*signals, wrong)


def test_seeds_beyond_64_bits_are_rejected(tool):
    message = message_of(percuss.UsageError, lambda: percuss.synth("wood-bat", seed=2**70))
    assert "seed=" in message and message == tool.error("synth", "wood-bat", f"--seed={2**70}")
    assert percuss.synth("wood-bat", seed=2**64 - 1).record.rows == 5


def test_messages_say_what_to_give(signals):
    force, accel = signals
    for call, wanted in [
        (lambda: percuss.analyze(force.T, accel.T, fs=FS), "is it (hits, samples)?"),
        (lambda: percuss.Record(force[0], accel[0].T, FS), "is it (channels, samples)?"),
        (lambda: percuss.Record(np.zeros((5, 0)), np.zeros((5, 1, 0)), FS), "no samples"),
        (lambda: percuss.analyze(), "give paths, arrays or Records"),
    ]:
        assert wanted in message_of(percuss.InputError, call)
    generator = (one for one in force)
    assert "give an array or a list" in message_of(TypeError, lambda: percuss.analyze(generator, accel, fs=FS))


def test_mac_accepts_any_scale_and_rejects_other_arrays():
    mac = percuss.metrics.mac
    assert mac([[1e-200, 2e-200]], [[3e200, 6e200]]).tolist() == [[1.0]]
    assert mac([[5e-324, 0]], [[1e308 * (1 + 1j), 0]])[0, 0] == pytest.approx(1, abs=1e-15)
    assert mac([[0, 0]], [[1, 2]]).tolist() == [[0.0]]
    for bad, wanted in [([[1, 2], [3, np.nan]], "a, mode 1, place 1"), ([[np.inf, 1]], "mode 0, place 0"), ([], "shapes of 1 × 0"),
                        (np.zeros((0, 3)), "shapes of 0 × 3"), ([[1, 2], [3]], "different lengths")]:  # fmt: skip
        assert wanted in message_of(percuss.InputError, lambda: mac(bad))
    for bad in (["a", "b"], [None, 1], [[object()]]):
        assert "holds no numbers" in message_of(TypeError, lambda: mac(bad))
