"""The checks of .ci/check-shared."""
import argparse
import importlib.util
import json
import math
import os
import shutil
import statistics
import subprocess
import sys
import tempfile

import h5py
import numpy
import scipy.io

PERCUSS = os.environ["PERCUSS"]
FEW_SIGMA = 4.5  # tolerance in reported standard deviations; a normal distribution exceeds it once in 150 000
ROUNDING = 1e-6  # of a damping ratio: without noise, standard deviations shrink to rounding errors

results = []


def check(name, passed, shown=""):
    results.append(bool(passed))
    print("%-4s %-64s %s" % ("ok" if passed else "FAIL", name, shown), flush=True)


def percuss(*arguments):
    """The exit code and document of a command."""
    done = subprocess.run([PERCUSS, *map(str, arguments), "--json"], capture_output=True, text=True, timeout=600)
    try:
        return done.returncode, json.loads(done.stdout)
    except ValueError:
        print(done.stderr.strip())
        return done.returncode, {"hits": [], "modes": [], "coherence": []}


def codes(hit):
    return [finding["code"] for finding in hit["findings"]]


def nearest(document, frequency_hz):
    return min(document["modes"], key=lambda mode: abs(mode["frequency_hz"] - frequency_hz), default={"frequency_hz": math.inf, "damping_ratio": math.inf})


def seen_in(document, mode):
    """The document's mode nearest to this mode, if within its half-power bandwidth or 1 Hz; otherwise None."""
    reach_hz = max(2 * mode["damping_ratio"] * mode["frequency_hz"], 1)
    found = nearest(document, mode["frequency_hz"])
    return found if abs(found["frequency_hz"] - mode["frequency_hz"]) < reach_hz else None


def check_halves_of_hits(path, document):
    """Real modes also appear in each half of the hits, with the same frequencies."""
    halves = [percuss("analyze", path, "--band", "400:8000", "--reject-hit", hits)[1] for hits in ("4,5", "1-3")]
    seen = [[seen_in(half, mode) for half in halves] for mode in document["modes"]]
    once = sum(any(both) for both in seen)
    check("pyfrf record.h5: nine of ten modes in one half of the hits too", 0 < 0.9 * len(seen) <= once, "%d of %d" % (once, len(seen)))
    pairs = [both for both in seen if all(both)]
    check("pyfrf record.h5: eight of ten modes in both halves", 0.8 * len(seen) <= len(pairs), "%d of %d" % (len(pairs), len(seen)))
    z = [abs(a["frequency_hz"] - b["frequency_hz"]) / math.hypot(a["frequency_std_hz"], b["frequency_std_hz"]) for a, b in pairs]
    check("pyfrf record.h5: halves agree, median |z| below 1.3", pairs and statistics.median(z) < 1.3, "%.2f" % statistics.median(z or [math.nan]))


def check_pyfrf(data):
    folder = os.path.join(data, "pyfrf_5hits")
    known = [m for m in json.load(open(os.path.join(folder, "independent.json")))["modes"] if m["fit_residual"] < 0.12]
    # Each damping has three independent estimates. The tolerance is their pooled relative spread: the root mean square, over the
    # modes, of the relative standard deviation of the three. A damping must be within the tolerance of their median.
    three = [[m["zeta_lscf"], m["zeta_sdof"], m["zeta_hp"]] for m in known]
    spread = math.sqrt(statistics.mean(statistics.variance(z) / statistics.mean(z) ** 2 for z in three))
    for file in ("record.h5", "hit1.csv"):
        code, document = percuss("analyze", os.path.join(folder, file), "--band", "400:8000")
        check("pyfrf %s: every hit accepted" % file, code == 0 and document["hits"] and all(h["accepted"] for h in document["hits"]), "%d hits" % len(document["hits"]))
        if file == "record.h5":
            check_halves_of_hits(os.path.join(folder, file), document)
        for mode, zeta in zip(known, three):
            found = nearest(document, mode["f_sdof"])
            off = found["frequency_hz"] / mode["f_sdof"] - 1
            check("pyfrf %s: %.2f Hz within 0.07 %%" % (file, mode["f_sdof"]), abs(off) <= 7e-4, "%+.4f %%" % (100 * off))
            if file == "record.h5":
                off = found["damping_ratio"] / statistics.median(zeta) - 1
                check("pyfrf %s: %.2f Hz, damping within %.1f %% of the median" % (file, mode["f_sdof"], 100 * spread), abs(off) <= spread,
                      "%+.1f %% (%.6f; others %s)" % (100 * off, found["damping_ratio"], " ".join("%.6f" % z for z in zeta)))
    _, document = percuss("analyze", os.path.join(folder, "record.h5"), "--band", "100:8000", "--only", "frf,coherence")
    below = [c["fraction_below_0_9"] for c in document["coherence"]]
    check("pyfrf record.h5: coherence below 0.9 on less than 3 % of lines", below and max(below) < 0.03, "%.2f %%" % (100 * max(below, default=math.nan)))


