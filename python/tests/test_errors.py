"""Errors in Python: the message of the command line with keywords in place of flags, and its parts as attributes."""

import pickle

import numpy as np
import pytest

import percuss

INVALID = [
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


@pytest.mark.parametrize("words, options", INVALID, ids=lambda one: " ".join(one) if isinstance(one, list) else "")
def test_invalid_options_raise_the_error_of_the_command_line(tool, bat, words, options):
    bat.save("bat.csv")
    message = tool.error("analyze", "bat.csv", *words)
    with pytest.raises(percuss.InputError) as raised:
        percuss.analyze("bat.csv", **options)
    assert str(raised.value) == message
    assert "--" not in message


@pytest.mark.parametrize("content", [b"", b"lunch order\n", b"\x89HDF\r\n\x1a\n" + b"\0" * 100, b"MATLAB 5.0 MAT-file" + b"\0" * 200, b"TDSm"])
def test_invalid_files_raise_the_error_of_the_command_line(tool, content):
    open("file", "wb").write(content)
    message = tool.error("analyze", "file")
    with pytest.raises(percuss.InputError) as raised:
        percuss.analyze("file")
    assert str(raised.value) == message
    assert str(raised.value) == str(pytest.raises(percuss.InputError, percuss.read, "file").value)


def test_files_and_arguments_raise_the_error_of_the_command_line(tool):
    for call, words in [
        (lambda: percuss.analyze("none.h5"), ["analyze", "none.h5"]),
        (lambda: percuss.analyze("a b.h5", "a b.h5"), ["analyze", "a b.h5", "a b.h5"]),
        (lambda: percuss.synth("wod-bat"), ["synth", "wod-bat"]),
        (lambda: percuss.models.beam(length=-1), ["model", "beam", "--length=-1"]),
        (lambda: percuss.metrics.performance(length_in=3), ["metrics", "--length-in=3"]),
        (lambda: percuss.metrics.certify("none.json"), ["certify", "none.json"]),
    ]:
        with pytest.raises(percuss.InputError) as raised:
            call()
        assert str(raised.value) == tool.error(*words)


def test_missing_keywords_are_named():
    for call, keyword, form in [
        (lambda: percuss.models.bat(), "profile", "FILE"),
        (lambda: percuss.calibrate("none.h5"), "mass", "KG"),
    ]:
        with pytest.raises(percuss.UsageError) as raised:
            call()
        assert str(raised.value) == f"{keyword}= is missing; give {form}"
        assert raised.value.options == (keyword,)


def test_errors_hold_their_parts(tool, bat):
    error = pytest.raises(percuss.UsageError, percuss.analyze, bat.record, effort="bst").value
    assert (error.problem, error.where, error.remedy) == ("effort= cannot be 'bst'", "", "did you mean best?")
    assert (error.options, error.value) == (("effort",), "bst")
    error = pytest.raises(percuss.UsageError, percuss.analyze, bat.record, start=5000, band=(60, 3200)).value
    assert str(error) == "start= cannot be '5000': it lies outside the band 60:3200 Hz; widen the band or omit it (band=)"
    error = pytest.raises(percuss.UsageError, percuss.metrics.performance, period_s=1, gate_times_s=[1, 2]).value
    assert str(error) == "period_s= and gate_times_s= exclude each other; give one of them"
    assert (error.options, error.value) == (("period_s", "gate_times_s"), "")
    bat.save("bat.csv")
    error = pytest.raises(percuss.InputError, percuss.write, "bat.csv", bat).value
    assert (error.problem, error.where, error.options) == ("file exists", "bat.csv", ("force",))
    assert str(error).endswith("(force=True)")
    error = pytest.raises(percuss.InputError, percuss.analyze, "bat.csv", unit="furlong").value
    assert error.options == ("unit",) and str(error).endswith(" (unit=)")
    error = pytest.raises(percuss.UsageError, percuss.metrics.study).value
    assert str(error).endswith("(see percuss.analyze(bat_id=))")


def test_notes_name_keywords(tool):
    with open("plain.csv", "w") as file:
        file.write("t_s,hammer,sensor\n0,1,2\n0.1,3,4\n0.2,5,6\n")
    record = percuss.read("plain.csv", force_channel="hammer", accel_channel="sensor")
    assert record.notes[:2] == [
        "the unit of hammer is not stated; taken as N (force_unit=)",
        "the unit of sensor is not stated; taken as m/s^2 (unit=)",
    ]


@pytest.mark.parametrize(
    "option, shown",
    [
        ("accel_channel", "accel_channel="),
        ("from", "from_="),
        ("force", "force=True"),
        ("survey.example", "percuss.example('survey')"),
        ("synth.list", "percuss.presets()"),
        ("analyze.bat_id", "percuss.analyze(bat_id=)"),
        ("model.trampoline.json", "percuss.models.trampoline()"),
        ("certify.limit", "percuss.metrics.certify(limit=)"),
        ("batch.run.force", "percuss batch run --force"),
        ("SPEC", "spec"),
    ],
)
def test_options_are_written_as_python(option, shown):
    assert percuss.InputError("problem", "place", "remedy", [option]).args[3] == (option,)
    see = "see " if "." in option else ""
    assert str(percuss.InputError("problem", "place", "remedy", [option])) == f"problem (place); remedy ({see}{shown})"


def test_options_of_other_commands_follow_the_own_ones():
    error = percuss.InputError("problem", "place", "remedy", ["synth.list", "geometry", "survey.example"])
    assert str(error) == "problem (place); remedy (geometry=; see percuss.presets(), percuss.example('survey'))"


def test_unknown_keywords_name_the_nearest():
    for call, wanted in [
        (lambda: percuss.analyze("x", bnd=(1, 2)), "analyze() has no keyword 'bnd'; did you mean 'band'?"),
        (lambda: percuss.analyze("x", accel_chanel=1), "did you mean 'accel_channel'?"),
        (lambda: percuss.models.beam(lenght=1), "models.beam() has no keyword 'lenght'; did you mean 'length'?"),
        (lambda: percuss.analyze("x", zzzzzzzzzzz=1), "help(percuss.analyze) lists the keywords"),
        (lambda: percuss.analyze("x", output="y.json"), "analyze() has no keyword 'output'"),
    ]:
        with pytest.raises(TypeError) as raised:
            call()
        assert wanted in str(raised.value)


def test_values_of_another_type_raise_type_errors(bat):
    for options in ({"modes": object()}, {"per_hit": "yes"}, {"band": True}, {"band": {1, 2}}, {"fs": b"1"}, {"angle": [None, 1]}):
        with pytest.raises(TypeError):
            percuss.analyze(bat.record, **options)
    for data in ((1,), (None,), ("a.h5", np.zeros(3)), (object(), object(), object()), (np.zeros(3), np.zeros(3))):
        with pytest.raises(TypeError):
            percuss.analyze(*data)
    with pytest.raises(TypeError, match="percuss.read"):
        percuss.analyze(bat.record, unit="g")


def test_data_in_memory_are_named_by_their_keyword(bat):
    with pytest.raises(percuss.InputError) as raised:
        percuss.analyze(bat.record.force_n, bat.record.accel_mps2, fs=25600.0, setup={"chanels": []})
    assert "setup" in str(raised.value) and "/proc" not in str(raised.value)
    with pytest.raises(percuss.InputError) as raised:
        percuss.synth({"name": "x"})
    assert "spec" in str(raised.value) and "/proc" not in str(raised.value)


def test_a_test_without_a_usable_hit_gives_a_result():
    rest = percuss.Record(np.zeros((2, 512)), np.random.default_rng(0).normal(size=(2, 1, 512)), fs=4096.0)
    found = percuss.analyze(rest)
    assert not found.possible and found.exit_code == 4 and len(found.hits) == 2
    for name in ("frequency_hz", "points", "residues", "poles", "lower"):
        with pytest.raises(percuss.NoHitError):
            getattr(found, name)
    with pytest.raises(percuss.NoHitError):
        found.save("frfs.h5")
    assert all("no hit has a pulse of the force" in text for text in (found._repr_html_(), str(found)))


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
    with pytest.raises(percuss.UsageError, match="paper"):
        found.report("x.html", paper="a5")
    with pytest.raises(percuss.UsageError, match="title"):
        found.report("x.html", title="x" * 1000)
    with pytest.raises(percuss.InputError, match="none.png"):
        found.report("x.html", logo="none.png")
    with pytest.raises(TypeError):
        found.report("x.html", titel="x")
    with pytest.raises(percuss.InputError, match="file exists"):
        percuss.write("bat.csv", bat)


def test_names_of_files_may_be_any_bytes(tool, bat):
    name = b"b\xff\xc3\xa4t -x.csv"
    bat.save(name)
    again = percuss.analyze(name, band=(60, 3200))
    assert again["inputs"][0]["path"] == "b\ufffd\u00e4t -x.csv" and "b\ufffd" in str(again) + percuss.read(name).source
    with pytest.raises(percuss.InputError, match=r"b\\xff.*exists|exists.*b\\xff"):
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
    for one in (error, percuss.InputError("no force", "a.csv", "name it", ["force_channel"])):
        again = pickle.loads(pickle.dumps(one))
        assert type(again) is type(one) and str(again) == str(one) and again.options == one.options
    assert issubclass(percuss.NoHitError, percuss.InputError)
    assert percuss.InputError.__module__ == "percuss"


def test_hidden_characters_are_escapes(tmp_path):
    with pytest.raises(percuss.InputError) as raised:
        percuss.analyze(str(tmp_path / "a\u202e\u009b\u2028.h5"))
    assert "a\\u202e\\u009b\\u2028.h5" in str(raised.value)
    assert not {"\u202e", "\u009b", "\u2028"} & set(str(raised.value) + raised.value.where)
