"""What cannot be used is refused, in the words of the command line."""

import pickle

import numpy as np
import pytest

import percuss

REFUSED = [
    (["--band", "3200:60"], {"band": (3200, 60)}),
    (["--band", "a:b"], {"band": ("a", "b")}),
    (["--effort", "bst"], {"effort": "bst"}),
    (["--fs", "-5"], {"fs": -5}),
    (["--fs", "nan"], {"fs": float("nan")}),
    (["--modes", "0"], {"modes": 0}),
    (["--modes", "1.5"], {"modes": 1.5}),
    (["--only", "mods"], {"only": "mods"}),
    (["--accept-hit", "1", "--reject-hit", "1"], {"accept_hit": 1, "reject_hit": [1]}),
    (["--accept-hit", "99"], {"accept_hit": 99}),
    (["--angle", "1,2,3"], {"angle": [1, 2, 3]}),
    (["--unit", "furlong"], {"unit": "furlong"}),
    (["--to", "0.1", "--from", "0.2"], {"to": 0.1, "from_": 0.2}),
    (["--setup", "none.json"], {"setup": "none.json"}),
    (["--start", "5000", "--band", "60:3200"], {"start": 5000, "band": (60, 3200)}),
    (["--band", "12000:12000.001"], {"band": (12000, 12000.001)}),
]


@pytest.mark.parametrize("words, options", REFUSED, ids=lambda one: " ".join(one) if isinstance(one, list) else "")
def test_options_are_refused_in_the_same_words(tool, bat, words, options):
    bat.save("bat.csv")
    complaint = tool.complaint("analyze", "bat.csv", *words)
    with pytest.raises(percuss.InputError) as refused:
        percuss.analyze("bat.csv", **options)
    assert str(refused.value) == complaint


@pytest.mark.parametrize("content", [b"", b"lunch order\n", b"\x89HDF\r\n\x1a\n" + b"\0" * 100, b"MATLAB 5.0 MAT-file" + b"\0" * 200, b"TDSm"])
def test_files_are_refused_in_the_same_words(tool, content):
    open("file", "wb").write(content)
    complaint = tool.complaint("analyze", "file")
    with pytest.raises(percuss.InputError) as refused:
        percuss.analyze("file")
    assert str(refused.value) == complaint
    assert str(refused.value) == str(pytest.raises(percuss.InputError, percuss.read, "file").value)


def test_missing_files_and_options_are_named(tool):
    for call, words in [
        (lambda: percuss.analyze("none.h5"), ["analyze", "none.h5"]),
        (lambda: percuss.analyze("a b.h5", "a b.h5"), ["analyze", "a b.h5", "a b.h5"]),
        (lambda: percuss.nodes("none.h5"), ["nodes", "none.h5"]),
        (lambda: percuss.synth("wod-bat"), ["synth", "wod-bat"]),
        (lambda: percuss.models.bat(), ["model", "bat"]),
        (lambda: percuss.models.beam(length=-1), ["model", "beam", "--length=-1"]),
        (lambda: percuss.metrics.performance(length_in=3), ["metrics", "--length-in=3"]),
        (lambda: percuss.metrics.certify("none.json"), ["certify", "none.json"]),
    ]:
        with pytest.raises(percuss.InputError) as refused:
            call()
        assert str(refused.value) == tool.complaint(*words)


def test_unknown_keywords_name_the_nearest():
    for call, wanted in [
        (lambda: percuss.analyze("x", bnd=(1, 2)), "analyze() has no keyword 'bnd'; did you mean 'band'?"),
        (lambda: percuss.analyze("x", accel_chanel=1), "did you mean 'accel_channel'?"),
        (lambda: percuss.models.beam(lenght=1), "models.beam() has no keyword 'lenght'; did you mean 'length'?"),
        (lambda: percuss.analyze("x", zzzzzzzzzzz=1), "help(percuss.analyze) lists them"),
        (lambda: percuss.analyze("x", output="y.json"), "analyze() has no keyword 'output'"),
    ]:
        with pytest.raises(TypeError) as refused:
            call()
        assert wanted in str(refused.value)