def check_frame(data):
    folder = os.path.join(data, "frame3_50hz")
    scale = {}
    for file, published in (("imp_ham_calib_set2.CSV", 0.00684), ("Imp_ham_calib_set1.CSV", 0.01020)):
        _, document = percuss("calibrate", os.path.join(folder, file), "--mass", 1.25, "--force-channel", "CH8")
        scale[file] = document.get("force_scale", math.nan)
        off = abs(scale[file]) / published - 1
        check("frame3 %s: %.5f N per unit within 3 %%" % (file, published), abs(off) <= 0.03, "%.6f, %+.1f %%" % (scale[file], 100 * off))
    mean = sum(scale.values()) / len(scale)
    for file, sample in (("imp_ham_set1_nomass.CSV", 13), ("imp_ham_set2_nomass.CSV", 27), ("imp_ham_set3_no_mass.CSV", 5)):
        _, document = percuss("analyze", os.path.join(folder, file), "--force-channel", "CH8", "--force-scale=%.6f" % mean)
        onsets = [h["time_s"] * 50 for h in document["hits"] if h["accepted"]]
        # The peak is at this sample; the pulse, one sample wide, begins at most one and a half samples before it.
        check("frame3 %s: the one hit at sample %d" % (file, sample), len(onsets) == 1 and sample - 1.5 <= onsets[0] <= sample + 0.5, "onset %s" % ", ".join("%.2f" % o for o in onsets))
        for frequency in (2.16, 6.89, 13.24):
            found = nearest(document, frequency)["frequency_hz"]
            check("frame3 %s: %.2f Hz within 0.03 Hz" % (file, frequency), abs(found - frequency) <= 0.03, "%.4f Hz" % found)


def check_bad_hits(data, scratch):
    for case, wanted in (("case1", "late_trigger"), ("case2", "no_pulse")):
        mat = scipy.io.loadmat(os.path.join(data, "bad_hits_vt", case + ".mat"), squeeze_me=True)
        force, accel, fs = mat["Time_chan_1"], mat["Time_chan_2"], float(mat["Time_Sample_Rate"])
        path = os.path.join(scratch, case)
        with h5py.File(path + ".h5", "w") as file:
            file.attrs["fs"] = fs
            file["force"], file["accel"] = force[None], accel[None, None]
        columns = numpy.column_stack([numpy.arange(len(force)) / fs, force, accel])
        numpy.savetxt(path + ".csv", columns, delimiter=",", header="t_s,force_N,acc_m_s2", comments="", fmt="%.12g")
        named = ("--force-channel", "Time_chan_1", "--accel-channel", "Time_chan_2")
        for end, words in ((".h5", ()), (".csv", ()), (".mat", named)):
            file = os.path.join(data, "bad_hits_vt", case + end) if end == ".mat" else path + end
            code, document = percuss("analyze", file, *words)
            found = sorted({c for h in document["hits"] for c in codes(h)})
            check("bad hits %s%s: rejected as %s, exit 4" % (case, end, wanted),
                  code == 4 and wanted in found and not any(h["accepted"] for h in document["hits"]), "exit %d, %s" % (code, ", ".join(found)))


