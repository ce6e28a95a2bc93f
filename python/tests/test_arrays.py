"""Arrays are used and returned without copies, with any strides; hostile arrays are rejected."""

import gc
import weakref

import numpy as np
import pytest

import percuss

FS = 25600.0
BAND = (60, 3200)


@pytest.fixture(scope="module")
def signals(bat):
    return bat.record.force_n, bat.record.accel_mps2


def document(force, accel, **options):
    return percuss.analyze(force, accel, fs=FS, band=BAND, effort="quick", **options).to_dict()


def test_dimensions_set_rows_and_channels(signals):
    force, accel = signals
    assert percuss.Record(force[0], accel[0, 0], FS).samples.tolist() == [25600]
    for f, a, rows, channels in [
        (force[0], accel[0, 0], 1, 1),
        (force[0], accel[0], 1, 2),
        (force, accel[:, 0], 5, 1),
        (force, accel, 5, 2),
        (list(force), list(accel), 5, 2),
        ([force[0], force[1][:9000]], [accel[0], accel[1][:, :9000]], 2, 2),
        (None, accel, 5, 2),
        (force[0].tolist(), accel[0].tolist(), 1, 2),
    ]:
        record = percuss.Record(f, a, FS)
        assert (record.rows, record.channels) == (rows, channels)
    assert percuss.Record(force, accel, FS, points=[0, 0, 1, 1, 2]).points.tolist() == [0, 0, 1, 1, 2]
    with pytest.raises(percuss.InputError, match="different lengths"):
        percuss.Record([force[0], force[1][:900]], [accel[0], accel[1][:, :900]], FS).force_n


def test_strides_and_types_change_nothing(signals):
    force, accel = signals
    wanted = document(force, accel)
    padded = np.full((5, 2, 2 * 25600 + 6), np.nan)
    padded[:, :, 3:-3:2] = accel
    records = np.zeros((5, 25600), dtype=np.dtype([("gap", "u1"), ("force", "f8")]))  # not aligned
    records["force"] = force
    for f, a in [
        (np.asfortranarray(force), np.asfortranarray(accel)),
        (force[:, ::-1][:, ::-1], accel[::-1][::-1]),
        (records["force"], padded[:, :, 3:-3:2]),
        (list(force), np.moveaxis(np.ascontiguousarray(np.moveaxis(accel, 1, 2)), 2, 1)),
    ]:
        assert document(f, a) == wanted
    counts = (accel * 1e3).round().astype(np.int32)
    assert document(force, counts, accel_scale=1e-3) == document(force, counts.astype(float), accel_scale=1e-3)
    for array in (force, accel):
        array.flags.writeable = False
    assert document(force, accel) == wanted


def test_input_is_viewed_in_place(signals):
    force, accel = np.array(signals[0]), np.array(signals[1])
    record = percuss.Record(force, accel, FS)
    assert np.shares_memory(record.force(2), force) and np.shares_memory(record.accel(2, 1), accel)
    assert not record.force(2).flags.writeable
    assert record.accel(-1, -1).tolist() == accel[-1, -1].tolist()
    seen = weakref.ref(force)
    shown = record.force(1)
    del force, record
    gc.collect()
    assert seen() is not None and shown.sum() == signals[0][1].sum()
    del shown
    gc.collect()
    assert seen() is None


def test_results_are_views_that_outlive_the_result(signals):
    found = percuss.analyze(*signals, fs=FS, band=BAND)
    one = found.frf().at(0, 1)
    assert one.dtype == complex and not one.flags.owndata and not one.flags.writeable
    assert np.shares_memory(one, found.frf().at(0, 1))
    stacked = found.frf().H
    assert stacked.shape == (1, 2, len(found.frf().frequency_hz)) and stacked is found.frf().H
    kept = one.copy()
    del found, stacked
    gc.collect()
    np.zeros(1 << 20).fill(7)
    assert np.array_equal(one, kept)


def test_a_result_is_computed_on_demand(signals):
    found = percuss.analyze(*signals, fs=FS, band=BAND, only="hits", trace=True)
    assert "modes" not in found.to_dict()
    assert {one["stage"] for one in found.to_dict()["trace"]}.isdisjoint({"modes", "frf"})
    assert len(found.frequency_hz) == 3  # computed by this read