def test_values_of_other_types_are_refused(bat):
    for options in ({"modes": object()}, {"per_hit": "yes"}, {"band": True}, {"band": {1, 2}}, {"fs": b"1"}, {"angle": [None, 1]}):
        with pytest.raises(TypeError):
            percuss.analyze(bat.record, **options)
    for data in ((1,), (None,), ("a.h5", np.zeros(3)), (object(), object(), object()), (np.zeros(3), np.zeros(3))):
        with pytest.raises((TypeError, percuss.InputError)):
            percuss.analyze(*data)
    with pytest.raises(TypeError, match="percuss.read"):
        percuss.analyze(bat.record, unit="g")


def test_what_is_in_memory_is_named_by_its_keyword(bat):
    with pytest.raises(percuss.InputError) as refused:
        percuss.analyze(bat.record.force_n, bat.record.accel_mps2, fs=25600.0, setup={"chanels": []})
    assert "setup" in str(refused.value) and "/proc" not in str(refused.value)
    with pytest.raises(percuss.InputError) as refused:
        percuss.synth({"name": "x"})
    assert "spec" in str(refused.value) and "/proc" not in str(refused.value)


def test_no_usable_hit_is_a_result():
    rest = percuss.Record(np.zeros((2, 512)), np.random.default_rng(0).normal(size=(2, 1, 512)), fs=4096.0)
    found = percuss.analyze(rest)
    assert not found.possible and found.exit_code == 4 and len(found.hits) == 2
    for name in ("frequency_hz", "frf", "residues", "frf_frequency_hz"):
        with pytest.raises(percuss.NoHitError):
            getattr(found, name)
    with pytest.raises(percuss.NoHitError):
        found.save("frfs.h5")
    assert "no hit can be used" in found._repr_html_() and "no hit can be used" in str(found)


def test_files_are_not_overwritten(tool, bat):
    bat.save("bat.csv")
    found = percuss.analyze("bat.csv", band=(60, 3200))
    found.save("x.json")
    with pytest.raises(percuss.InputError, match="file exists"):
        found.save("x.json")
    found.save("x.json", force=True)
    with pytest.raises(percuss.UsageError, match="cannot tell what to write"):
        found.save("x.xyz")
    with pytest.raises(percuss.UsageError, match="ends in .html"):
        found.report("x.pdf")
    with pytest.raises(percuss.InputError, match="file exists"):
        percuss.write("bat.csv", bat)


def test_names_of_files_may_be_any_bytes(tool, bat):
    name = b"b\xff\xc3\xa4t -x.csv"
    bat.save(name)
    again = percuss.analyze(name, band=(60, 3200))
    assert again["inputs"][0]["path"] == "b\ufffd\u00e4t -x.csv" and "b\ufffd" in str(again) + percuss.read(name).source
    with pytest.raises(percuss.InputError, match="b\ufffd.*exists|exists.*b\ufffd"):
        percuss.write(name, bat)
    bat.save("-b.csv")
    assert len(percuss.analyze("-b.csv", band=(60, 3200)).frequency_hz) == 3
    for path in ("a\0b.csv", b"\0"):
        with pytest.raises(percuss.UsageError, match="zero byte"):
            percuss.analyze(path)
    with pytest.raises(percuss.UsageError, match="zero byte"):
        percuss.analyze("-b.csv", unit="g\0")


def test_errors_are_ordinary_exceptions():
    error = pytest.raises(percuss.UsageError, percuss.analyze).value
    assert isinstance(error, percuss.InputError) and isinstance(error, ValueError)
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is percuss.UsageError and str(again) == str(error)
    assert issubclass(percuss.NoHitError, percuss.InputError)
    assert percuss.InputError.__module__ == "percuss"
