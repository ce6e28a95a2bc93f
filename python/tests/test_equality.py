"""Results of the module equal the output of the command line byte for byte."""

import json
import math

import numpy as np
import pytest

import percuss
from conftest import SOURCE

BAND = (60, 3200)


def options_of(words):
    """The keywords for the options of a command line."""
    kept = {}
    for flag, value in words:
        keyword = flag.lstrip("-").replace("-", "_")
        kept[keyword + "_" if keyword == "from" else keyword] = True if value is None else value
    return kept


ANALYSES = [
    [],
    [("--band", "60:3200")],
    [("--band", "60:3200"), ("--effort", "quick")],
    [("--band", "100:2000"), ("--effort", "standard"), ("--estimator", "hv"), ("--per-hit", None)],
    [("--only", "hits")],
    [("--only", "frf,coherence")],
    [("--only", "modes"), ("--band", "60:1500"), ("--modes", "2")],
    [("--only", "deflection")],
    [("--reject-hit", "1,2"), ("--from", "0"), ("--to", "0.8"), ("--explain", None)],
    [("--start", "165,568"), ("--angle", "0,45"), ("--overlay-db", "0.5"), ("--stabilisation", None)],
    [("--bat-id", "7"), ("--bat", "length_in=33"), ("--threads", "1"), ("--exponential", "0.01")],
    [("--fs", "12800"), ("--force-scale", "2.5"), ("--unit", "g")],
]


@pytest.mark.parametrize("words", ANALYSES, ids=lambda words: " ".join(flag for flag, _ in words) or "plain")
def test_analyze_prints_the_same_document(tool, bat, words):
    bat.save("bat.h5")
    found = percuss.analyze("bat.h5", **options_of(words))
    printed = tool.document("analyze", "bat.h5", *(flag if value is None else f"{flag}={value}" for flag, value in words))
    assert found.json == printed
    assert found.to_dict() == json.loads(printed)


@pytest.mark.parametrize("kind", ["h5", "csv", "mat", "uff", "wav"])
def test_every_format_gives_the_same_document(tool, bat, kind):
    bat.save(f"bat.{kind}")
    assert percuss.analyze(f"bat.{kind}", band=BAND).json == tool.document("analyze", f"bat.{kind}", "--band", "60:3200")


def test_several_files_are_tests_hits_or_points(tool, bat):
    for name in ("a.h5", "b.h5"):
        bat.save(name)
    for files in ("tests", "hits", "points"):
        found = percuss.analyze("a.h5", "b.h5", band=BAND, files=files)
        assert found.json == tool.document("analyze", "a.h5", "b.h5", "--band", "60:3200", "--files", files)
    runs = percuss.analyze(["a.h5", "b.h5"], band=BAND, files="tests").runs
    assert [len(run.frequency_hz) for run in runs] == [3, 3]
    assert runs[0].modes == runs[1].modes
    together = percuss.analyze(["a.h5", "b.h5"], band=BAND, files="tests")
    for name in ("frequency_hz", "modes", "points", "possible"):
        with pytest.raises(percuss.UsageError, match="2 tests"):
            getattr(together, name)
    assert len(together["runs"]) == 2 and "test 1" in together._repr_html_() and "test 1" in str(together)


def test_records_in_memory_are_joined(tool, bat):
    """Three copies of a test in memory have the frequencies of three copies in files."""
    for name in ("a.h5", "b.h5", "c.h5"):
        bat.save(name)
    joined = percuss.analyze(percuss.read("a.h5"), bat.record, percuss.Record(bat.record.force_n, bat.record.accel_mps2, 25600.0), band=BAND)
    printed = json.loads(tool.document("analyze", "a.h5", "b.h5", "c.h5", "--band", "60:3200"))
    assert len(joined.hits) == 15 and [one["path"] for one in joined["inputs"]] == ["a.h5", "synthetic", "arrays"]
    assert {hit["file"] for hit in joined.hits} == {"a.h5", "synthetic", "arrays"}
    assert np.allclose(joined.frequency_hz, [mode["frequency_hz"] for mode in printed["modes"]], rtol=1e-9)


def test_arrays_of_a_document_have_its_bits(tool, bat):
    bat.save("bat.h5")
    found = percuss.analyze("bat.h5", band=BAND)
    modes = json.loads(tool.document("analyze", "bat.h5", "--band", "60:3200"))["modes"]
    for name in ("frequency_hz", "frequency_std_hz", "damping_ratio", "damping_ratio_std"):
        assert getattr(found, name).tolist() == [mode[name] for mode in modes]
    for mode, residues in zip(modes, found.residues):
        for one in mode["residues"]:
            assert residues[0, one["channel"]] == complex(one["re"], one["im"])


