"""Results hold the numbers of the document as read-only arrays, are mappings, and can be pickled."""

import copy
import pickle
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest

import percuss

BAND = (60, 3200)
FS = 25600.0


@pytest.fixture(scope="module")
def found(bat):
    return percuss.analyze(bat.record, band=BAND, stabilisation=True)


@pytest.fixture(scope="module")
def barrel():
    return percuss.survey(percuss.synth("roving-barrel").record, band=BAND, effort="quick")


def residues_of(document, part):
    return np.array([[part(one) for one in mode["residues"]] for mode in document["modes"]])


@pytest.mark.parametrize("which", ["found", "barrel"])
def test_arrays_equal_the_document(which, request):
    result = request.getfixturevalue(which)
    document = result.to_dict()
    for name in ("frequency_hz", "frequency_std_hz", "damping_ratio", "damping_ratio_std", "confidence"):
        assert getattr(result, name).tolist() == [mode[name] for mode in document["modes"]], name
    assert result.family == [mode["family"] for mode in document["modes"]]
    assert result.order.tolist() == [mode["order"] or 0 for mode in document["modes"]]
    count = len(document["modes"])
    assert np.array_equal(result.residues.reshape(count, -1), residues_of(document, lambda one: complex(one["re"], one["im"])))
    assert np.array_equal(result.residues_std.reshape(count, -1), residues_of(document, lambda one: one["std"]))
    table = result.table
    assert table["frequency_hz"] is result.frequency_hz and table["family"].tolist() == result.family
    assert {len(column) for column in table.values()} == {count}


def test_shapes_equal_the_document(barrel):
    shapes = [mode["shape"]["values"] for mode in barrel.to_dict()["modes"]]
    assert np.array_equal(barrel.shapes, [[complex(one["re"], one["im"]) for one in places] for places in shapes])
    assert np.array_equal(barrel.shapes_std, [[one["std"] for one in places] for places in shapes])
    assert barrel.mac.tolist() == barrel.to_dict()["auto_mac"]["value"]


def arrays_of(value):
    if isinstance(value, np.ndarray):
        yield value
    elif isinstance(value, dict):
        yield from arrays_of(list(value.values()))
    elif isinstance(value, (list, tuple)):
        for one in value:
            yield from arrays_of(one)


def everything(result):
    names = [name for name in dir(type(result)) if not name.startswith("_")]
    values = [getattr(result, name) for name in names if name != "runs"]
    return [value for value in values if not callable(value)] + [result[key] for key in result]


@pytest.mark.parametrize("which", ["found", "barrel"])
def test_arrays_of_results_are_read_only(which, request):
    result = request.getfixturevalue(which)
    arrays = list(arrays_of([everything(result), result.stabilisation(), result.frf().at()]))
    assert len(arrays) > 15 and not any(array.flags.writeable for array in arrays)
    others = [percuss.frf(percuss.synth("wood-bat").record, band=BAND), percuss.models.beam(support="free")]
    assert not any(array.flags.writeable for one in others for array in arrays_of(everything(one)))
    with pytest.raises(ValueError, match="read-only"):
        result.frequency_hz[0] = 1


def test_results_are_mappings(found):
    document = found.to_dict()
    assert isinstance(found, Mapping) and "modes" in found and "nope" not in found
    assert list(found) == list(found.keys()) == list(document) and len(found) == len(document)
    assert found.get("nope", 3) == 3 and found.get("modes") == found["modes"] == document["modes"]
    assert dict(found.items()).keys() == document.keys() and len(list(found.values())) == len(document)
    assert found == found and found != percuss.models.beam(support="free") and hash(found) == hash(found)
    with pytest.raises(KeyError):
        found["nope"]


@pytest.mark.parametrize("which", ["found", "barrel"])
def test_results_are_pickled(which, request):
    result = request.getfixturevalue(which)
    again = pickle.loads(pickle.dumps(result))
    assert type(again) is type(result) and again.json == result.json and str(again) == str(result)
    assert again._repr_html_() == result._repr_html_() and again.exit_code == result.exit_code
    for name in dir(type(result)):
        mine = getattr(result, name)
        if isinstance(mine, np.ndarray):
            assert np.array_equal(getattr(again, name), mine) and not getattr(again, name).flags.writeable, name
    assert np.array_equal(again.frf().at(), result.frf().at())
    assert np.array_equal(again.stabilisation()["frequency_hz"], result.stabilisation()["frequency_hz"])
    with pytest.raises(percuss.UsageError, match="was pickled.*save\\(\\) before"):
        again.save("x.h5")
    assert len(pickle.loads(pickle.dumps(again)).frequency_hz) == len(result.frequency_hz)