def check_plate(data):
    folder = os.path.join(data, "plate_9x9")
    # Modes that the independent fit describes well; its two methods differ by up to 0.02 % on them.
    known = [m for m in json.load(open(os.path.join(folder, "independent.json")))["modes_Ref_1"] if m["fit_residual"] < 0.05 and m["f_sdof"] < 600]
    code, document = percuss("analyze", os.path.join(folder, "00A_Ref_1.MAT"), "--df", 0.5, "--band", "40:600")
    check("plate: 81 FRFs of a MAT file", code == 0 and len(document["modes"]) >= 5, "%d modes" % len(document["modes"]))
    for mode in known:
        off = nearest(document, mode["f_sdof"])["frequency_hz"] / mode["f_sdof"] - 1
        check("plate: %.2f Hz within 0.02 %%" % mode["f_sdof"], abs(off) <= 2e-4, "%+.4f %%" % (100 * off))


def mac(a, b):
    inner = sum(x.conjugate() * y for x, y in zip(a, b))
    return abs(inner) ** 2 / (sum(abs(x) ** 2 for x in a) * sum(abs(y) ** 2 for y in b))


def check_modelab(data, scratch):
    folder = os.path.join(data, "modelab_beam")
    independent = json.load(open(os.path.join(folder, "independent.json")))
    files = [os.path.join(folder, "Hxysv0000%d.txt" % i) for i in range(1, 10)]
    setup = os.path.join(scratch, "setup.json")
    json.dump([{"name": "accel 1", "direction": "-x", "position_m": 0.5}], open(setup, "w"))
    code, document = percuss("analyze", *files, "--setup", setup)
    check("modelab: FRFs alone, no hits", code == 0 and document["hits"] == [] and len(document["inputs"]) == 9)
    # Noise and the suspension of the beam are below 65 Hz (setup.csv, fMin).
    found = [m["frequency_hz"] for m in document["modes"] if m["frequency_hz"] > 65]
    check("modelab: four modes and no others", len(found) == 4, " ".join("%.3f" % f for f in found))
    for mode, shape in zip(independent["modes"], independent["shapes_real"]):
        nearby = nearest(document, mode["f_sdof"])
        off = nearby["frequency_hz"] - round(mode["f_sdof"], 3)
        check("modelab: %.3f Hz within 10 mHz" % mode["f_sdof"], abs(off) <= 0.010, "%+.1f mHz" % (1000 * off))
        zetas = [mode["zeta_lscf"], mode["zeta_sdof"], mode["zeta_hp"]]
        zeta = nearby["damping_ratio"]
        check("modelab: %.3f Hz, damping within the independent spread" % mode["f_sdof"], min(zetas) <= zeta <= max(zetas), "%.3g of %.3g to %.3g" % (zeta, min(zetas), max(zetas)))
        residues = [complex(r["re"], r["im"]) for r in sorted(nearby.get("residues", []), key=lambda r: r["point"])]
        value = mac(residues, shape["shape"]) if len(residues) == 9 else 0
        check("modelab: %.3f Hz, MAC at least 0.98" % mode["f_sdof"], value >= 0.98, "%.4f" % value)
        # The set-up inverts the sign, so the driving point (the fourth) is positive.
        check("modelab: %.3f Hz, the driving point is positive" % mode["f_sdof"], len(residues) == 9 and residues[3].real > 0)


def check_r161(data):
    profile = os.path.join(data, "r161_profile", "r161.dat")
    code, document = percuss("model", "bat", "--profile", profile, "--profile-unit", "cm:mm", "--density", 649, "--young", 1.814e10, "--shear", 1.05e9)
    frequencies, nodes = document.get("frequency_hz", []), document.get("node_m", [])
    check("r161: at least five modes", code == 0 and len(frequencies) >= 5 and len(nodes) >= 5, "%d modes" % len(frequencies))
    for found, published, within in zip(frequencies, (165, 568, 1177, 1851, 2580), (6, 2.5, 1, 1, 1)):
        off = 100 * (found / published - 1)
        check("r161: %d Hz (Nathan 2000, Table II) within %g %%" % (published, within), abs(off) <= within, "%.2f Hz, %+.2f %%" % (found, off))
    for found, published in zip(nodes, ((17, 68), (7, 39, 72), (5, 25, 50, 74))):
        # The source prints whole centimetres, for a bat 1.8 % heavier than this profile.
        near = len(found) == len(published) and all(abs(100 * f - p) <= 1 for f, p in zip(found, published))
        check("r161: nodes at %s cm" % (published,), near, " ".join("%.1f" % (100 * f) for f in found))
    for found, published_in in zip(nodes, (6.5, 4.9)):
        from_end_in = (document["length_m"] - found[-1]) / 0.0254
        check("r161: outer node near %.1f in from the barrel's end" % published_in, abs(from_end_in - published_in) <= 0.1, "%.2f in" % from_end_in)


