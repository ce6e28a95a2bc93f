"""The checks of .ci/interop."""
import json
import os
import subprocess
import sys
import tempfile

import h5py
import numpy as np
import scipy.io
import scipy.io.wavfile

PERCUSS = os.environ["PERCUSS"]
results = []


def check(name, passed):
    results.append(bool(passed))
    print("%-6s %s" % ("ok" if passed else "FAILED", name))


def percuss(*words):
    done = subprocess.run([PERCUSS, *words], capture_output=True, text=True)
    if done.returncode != 0:
        print(done.stderr, end="")
    return done


def described(path, *words):
    done = percuss("info", "--json", path, *words)
    return json.loads(done.stdout)["files"][0] if done.returncode == 0 else {}


def same_samples(path, force, accel, scratch, *words):
    """Whether percuss reads exactly these samples: it converts the file to HDF5, which h5py opens."""
    out = os.path.join(scratch, "seen.h5")
    if percuss("convert", path, out, "--force", *words).returncode != 0:
        return False
    with h5py.File(out) as seen:
        return np.array_equal(np.squeeze(seen["force"][()]), np.squeeze(force)) and np.array_equal(
            np.squeeze(seen["accel"][()]), np.squeeze(accel)) and seen.attrs["fs"] == 1000.0


def octave(code):
    done = subprocess.run(["octave-cli", "--quiet", "--no-init-file", "--eval", code], capture_output=True, text=True)
    if done.returncode != 0:
        print(done.stderr, end="")
    return done


def main():
    random = np.random.default_rng(1)
    force = random.normal(size=(3, 200))
    accel = random.normal(size=(3, 2, 200))
    frf = random.normal(size=(4, 2, 50)) + 1j * random.normal(size=(4, 2, 50))
    with tempfile.TemporaryDirectory() as scratch:
        at = lambda name: os.path.join(scratch, name)

        # Files of other software, read by percuss.
        with h5py.File(at("h5py.h5"), "w") as file:
            file.attrs["fs"] = 1000.0
            file["force"] = force
            file["accel"] = accel
        check("h5py writes a record, percuss reads it", same_samples(at("h5py.h5"), force, accel, scratch))
        for compressed in (False, True):
            scipy.io.savemat(at("scipy.mat"), {"fs": 1000.0, "force": force, "accel": accel}, do_compression=compressed)
            check("SciPy writes level 5%s, percuss reads it" % (" compressed" if compressed else ""),
                  same_samples(at("scipy.mat"), force, accel, scratch))
        scipy.io.savemat(at("v4.mat"), {"fs": 1000.0, "force": force[0], "accel": accel[0].T}, format="4")
        check("SciPy writes level 4, percuss reads it", same_samples(at("v4.mat"), force[0], accel[0], scratch))
        scipy.io.savemat(at("struct.mat"), {"test": {"fs": 1000.0, "force": force, "accel": accel}})
        check("SciPy writes a structure, percuss reads it", same_samples(at("struct.mat"), force, accel, scratch))
        scipy.io.savemat(at("frf.mat"), {"frf": frf, "frequency_hz": 2.0 * np.arange(1, 51)})
        seen = described(at("frf.mat"))
        check("SciPy writes FRFs, percuss reads them",
              (seen.get("points"), seen.get("lines"), seen.get("df_hz")) == (4, 50, 2.0))

        # Files of percuss, read by other software; the record was written by h5py.
        percuss("convert", at("h5py.h5"), at("ours.mat"))
        ours = scipy.io.loadmat(at("ours.mat"))
        check("percuss writes MAT, SciPy reads it", np.array_equal(ours["force"], force) and np.array_equal(
            ours["accel"], accel) and ours["fs"].item() == 1000.0 and ours["accel_unit"].item() == "m/s^2")
        percuss("convert", at("ours.mat"), at("ours.h5"))
        with h5py.File(at("ours.h5")) as file:
            check("percuss writes HDF5, h5py reads it",
                  np.array_equal(file["force"][()], force) and np.array_equal(file["accel"][()], accel))
        percuss("convert", at("ours.mat"), at("ours.uff"))
        check("a universal file keeps every sample", same_samples(at("ours.uff"), force, accel, scratch))
        percuss("convert", at("frf.mat"), at("frf.h5"), "--quiet")
        percuss("convert", at("frf.mat"), at("again.mat"), "--quiet")
        with h5py.File(at("frf.h5")) as file:
            check("percuss writes FRFs as HDF5, h5py reads them", np.array_equal(file["frf"][()], frf))
        check("percuss writes FRFs as MAT, SciPy reads them",
              np.array_equal(scipy.io.loadmat(at("again.mat"))["frf"], frf))

        # Sound files of SciPy and SoX in both directions. The samples have 16 bits, so every format holds them exactly.
        # The hammer is on the first channel.
        steps = random.integers(-2**15, 2**15, size=(200, 3))
        roles = ("--force-channel", "1", "--accel-channel", "2,3")
        parts = steps / 2.0**15
        scipy.io.wavfile.write(at("scipy.wav"), 1000, steps.astype(np.int16))
        check("SciPy writes a WAV file, percuss reads it",
              same_samples(at("scipy.wav"), parts[:, 0], parts[:, 1:].T, scratch, *roles))
        for kind, more in (("wav", ["-b", "24"]), ("wav", ["-e", "float"]), ("w64", [])):
            subprocess.run(["sox", at("scipy.wav"), *more, at("sox." + kind)], check=True)
            check("SoX writes %s %s, percuss reads it" % (kind.upper(), " ".join(more)),
                  same_samples(at("sox." + kind), parts[:, 0], parts[:, 1:].T, scratch, *roles))
        percuss("convert", at("scipy.wav"), at("parts.h5"), *roles)
        percuss("convert", at("parts.h5"), at("ours.wav"))
        rate, seen = scipy.io.wavfile.read(at("ours.wav"))
        check("percuss writes a WAV file, SciPy reads it", rate == 1000 and np.array_equal(seen, parts))
        subprocess.run(["sox", "-D", at("ours.wav"), "-b", "16", at("back.wav")], check=True)
        check("percuss writes a WAV file, SoX reads it",
              np.array_equal(scipy.io.wavfile.read(at("back.wav"))[1], steps))
        # SoX takes the floating-point samples of a W64 file as 32-bit integers: they are scaled by 2^31.
        percuss("convert", at("scipy.wav"), at("ours.w64"), "--quiet", *roles, "--force-scale", str(2**31), "--accel-scale", str(2**31))
        subprocess.run(["sox", "-D", at("ours.w64"), "-b", "16", at("back.wav")], check=True)
        check("percuss writes a W64 file, SoX reads it", np.array_equal(scipy.io.wavfile.read(at("back.wav"))[1], steps))

        # Octave in both directions.
        for level in ("-v7", "-v6", "-v4"):
            octave("load('%s'); force = force(1, :); accel = squeeze(accel(1, :, :)); save('%s', '%s', 'fs', 'force', 'accel');"
                   % (at("ours.mat"), level, at("octave.mat")))
            check("Octave reads percuss's MAT and writes %s, percuss reads that" % level,
                  same_samples(at("octave.mat"), force[0], accel[0], scratch))
    print("%d passed, %d failed" % (sum(results), len(results) - sum(results)))
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