BAD = {
    "not a number": lambda f, a: (f, np.where(np.arange(a.shape[-1]) == 5000, np.nan, a)),
    "infinite": lambda f, a: (np.where(np.arange(f.shape[-1]) == 170, np.inf, f), a),
    "too large": lambda f, a: (f * 1e40, a),
    "empty": lambda f, a: (np.zeros(0), np.zeros(0)),
    "no hits": lambda f, a: (np.zeros((0, 5)), np.zeros((0, 1, 5))),
    "no channels": lambda f, a: (f[0], np.zeros((0, f.shape[1]))),
    "one sample": lambda f, a: (f[:, :1], a[:, :, :1]),
    "lengths": lambda f, a: (f, a[:, :, :-1]),
    "hits": lambda f, a: (f, a[:3]),
    "text": lambda f, a: (np.array(["a", "b"]), np.array(["a", "b"])),
    "objects": lambda f, a: (f.astype(object), a),
    "complex": lambda f, a: (f.astype(complex), a),
    "half precision": lambda f, a: (f.astype(np.float16), a),
    "booleans": lambda f, a: (f > 0, a),
    "long doubles": lambda f, a: (f.astype(np.longdouble), a),
    "dates": lambda f, a: (f.astype("datetime64[s]"), a),
    "scalars": lambda f, a: (np.float64(1), np.float64(1)),
    "four dimensions": lambda f, a: (f, a[None]),
    "force of three": lambda f, a: (a, a),
    "masked": lambda f, a: (np.ma.masked_less(f, 0), a),
    "one number for all": lambda f, a: (np.broadcast_to(np.float64(1), (10**12,)), np.broadcast_to(np.float64(1), (10**12,))),
    "one hit for all": lambda f, a: (np.broadcast_to(f[0], (10**5, f.shape[1])), np.broadcast_to(a[0], (10**5, *a[0].shape))),
    "a billion hits": lambda f, a: (np.broadcast_to(f[0], (10**9, f.shape[1])), np.broadcast_to(a[0], (10**9, *a[0].shape))),
    "a billion channels": lambda f, a: (f[0], np.broadcast_to(a[0, 0], (10**9, a.shape[2]))),
    "ragged": lambda f, a: ([f[0], [1.0, [2.0]]], a[:2]),
    "channels differ": lambda f, a: ([f[0], f[1]], [a[0], a[1, :1]]),
}


@pytest.mark.parametrize("number", [">f8", ">f4", ">i4"])
def test_big_endian_numbers_are_read(signals, number):
    force, accel = (np.round(one * 1e3).astype(number) for one in signals)
    native = percuss.analyze(force.astype(number[1:]), accel.astype(number[1:]), fs=FS, band=BAND)
    found = percuss.analyze(force, accel, fs=FS, band=BAND)
    assert found.frequency_hz.tolist() == native.frequency_hz.tolist()


@pytest.mark.parametrize("name", BAD)
def test_hostile_arrays_are_rejected(signals, name):
    force, accel = BAD[name](*signals)
    with pytest.raises(percuss.InputError) as refused:
        percuss.analyze(force, accel, fs=FS, band=BAND)
    assert str(refused.value) and "\n" not in str(refused.value)


@pytest.mark.parametrize("fs", [0, -1.0, float("nan"), float("inf"), 1e300, 1e-300])
def test_invalid_sampling_rates_are_rejected(signals, fs):
    with pytest.raises(percuss.InputError):
        percuss.analyze(*signals, fs=fs)
    with pytest.raises(percuss.InputError, match=r"sampling rate.*; .*\(fs=\)"):
        percuss.Record(*signals, fs)


def test_missing_rows_and_points_are_rejected(signals):
    record = percuss.Record(*signals, FS)
    for call in (lambda: record.force(5), lambda: record.force(-6), lambda: record.accel(0, 2)):
        with pytest.raises(IndexError):
            call()
    with pytest.raises(KeyError):
        percuss.analyze(record, band=BAND, effort="quick").frf().at(9, 0)
    for points in ([0], [-1] * 5, [0] * 6):
        with pytest.raises(percuss.InputError):
            percuss.Record(*signals, FS, points=points)
    with pytest.raises(percuss.InputError):
        percuss.metrics.mac(np.ones((2, 3)), np.ones((2, 4)))