def check_long(name, truth, path):
    _, document = percuss("analyze", path, "--only", "hits")
    hits = document["hits"]
    pairs, extra = [], list(hits)
    for time, flag, delay in zip(truth["hit_time_s"], truth["hit_flag"], truth["second_hit_delay_s"]):
        hit = min(extra, key=lambda h: abs(h["time_s"] - time), default=None)
        if hit is not None and abs(hit["time_s"] - time) <= 1e-3:
            extra.remove(hit)
            pairs.append((hit, flag, delay))
    worst = max((min(abs(h["time_s"] - t) for h in hits) for t in truth["hit_time_s"]), default=math.nan) if hits else math.nan
    check(name + ": every hit found within 1 ms", len(pairs) == len(truth["hit_time_s"]), "%d of %d, worst %.3f ms" % (len(pairs), len(truth["hit_time_s"]), 1e3 * worst))
    check(name + ": no false hit", not extra, "%d" % len(extra))
    doubles = [(h, d) for h, flag, d in pairs if flag == "double"]
    delays = [abs(f["delay_s"] - d) for h, d in doubles for f in h["findings"] if f["code"] == "double_hit"]
    check(name + ": double hits rejected, delay within 1 ms", len(delays) == len(doubles) and max(delays, default=0) <= 1e-3 and not any(h["accepted"] for h, _ in doubles),
          "%d of %d, worst %.3f ms" % (len(delays), len(doubles), 1e3 * max(delays, default=0)))
    weak = [h for h, flag, _ in pairs if flag == "weak"]
    check(name + ": weak hits flagged, not rejected", all("weak" in codes(h) and h["accepted"] for h in weak), "%d" % len(weak))
    good = [h for h, flag, _ in pairs if flag == "good"]
    check(name + ": good hits accepted", all(h["accepted"] for h in good), "%d of %d" % (sum(h["accepted"] for h in good), len(good)))


def separated(truth, i):
    """Whether a mode is more than three half-power bandwidths (of the wider mode) from every other mode."""
    width = [2 * z * f for f, z in zip(truth["f_hz"], truth["zeta"])]
    return all(abs(f - truth["f_hz"][i]) > 3 * max(width[i], w) for j, (f, w) in enumerate(zip(truth["f_hz"], width)) if j != i)


def check_modes(name, truth, path, score):
    low, high = truth["band_hz"]
    code, document = percuss("analyze", path, "--band", "%g:%g" % (low, high))
    scored = score.score_one(truth, document)
    rows = {row["true_hz"]: row for row in scored["modes"]}
    wanted = [rows[f] for i, f in enumerate(truth["f_hz"]) if truth["in_band"][i] and separated(truth, i) and rows[f]["asked"]]
    check(name + ": every separated mode found", code == 0 and wanted and all(r["found"] for r in wanted), "%d of %d" % (sum(r["found"] for r in wanted), len(wanted)))
    found = [r for r in wanted if r["found"]]
    worst = max((abs(r["f_ppm"]) for r in found), default=math.nan)
    check(name + ": frequencies within 200 ppm", worst <= 200, "%.2f ppm" % worst)
    worst = max((abs(r["zeta_pct"]) for r in found), default=math.nan)
    check(name + ": damping within 3 %", worst <= 3, "%.3f %%" % worst)
    wrong = ["%.0f Hz: %s" % (r["true_hz"], r["family"]) for r in found if not r["family_ok"]]
    check(name + ": mode types right", not wrong, "; ".join(wrong))
    check(name + ": no spurious modes", not scored["spurious"], " ".join("%.1f Hz" % f for f in scored["spurious"]))