def test_other_results_are_pickled(bat):
    for one in (percuss.models.beam(support="free"), percuss.frf(bat.record, band=BAND, kind="mobility"), percuss.compare(*[percuss.models.beam(support="free")] * 2)):
        again = pickle.loads(pickle.dumps(one))
        assert again.json == one.json and type(again) is type(one)
        assert all(a.tobytes() == b.tobytes() for a, b in zip(arrays_of(everything(one)), arrays_of(everything(again))))
    seen = percuss.deflect(bat.record)
    curves = pickle.loads(pickle.dumps(seen)).curves()
    assert np.array_equal(curves[0]["deflection_m"], seen.curves()[0]["deflection_m"])
    without_hits = percuss.analyze(percuss.Record(np.zeros((2, 512)), np.random.default_rng(0).normal(size=(2, 1, 512)), fs=4096.0))
    again = pickle.loads(pickle.dumps(without_hits))
    assert not again.possible and again.hits == without_hits.hits


def test_copies_of_results_are_results(found, tmp_path):
    for again in (copy.copy(found), copy.deepcopy(found)):
        assert again is not found and again.json == found.json
        again.save(tmp_path / f"{id(again)}.h5")
    kept = copy.deepcopy({"a": found})["a"]
    kept.modes.clear()
    assert len(found.modes) == 3


def test_repr_is_short(found):
    lines = repr(found).split("\n")
    assert len(lines) == 2 + len(found.modes) < len(str(found).split("\n")) and lines[0] == str(found).split("\n")[0]
    assert lines[1] == f"{len(found.modes)} modes, {len(found.warnings)} warning{'s' * (len(found.warnings) != 1)}: print() shows all"
    for line, freq_hz in zip(lines[2:], found.frequency_hz):
        assert line.count("±") == 2 and abs(float(line.split()[0]) - freq_hz) < 0.01
    assert not any(warning["message"] in repr(found) for warning in found.warnings)


def test_records_and_synthetic_tests_are_pickled(bat, tmp_path, monkeypatch):
    record = percuss.Record(bat.record.force_n, bat.record.accel_mps2, FS, points=[0, 1, 1, 0, 2], geometry=np.eye(3), names=["f", "a", "b"])
    for again in (pickle.loads(pickle.dumps(record)), copy.deepcopy(record), copy.copy(record)):
        assert np.array_equal(again.accel_mps2, record.accel_mps2) and np.array_equal(again.geometry, np.eye(3))
        assert again.points.tolist() == [0, 1, 1, 0, 2] and again.signals == record.signals
    bat.save(tmp_path / "bat.h5")
    monkeypatch.chdir(tmp_path)
    read = percuss.read("bat.h5")
    percuss.write("b.csv", bat)
    _, second = percuss.read("bat.h5", "b.csv")
    kept = pickle.dumps([bat, bat.record, read, second])
    assert len(kept) < 10_000  # the spec, and the paths
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    for one, again in zip((bat, bat.record, read, second), pickle.loads(kept)):
        assert repr(again).replace(str(tmp_path) + "/", "") == repr(one) and type(again) is type(one)
        mine, other = getattr(one, "record", one), getattr(again, "record", again)
        assert np.array_equal(mine.accel_mps2, other.accel_mps2)
    for one in (bat.record, read, bat):
        assert repr(copy.copy(one)) == repr(one)


def in_a_process(seed):
    found = percuss.analyze(percuss.synth("wood-bat", seed=seed).record, band=BAND, threads=1)
    return found.to_dict(), found.frequency_hz, found


def test_results_come_back_from_other_processes():
    with ProcessPoolExecutor(2) as pool:
        for seed, (document, freq_hz, whole) in enumerate(pool.map(in_a_process, range(2))):
            here = percuss.analyze(percuss.synth("wood-bat", seed=seed).record, band=BAND)
            assert document == here.to_dict() == whole.to_dict() and freq_hz.tolist() == here.frequency_hz.tolist()
            assert np.array_equal(whole.frf().H, here.frf().H)