def test_records_go_through_formats_of_arrays(tmp_path, signals):
    record = percuss.Record(*signals, FS)
    for kind in ("h5", "csv", "mat", "uff"):
        path = tmp_path / f"bat.{kind}"
        notes = percuss.write(path, record)
        again = percuss.read(path)
        assert isinstance(notes, list) and np.allclose(again.accel_mps2, signals[1], rtol=1e-12, atol=0)
    frfs = percuss.frf(record, band=BAND)
    frfs.save(tmp_path / "frfs.h5")
    measured = percuss.read(tmp_path / "frfs.h5")
    assert np.array_equal(measured.H, frfs.H) and np.array_equal(measured.coherence, frfs.coherence)
    percuss.write(tmp_path / "frfs.uff", measured)
    assert percuss.read([tmp_path / "frfs.uff"]).H.shape == frfs.H.shape


def test_geometry_may_be_an_array():
    test = percuss.synth("roving-barrel")
    places = test.record.geometry
    assert places is not None and places.shape[1] in (2, 3)
    count = len(places)
    ring = np.c_[np.zeros(count), np.cos(np.arange(count)), np.sin(np.arange(count))]
    plain = percuss.survey(test.record, band=BAND, effort="quick", geometry=ring)
    assert plain.shapes.shape == (len(plain.frequency_hz), len(plain.shape_points))
    assert np.allclose(np.diag(plain.mac), 1) and plain.cmif.shape[0] == len(plain.cmif_frequency_hz)
    assert np.allclose(percuss.metrics.mac(plain.shapes), plain.mac, atol=1e-12)


PROFILE = {"position": np.array([0.1, 0.5, 0.84]), "diameter": np.array([0.024, 0.04, 0.066]), "wall": np.array([0.012, 0.004, 0.003])}


def test_profiles_are_tables_with_named_columns(tmp_path):
    """Of a bat: a dictionary of columns, a structured array or a data frame give what a file of the same numbers gives."""
    rows = np.array(list(zip(*PROFILE.values())), dtype=[(name, float) for name in PROFILE])
    (tmp_path / "profile.csv").write_text(",".join(PROFILE) + "\n" + "".join(f"{a!r},{b!r},{c!r}\n" for a, b, c in rows.tolist()))
    wanted = percuss.models.bat(profile=tmp_path / "profile.csv", young=7e10, density=2700)
    given = [PROFILE, {key: one.tolist() for key, one in PROFILE.items()}, rows]
    try:
        import pandas
    except ImportError:
        pass
    else:
        given.append(pandas.DataFrame(PROFILE))
    for one in given:
        assert np.array_equal(percuss.models.bat(profile=one, young=7e10, density=2700).frequency_hz, wanted.frequency_hz)
    solid = np.column_stack([PROFILE["position"], PROFILE["diameter"]])  # two columns need no names
    assert len(percuss.models.bat(profile=solid).frequency_hz)
    beam = percuss.models.beam(profile={"x": [0, 0.84], "width": [0.04, 0.04], "thickness": [0.01, 0.01]}, support="free", young=1e10, density=700)
    assert beam.frequency_hz[2] > 0
    with pytest.raises(percuss.InputError, match="different lengths: position 3, diameter 2 \\(profile\\)"):
        percuss.models.bat(profile={"position": [0.1, 0.5, 0.84], "diameter": [0.024, 0.04]})


def test_documents_hold_numbers_of_numpy():
    spec = {
        "schema": "percuss/synth/1", "name": "numpy", "fs_hz": np.float64(8192), "samples": np.int64(8192), "seed": np.uint8(3), "hits": np.int32(3),
        "modes": [{"frequency_hz": f, "damping_ratio": np.float32(0.01), "family": "bending", "order": i + 1, "residue_per_kg": np.array([0.5])}
                  for i, f in enumerate(np.array([100.0, 400.0]))],
        "structure": {"rigid_line_per_kg": np.zeros((1, 1))}, "sensors": [{"position_m": 0.05, "angle_deg": np.int64(0)}],
        "impact": {"position_m": 0.05, "angle_deg": 0}, "pulse": {"kind": "haversine", "width_s": 0.001, "peak_n": 300},
        "noise": {"force": 1e-4, "accel": 1e-3},
    }  # fmt: skip
    assert percuss.synth(spec).f_hz.tolist() == [100, 400]
    with pytest.raises(TypeError, match="cannot hold complex"):
        percuss.synth({**spec, "fs_hz": 1j})