def test_arrays_in_memory_give_the_document_of_the_file(tool, bat):
    """The documents differ only in the name and size of the file."""
    bat.save("bat.h5")
    record = percuss.read("bat.h5")
    for form in (float, np.float32):
        if form is np.float32:  # the file then holds the same rounded numbers
            percuss.write("bat.h5", percuss.Record(record.force_n.astype(form), record.accel_mps2.astype(form), record.fs_hz), force=True)
        found = percuss.analyze(record.force_n.astype(form), record.accel_mps2.astype(form), fs=25600.0, band=BAND, angle=(0, 90))
        printed = json.loads(tool.document("analyze", "bat.h5", "--band", "60:3200", "--angle", "0,90"))
        assert found["inputs"] == [] and len(printed.pop("inputs")) == 1
        assert {key: value for key, value in found.to_dict().items() if key != "inputs"} == printed


def test_frf_file_has_the_bits_of_the_arrays(tool, bat):
    bat.save("bat.h5")
    for kind in ("accelerance", "mobility", "receptance"):
        responses = percuss.frf("bat.h5", band=BAND, kind=kind)
        assert responses.json == tool.document("frf", "bat.h5", "--band", "60:3200", "--kind", kind)
        responses.save(f"{kind}.csv")
        tool("frf", "bat.h5", "--band", "60:3200", "--kind", kind, "-o", "printed.csv", "--force")
        assert open(f"{kind}.csv").read() == open("printed.csv").read()
        rows = [line.split(",") for line in open(f"{kind}.csv").read().splitlines() if line[:1].isdigit()]
        assert [float(row[0]) for row in rows] == responses.frequency_hz.tolist()
        assert [complex(float(row[1]), float(row[2])) for row in rows] == responses.at(0, 0).tolist()


def test_measured_frfs_are_analysed_alike(tool, bat):
    percuss.frf(bat.record, band=BAND).save("frfs.h5")
    printed = json.loads(tool.document("analyze", "frfs.h5", "--band", "60:3200"))
    assert percuss.analyze("frfs.h5", band=BAND).to_dict() == printed
    assert percuss.analyze(percuss.read("frfs.h5"), band=BAND).to_dict() == printed


def test_calls_are_independent(bat):
    """Declared command lines are reused; neither the order of calls nor errors between them change a result."""
    calls = [dict(options_of(words), effort="quick") for words in ANALYSES if ("--fs", "12800") not in words]
    first = [percuss.analyze(bat.record.force_n, bat.record.accel_mps2, **{"fs": 25600.0, **options}).json for options in calls]
    for options, wanted in reversed(list(zip(calls, first))):
        with pytest.raises(percuss.InputError):
            percuss.analyze(bat.record, band=(7, 3), only="hits", modes=3, reject_hit=[1, 2])
        assert percuss.analyze(bat.record.force_n, bat.record.accel_mps2, **{"fs": 25600.0, **options}).json == wanted
    plain = percuss.models.beam(support="free").json
    percuss.models.beam(support="pinned", modes=3, length=2.0)
    assert percuss.models.beam(support="free").json == plain


def test_dictionaries_stand_for_files(tool, bat):
    bat.save("bat.csv")
    setup = [
        {"name": "acc0_m_s2", "role": "acceleration", "sign": -1, "angle_deg": 0},
        {"name": "acc1_m_s2", "role": "acceleration", "angle_deg": 45},
    ]
    open("setup.json", "w").write(json.dumps(setup))
    spec = json.loads((SOURCE / "fixtures" / "wood-bat.json").read_text())
    open("spec.json", "w").write(json.dumps(spec))
    assert percuss.synth(spec).json == percuss.synth("spec.json").json == tool.document("synth", "spec.json")
    by_file = percuss.analyze("bat.csv", band=BAND, setup="setup.json").json
    assert percuss.analyze("bat.csv", band=BAND, setup=setup).json == by_file
    assert by_file == tool.document("analyze", "bat.csv", "--band", "60:3200", "--setup", "setup.json")
    assert by_file != percuss.analyze("bat.csv", band=BAND).json