def test_functions_take_a_synthetic_test_as_its_record(bat):
    band = (60, 3200)
    assert percuss.analyze(bat, band=band).json == percuss.analyze(bat.record, band=band).json
    assert percuss.frf([bat], band=band).json == percuss.frf(bat.record, band=band).json


def test_the_text_of_a_result_shows_its_warnings():
    bat = percuss.synth("wood-bat", seed=3).record
    accel = np.array(bat.accel_mps2)
    accel[:, 1] = 0
    found = percuss.analyze(np.array(bat.force_n), accel, fs=bat.fs_hz, band=BAND, object="other")
    assert [one["code"] for one in found.warnings] == ["dead_channel"]
    assert "accel 2 is constant" in " ".join(str(found).split())


def test_mac_of_a_single_common_place_is_an_error(barrel):
    frf = barrel.frf()
    one = percuss.analyze(percuss.Frf(frf.frequency_hz, frf.H[:1, :1]), band=BAND, effort="quick", object="other")
    with pytest.raises(percuss.InputError, match="only one point and channel"):
        percuss.mac(barrel, one)


def test_comparisons_name_their_documents(bat, found, tmp_path):
    beside = percuss.analyze(bat.record, band=BAND, compare=found)
    assert str(beside).count("analysis") >= 1 and "/proc" not in str(beside) + beside._repr_html_()
    bat.save(tmp_path / "bat.h5")
    read = percuss.analyze(tmp_path / "bat.h5", band=BAND)
    whole = percuss.compare(found, found, percuss.models.beam(support="free"), read, read.to_dict(), furthest=40)
    path = str(tmp_path / "bat.h5")
    assert [one["path"] for one in whole.documents] == ["analysis", "analysis (2)", "model beam", path, f"{path} (2)"]
    impact = percuss.deflect(bat.record, band=BAND, compare=found)
    assert "/proc" not in str(impact) + impact._repr_html_()
    whole.save(tmp_path / "all.html")
    beside.save(tmp_path / "beside.html")
    for shown in (str(whole), whole._repr_html_(), whole.json):
        assert "/proc" not in shown
    with pytest.raises(percuss.InputError, match="nope.*file 2"):
        percuss.compare(found, {"schema": "nope"})
    for name in ("all.html", "beside.html"):
        assert "/proc/self" not in (tmp_path / name).read_text()


@pytest.mark.parametrize("change", [lambda f, a: f.fill(np.nan), lambda f, a: np.multiply(a, 2, out=a), lambda f, a: a.fill(7)])
def test_saving_changed_arrays_is_an_error(bat, tmp_path, change):
    force, accel = bat.record.force_n, bat.record.accel_mps2
    found = percuss.analyze(force, accel, fs=FS, band=BAND)
    found.report(tmp_path / "before.html")
    change(force, accel)
    for call in (lambda: found.report(tmp_path / "x.html"), lambda: found.save(tmp_path / "x.h5")):
        with pytest.raises(percuss.InputError, match="the arrays have changed since the analysis"):
            call()
    found.save(tmp_path / "x.json")
    assert (tmp_path / "x.json").read_text() == found.json and not (tmp_path / "x.html").exists()


def test_overwriting_errors_name_the_keyword(bat, tmp_path):
    bat.save(tmp_path / "bat.h5")
    for call in (lambda: bat.save(tmp_path / "bat.h5"), lambda: percuss.write(tmp_path / "bat.h5", bat)):
        with pytest.raises(percuss.InputError, match=r"file exists.*\(force=True\)"):
            call()


def test_tables_hold_the_rows_of_bats(tmp_path):
    (tmp_path / "bats.csv").write_text("id,length_in,material,hoop1_hz,bbcor\n=a,33,composite,2000,0.55\nb,33,composite,1000,0.5\n")
    model = percuss.models.trampoline(hoop=(1000, 500, 2500), bats=tmp_path / "bats.csv")
    assert [one["id"] for one in model.bats] == ["=a", "b"]
    assert model.table["bat"].tolist() == ["", "", "", "", "=a", "b"]
    assert model.table["hoop_hz"].tolist() == [1000, 1500, 2000, 2500, 2000, 1000]
    assert model.table["bbcor"][4:].tolist() == [0.55, 0.5] and np.isnan(model.table["bbcor"][:4]).all()
    assert model.table["difference"][4:].tolist() == [one["difference"] for one in model.bats]
    assert not model.table["bat"].flags.writeable
    assert pickle.loads(pickle.dumps(model)).table["bat"].tolist() == model.table["bat"].tolist()


