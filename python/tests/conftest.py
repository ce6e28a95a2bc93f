"""Fixtures. PERCUSS is the path of the tool, PYTHONPATH the folder that holds the package."""

import json
import os
import pathlib
import re
import subprocess

import pytest

import percuss

SOURCE = pathlib.Path(__file__).resolve().parents[2]
KEYWORDS = {"from": "from_"}  # the other keywords are the names of the options
TOOL = pathlib.Path(os.environ.get("PERCUSS", pathlib.Path(percuss.__file__).parents[2] / "tools" / "percuss"))


class Tool:
    """Runs the command line in a folder."""

    def __init__(self, folder):
        self.folder = folder

    def __call__(self, *words):
        return subprocess.run([TOOL, *map(str, words)], cwd=self.folder, capture_output=True, text=True, check=False)

    def document(self, *words):
        """The output of --json as text."""
        ran = self(*words, "--json")
        assert ran.stdout, ran.stderr
        json.loads(ran.stdout)
        return ran.stdout

    def error(self, *words):
        """The error message, without the name of the program and with keywords in place of flags."""
        ran = self(*words, "--json")
        assert ran.returncode in (2, 3, 4), ran
        assert ran.stderr.startswith("percuss: ") and ran.stderr.count("\n") == 1, ran.stderr
        return in_keywords(ran.stderr.removeprefix("percuss: ").rstrip("\n"))


def in_keywords(message):
    """The message with `band=` in place of `--band`."""
    return re.sub(r"--([a-z][a-z0-9-]*)", lambda flag: KEYWORDS.get(flag[1], flag[1].replace("-", "_")) + "=", message)


@pytest.fixture
def tool(tmp_path, monkeypatch):
    """The command line in an empty folder, which is also the current folder of Python."""
    monkeypatch.chdir(tmp_path)
    return Tool(tmp_path)


@pytest.fixture(scope="session")
def bat():
    """A synthetic test in memory."""
    return percuss.synth("wood-bat")