def test_survey_prints_the_same_document(tool):
    percuss.synth("roving-barrel").save("barrel.h5")
    found = percuss.survey("barrel.h5", band=BAND, effort="quick")
    assert found.json == tool.document("survey", "barrel.h5", "--band", "60:3200", "--effort", "quick")
    assert found.to_dict()["auto_mac"]["value"] == found.mac.tolist()
    tool("survey", "barrel.h5", "--band", "60:3200", "--effort", "quick", "-o", "printed.csv")
    found.save("saved.csv")
    assert open("saved.csv").read() == open("printed.csv").read()


def test_deflection_prints_the_same_document(tool, bat):
    bat.save("bat.h5")
    seen = percuss.deflect("bat.h5", method="drift-free")
    assert seen.json == tool.document("deflect", "bat.h5", "--method", "drift-free")
    for hit, curve in zip(seen.hits, seen.curves()):
        assert np.nanmax(np.abs(curve["deflection_m"])) >= abs(hit["peak_m"]) > 0


def test_a_title_stands_on_pages_only(tool, bat):
    bat.save("bat.h5")
    found = percuss.analyze("bat.h5", band=BAND, effort="quick", title="Bat 7")
    found.save("found.json")
    found.save("found.html")
    assert "Bat 7" in open("found.html", encoding="utf-8").read()
    assert "Bat 7" not in open("found.json", encoding="utf-8").read()


def test_nodes_print_the_same_document(tool):
    # A beam struck every half inch from 6 to 9 in, with a node at 7.5 in.
    inches = [6 + 0.5 * i for i in range(7)]
    mode = {"frequency_hz": 200, "damping_ratio": 0.01, "residue_per_kg": [7.5 - at for at in inches]}
    spec = {"fs_hz": 4096, "duration_s": 1, "modes": [mode], "sensors": [{}], "hits": 1,
            "impact": [{"position_m": 0.0254 * at} for at in inches]}
    with open("scan.json", "w", encoding="utf-8") as file:
        json.dump(spec, file)
    percuss.synth("scan.json").save("scan.h5")
    found = percuss.nodes("scan.h5", positions="6:0.5:9in", band=(60, 1000))
    assert found.json == tool.document("nodes", "scan.h5", "--positions", "6:0.5:9in", "--band", "60:1000")
    assert percuss.nodes("scan.h5", positions=(6, 0.5, 9), band=(60, 1000)).json == tool.document(
        "nodes", "scan.h5", "--positions", "6.0:0.5:9.0", "--band", "60:1000")
    for listed in (inches, np.array(inches)):
        assert percuss.nodes("scan.h5", positions=listed, band=(60, 1000)).json == tool.document(
            "nodes", "scan.h5", "--positions", ",".join(str(at) for at in inches), "--band", "60:1000")


MODELS = [
    (percuss.models.beam, ["model", "beam"], {"support": "free", "length": 0.84, "modes": 6}),
    (percuss.models.beam, ["model", "beam"], {"fit": ["ei", "torsion"], "measured": (14.5, 322, 1038)}),
    (percuss.models.impact, ["model", "impact"], {"modes": 10}),
    (percuss.models.impact, ["model", "impact"], {"sweep": {"ei": "1000:1000:3000"}}),
    (percuss.models.rigid, ["model", "rigid"], {}),
    (percuss.models.trampoline, ["model", "trampoline"], {"hoop": (500, 500, 3000)}),
    (percuss.models.shell, ["model", "shell"], {}),
    (percuss.metrics.performance, ["metrics"], {"length_in": 34, "moi_oz_in2": 10450, "ball_g": 145.4, "z_in": 6}),
]


@pytest.mark.parametrize("function, command, options", MODELS, ids=lambda one: " ".join(one) if isinstance(one, list) else None)
def test_models_print_the_same_document(tool, function, command, options):
    words = []
    for key, value in options.items():
        between = ":" if key == "hoop" else ","
        text = "ei=" + value["ei"] if isinstance(value, dict) else between.join(map(str, value)) if isinstance(value, (list, tuple)) else value
        words.append(f"--{key.replace('_', '-')}={text}")
    assert function(**options).json == tool.document(*command, *words)


def test_a_bat_model_takes_a_profile_from_memory(tool):
    profile = np.array([[0.2, 0.025], [0.5, 0.03], [0.84, 0.066]])
    with open("profile.txt", "w") as file:
        file.writelines(f"{end!r} {diameter!r}\n" for end, diameter in profile.tolist())
    assert percuss.models.bat(profile=profile).json == percuss.models.bat(profile="profile.txt").json
    assert percuss.models.bat(profile="profile.txt").json == tool.document("model", "bat", "--profile", "profile.txt")