def test_tables_with_words_are_read_from_their_text(tmp_path):
    readings = "id,length_in,moi_oz_in2,ball_g,z_in,v_in_mph,v_out_mph,material\n7,34,10450,145.4,6,136,31,ash\n8,34,10200,145.4,6,136,,\n"
    (tmp_path / "bats.csv").write_text(readings)
    bats = percuss.metrics.performance(tmp_path / "bats.csv")
    assert bats.table["id"].tolist() == ["7", "8"] and bats.table["material"].tolist() == ["ash", ""]
    assert bats.table["besr"][0] > 0 and np.isnan(bats.table["besr"][1])
    assert pickle.loads(pickle.dumps(bats)).table["id"].tolist() == ["7", "8"]
    assert not bats.table["besr"].flags.writeable


def test_nodes_have_a_row_each(tmp_path):
    found = percuss.nodes(percuss.synth("bat-scan"), band=(60, 1500))
    nodes = [(mode["index"] + 1, node["position_m"]) for mode in found.modes for node in mode["nodes"]]
    table = found.table
    with_node = ~np.isnan(table["node_m"])
    assert list(zip(table["mode"][with_node].tolist(), table["node_m"][with_node].tolist())) == nodes
    found.save(tmp_path / "nodes.csv")
    assert (tmp_path / "nodes.csv").read_text().startswith("mode,order,frequency_hz,")


def test_a_result_without_files_says_what_to_write(tmp_path):
    with pytest.raises(percuss.UsageError, match="write its json to a file"):
        percuss.info(tmp_path / "none.h5").save(tmp_path / "x.json")


def test_each_of_several_tests_is_a_result_of_its_own(tmp_path):
    """Each result equals the result of an analysis of its record alone."""
    records = [percuss.synth("wood-bat", seed=seed).record for seed in (1, 2)]
    both = percuss.analyze(*records, band=BAND, files="tests")
    assert [len(one.modes) for one in both.runs] == [3, 3]
    for one, record in zip(both.runs, records):
        alone = percuss.analyze(record, band=BAND)
        assert one.json == alone.json and str(one) == str(alone) and repr(one) == repr(alone)
        assert one["modes"] == alone["modes"] == one.modes and one.fs_hz == alone.fs_hz and list(one) == list(alone)
        assert one._repr_html_() == alone._repr_html_() and one.exit_code == 0 and one.possible
        for name in ("frequency_hz", "residues", "lower", "frac"):
            assert np.array_equal(getattr(one, name), getattr(alone, name)), name
        assert np.array_equal(one.frf().H, alone.frf().H)
        assert np.array_equal(one.synthesise([165.0]), alone.synthesise([165.0]))
        assert one.runs == [one]
        for kind in ("json", "csv", "modes.csv", "uff", "h5", "mat", "svg", "html"):
            one.save(tmp_path / f"one.{kind}", force=True)
            alone.save(tmp_path / f"alone.{kind}", force=True)
        for kind in ("json", "csv", "modes.csv", "h5", "mat", "svg"):
            assert (tmp_path / f"one.{kind}").read_bytes() == (tmp_path / f"alone.{kind}").read_bytes(), kind
        percuss.write(tmp_path / "written.h5", one, force=True)
        assert np.array_equal(percuss.read(tmp_path / "written.h5").H, alone.frf().H)
    with pytest.raises(percuss.UsageError, match="2 tests.*runs\\[0\\]"):
        both.modes
    again = pickle.loads(pickle.dumps(both))
    assert again.json == both.json and [one.json for one in again.runs] == [one.json for one in both.runs]
    assert np.array_equal(again.runs[1].frequency_hz, both.runs[1].frequency_hz)