def check_truncated(name, truth, path, score):
    low, high = truth["band_hz"]
    _, document = percuss("analyze", path, "--band", "%g:%g" % (low, high))
    cut = [h for h in document["hits"] if "truncated_decay" in codes(h)]
    check(name + ": truncated_decay on every hit", document["hits"] and len(cut) == len(document["hits"]), "%d of %d" % (len(cut), len(document["hits"])))
    _, got, _ = score.pair(truth, document["modes"])
    errors = []
    for i, k in got.items():
        mode, zeta = document["modes"][k], truth["zeta"][i]
        errors.append(abs(mode["damping_ratio"] - zeta) / (mode["damping_ratio_std"] + ROUNDING * zeta / FEW_SIGMA))
    check(name + ": damping errors within %.1f reported standard deviations" % FEW_SIGMA, errors and max(errors) <= FEW_SIGMA, "%d modes, worst %.2f" % (len(errors), max(errors, default=math.nan)))


def check_deflection(name, truth, path):
    corner = truth["highpass_corner_hz"]
    code, document = percuss("deflect", path, "--highpass-corner", corner)
    hits, peaks = document["hits"], truth["peak_deflection_m"]
    check(name + ": every impact has a deflection", code == 0 and len(hits) == len(peaks), "%d hits" % len(hits))
    if len(hits) != len(peaks):
        return
    off = [100 * (h["peak_m"] / p - 1) for h, p in zip(hits, peaks)]
    if corner == 0:
        check(name + ": every peak within 0.1 %", max(map(abs, off)) <= 0.1, "worst %.2g %%" % max(off, key=abs))
        return
    large = [o for o, p in zip(off, peaks) if p > 0.005]
    check(name + ": peaks above 5 mm within 1 %", large and max(map(abs, large)) <= 1, "%d of %d, worst %.2g %%" % (len(large), len(off), max(large, key=abs)))
    deviations = [abs(h["peak_m"] - p) / h["peak_std_m"] for h, p in zip(hits, peaks)]
    check(name + ": every peak within 3 reported standard deviations", max(deviations) <= 3, "worst %.2f" % max(deviations))


def check_seed(seed, arguments, scratch, score):
    names = ["c1_clean", "c2_light", "c3_doublet", "c4_noise", "c6_short", "l1_long", "d1_clean", "d2_real"]
    folder = os.path.join(arguments.cases or scratch, "s%d" % seed)
    if not arguments.cases:
        maker = os.path.join(arguments.shared, "cases", "make_cases.py")
        subprocess.run([sys.executable, "-B", maker, folder, "--seed", str(seed), "--only", ",".join(names), "--no-csv"], check=True, stdout=subprocess.DEVNULL)
    for case in names:
        truth = json.load(open(os.path.join(folder, case, "truth.json")))
        path, name = os.path.join(folder, case, "data.h5"), "seed %d %s" % (seed, case)
        if case == "l1_long":
            check_long(name, truth, path)
        elif case in ("d1_clean", "d2_real"):
            check_deflection(name, truth, path)
        elif case in ("c2_light", "c6_short"):
            check_truncated(name, truth, path, score)
        else:
            check_modes(name, truth, path, score)
    if not arguments.cases:
        shutil.rmtree(folder)


def main():
    parser = argparse.ArgumentParser(prog=".ci/check-shared")
    parser.add_argument("--seeds", default="0,1,2,3,4,5")
    parser.add_argument("--cases")
    parser.add_argument("shared")
    arguments = parser.parse_args()
    spec = importlib.util.spec_from_file_location("score", os.path.join(arguments.shared, "cases", "score.py"))
    score = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(score)
    data = os.path.join(arguments.shared, "data")
    with tempfile.TemporaryDirectory(prefix="percuss-check-") as scratch:
        check_pyfrf(data)
        check_frame(data)
        check_bad_hits(data, scratch)
        check_modelab(data, scratch)
        check_r161(data)
        check_plate(data)
        for seed in map(int, arguments.seeds.split(",")):
            check_seed(seed, arguments, scratch, score)
    print("%d passed, %d failed" % (sum(results), len(results) - sum(results)))
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