@pytest.mark.parametrize("name", ["certify", "abi", "study"])
def test_protocols_print_the_same_document(tool, name):
    text = percuss.example(name)
    assert text == tool(name, "--example").stdout
    path = "given.csv" if name == "study" else "given.json"
    open(path, "w").write(text)
    function = getattr(percuss.metrics, name)
    found = function(path)
    ran = tool(name, path, "--json")
    assert found.json == ran.stdout and found.exit_code == ran.returncode
    if name != "study":
        assert function(json.loads("\n".join(line for line in text.splitlines() if not line.lstrip().startswith("//")))).json == found.json


def test_comparison_and_calibration_print_the_same_document(tool, bat):
    bat.save("bat.h5")
    a, b = percuss.analyze("bat.h5", band=BAND), percuss.models.beam(support="free", length=0.84)
    a.save("a.json")
    b.save("b.json")
    assert open("a.json").read() == a.json
    assert percuss.compare(a, b, furthest=40)["pairs"] == json.loads(tool.document("compare", "a.json", "b.json", "--furthest", 40))["pairs"]
    assert percuss.compare("a.json", "b.json").json == tool.document("compare", "a.json", "b.json")
    with open("mass.csv", "w") as mass:  # a free mass of 1.5 kg
        mass.write("t_s,hammer,acc_m_s2\n")
        for i in range(3000):
            force = 40 * math.sin(math.pi * (i - 800) / 20) if 800 <= i < 820 else 0
            mass.write(f"{i / 2000:.4f},{force / 0.0084:.6f},{force / 1.5:.6f}\n")
    words = ["mass.csv", "--mass", 1.5, "--force-channel", "hammer"]
    assert percuss.calibrate("mass.csv", mass=1.5, force_channel="hammer").json == tool.document("calibrate", *words)


def test_info_and_truth_print_the_same_document(tool):
    test = percuss.synth("wood-bat", seed=3)
    test.save("bat.h5")
    tool("synth", "wood-bat", "--seed", 3, "-o", "printed.h5", "--quiet")
    assert open("bat.h5", "rb").read() == open("printed.h5", "rb").read()
    assert open("bat.truth.json").read() == open("printed.truth.json").read() == test.json
    open("none.csv", "w").write("lunch order\n")
    assert percuss.info("bat.h5", "none.csv").json == tool("info", "bat.h5", "none.csv", "--json").stdout


def assert_equal_but_for_the_command(one, other):
    """The pages differ only in the lines with their commands; `one` names the title and the paper in its command."""
    lines, others = one.split("\n"), other.split("\n")
    assert len(lines) == len(others)
    differing = [(a, b) for a, b in zip(lines, others) if a != b]
    assert all("percuss analyze" in a and "percuss analyze" in b for a, b in differing)
    assert "--title=Bat 7" in one and "--paper=letter" in one


def test_reports_equal_the_reports_of_the_command_line(tool, bat, monkeypatch):
    """The reports differ only in their command line: it names the output file only in the report of the tool."""
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "0")
    bat.save("bat.h5")
    percuss.analyze("bat.h5", band=BAND).report("saved.html")
    tool("analyze", "--band=60:3200", "--json", "--quiet", "bat.h5", "-o", "printed.html")
    saved, printed = open("saved.html").read(), open("printed.html").read()
    assert "percuss analyze --band=60:3200 --json --quiet bat.h5" in saved
    assert saved == printed.replace(" -o printed.html", "")
    stated = {"title": "Bat 7", "customer": "A", "operator": "B", "specimen": "C", "date": "1 May", "note": "D < E", "paper": "letter"}
    percuss.analyze("bat.h5", band=BAND).report("stated.html", **stated)
    options = [f"--{name}={value}" for name, value in stated.items()]
    tool("analyze", "--band=60:3200", "--json", "--quiet", "bat.h5", *options, "-o", "printed-stated.html")
    page = open("stated.html").read()
    assert "<title>Bat 7" in page and "D &lt; E" in page
    assert_equal_but_for_the_command(page, open("printed-stated.html").read())
    percuss.models.beam(support="free").report("beam.html")
    tool("model", "beam", "--support=free", "--json", "--quiet", "-o", "printed-beam.html")
    assert open("beam.html").read() == open("printed-beam.html").read().replace(" -o printed-beam.html", "")