def test_each_of_several_decays_is_a_result_of_its_own():
    tests = [percuss.synth("wood-bat", seed=seed).record for seed in (1, 2)]
    records = [percuss.Record(None, one.accel_mps2, one.fs_hz) for one in tests]
    both = percuss.analyze(*records, band=BAND, files="tests")
    assert len(both.runs) == 2
    for one, record in zip(both.runs, records):
        alone = percuss.analyze(record, band=BAND)
        assert one.json == alone.json and str(one) == str(alone)
        assert np.array_equal(one.frequency_hz, alone.frequency_hz) and one.possible and one.exit_code == 0
        assert len(pickle.loads(pickle.dumps(one)).frequency_hz) == len(one.frequency_hz)


def held_beam(seed):
    """Five hits on a held beam. The accelerometer's noise is 1 % of the RMS of its signal."""
    modes = [(30, 0.5), (180, 0.6), (500, 0.5)]
    return percuss.synth({
        "schema": "percuss/synth/1", "name": "held", "fs_hz": 8192, "duration_s": 2, "seed": seed, "hits": 5,
        "modes": [{"frequency_hz": f, "damping_ratio": 0.01, "family": "bending", "order": i + 1, "residue_per_kg": [a]} for i, (f, a) in enumerate(modes)],
        "structure": {"rigid_line_per_kg": [[0.0]]}, "sensors": [{"position_m": 0.05, "angle_deg": 0}], "impact": {"position_m": 0.05, "angle_deg": 0},
        "pulse": {"kind": "haversine", "width_s": 0.001, "peak_n": 300, "width_spread": 0, "peak_spread": 0}, "onset_spread_s": 0, "noise": {"force": 1e-3, "accel": 1e-2},
    }).record  # fmt: skip


def test_deflections_from_modes_scatter_as_their_standard_deviations_state():
    found = [percuss.deflect(held_beam(seed), method="modal", band=(10, 1000)) for seed in range(15)]
    peaks = np.array([[hit["peak_m"] for hit in one.hits] for one in found])
    stated = np.array([[hit["peak_std_m"] for hit in one.hits] for one in found])
    ratio = np.sqrt(np.mean(stated**2) / np.mean(np.var(peaks, axis=0, ddof=1)))
    # The scatter of 5 times 15 values is known to 9 %. The ± also counts motion that the noise
    # hides, so it may reach twice the scatter.
    assert 0.75 < ratio < 2


def test_the_remedies_of_deflections_lead_away_from_the_method_that_failed():
    bat = percuss.synth("wood-bat").record
    texts = {
        key: " ".join(one["message"] for one in percuss.deflect(record, band=(60, 3200), **options).warnings)
        for key, record, options in [
            ("modal", bat, {"method": "modal"}), ("mass", bat, {"method": "modal", "effective_mass": 0.5}),
            ("no force", percuss.Record(None, bat.accel_mps2, bat.fs_hz), {}),
        ]
    }  # fmt: skip
    assert "do not exceed" in texts["modal"] and "method modal" not in texts["modal"] and "effective mass" in texts["modal"]
    assert "do not exceed" in texts["mass"] and "effective mass" not in texts["mass"] and "drift-free" in texts["mass"]
    assert "do not exceed" in texts["no force"] and "modal" not in texts["no force"]


def test_deviations_of_scaled_shapes_include_the_scale():
    """The document states the standard deviation of the scale separately; the array shapes_std includes it."""
    scan = percuss.survey(percuss.synth("bat-scan").record, band=BAND, effort="quick", driving_point=(0, 0))
    shapes = [mode["shape"] for mode in scan.to_dict()["modes"]]
    assert any(one["scale_std"] > 0 for one in shapes)
    assert scan.scale_std.tolist() == [one["scale_std"] for one in shapes]
    own = np.array([[place["std"] for place in one["values"]] for one in shapes])
    own[:, scan.shape_points == 0] = 0  # the driving point sets the scale: the scale's error is its only one
    assert np.allclose(scan.shapes_std, np.hypot(own, scan.scale_std[:, None] * abs(scan.shapes)), rtol=1e-12)


def test_results_without_modes_keep_their_places():
    found = percuss.analyze(percuss.synth("wood-bat").record, band=(250, 450))
    assert len(found.frequency_hz) == 0 and found.residues.shape == (0, 1, 2)
    assert found.synthesise([300.0]).shape == (1, 2, 1)  # the residual terms
    with pytest.raises(percuss.UsageError, match="none was found"):
        found.plot("shapes")
