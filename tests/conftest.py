"""What several tests need: folders of their own to generate and compile in, and the model's functions."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parent.parent
PENDULUM = f"{ROOT / 'tests' / 'pendulum.py'}:PENDULUM"


@pytest.fixture(scope="session")
def compiled_once(tmp_path_factory):
    """A cache of compiled libraries for the whole run, beside the user's own; workers side by side share it."""
    before, base = os.environ.get("BORESIGHT_CACHE"), tmp_path_factory.getbasetemp()
    os.environ["BORESIGHT_CACHE"] = str((base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "cache")
    yield
    if before is None:
        del os.environ["BORESIGHT_CACHE"]
    else:
        os.environ["BORESIGHT_CACHE"] = before


@pytest.fixture(autouse=True)
def _cache(compiled_once):
    """Every test compiles into the run's own cache."""


@pytest.fixture(scope="session")
def library(compiled_once):
    from boresight.runtime.library import load

    return load("euler-matching")


@pytest.fixture(scope="session")
def pendulum_folder(compiled_once, tmp_path_factory):
    from boresight.codegen.generate import generate

    folder = tmp_path_factory.mktemp("generated") / "pendulum"
    generate(PENDULUM, folder)
    return folder


@pytest.fixture(scope="session")
def radar_folder(compiled_once, tmp_path_factory):
    from boresight.codegen.generate import generate

    folder = tmp_path_factory.mktemp("generated") / "radar"
    generate(f"{ROOT / 'tests' / 'radar.py'}:RADAR", folder)
    return folder


@pytest.fixture
def em_copy(tmp_path):
    """A copy of the generated folder, to be spoilt."""
    return Path(shutil.copytree(ROOT / "generated" / "euler_matching", tmp_path / "euler_matching"))


@pytest.fixture
def checkout(tmp_path):
    """A copy of the sources, to be edited, and a way to run the command line in it."""
    copy = tmp_path / "checkout"
    copy.mkdir()
    for name in ("boresight", "derive", "codegen", "runtime", "studies", "generated"):
        shutil.copytree(ROOT / name, copy / name, symlinks=True, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", copy)

    def run(*words, **more):
        env = {**os.environ, "BORESIGHT_CACHE": str(tmp_path / "cache"), **more}
        command = [sys.executable, "-m", "boresight.cli", *words]
        return subprocess.run(command, cwd=copy, env=env, capture_output=True, text=True, check=False)

    return copy, run


@pytest.fixture
def points():
    """Random inputs of the Euler-matching functions, well inside the box, for 40 runs."""
    rng = np.random.default_rng(20)

    def vectors(scale):
        return rng.uniform(-scale, scale, (40, 3))

    q = rng.standard_normal((40, 4))
    q[:, 0] += 3  # keeps the pitch away from 90 deg
    return {
        "x": np.hstack([vectors(0.05), vectors(0.05)]),
        "q_b2n_wxyz": q / np.linalg.norm(q, axis=1, keepdims=True),
        "mu": vectors(0.1),
        "dtheta_ib_b": vectors(0.1),
        "omega_in_n": vectors(1e-4),
        "dt": rng.uniform(0.01, 1, 40),
        "gyro_noise": rng.uniform(0, 1e-3, (40, 3)),
        "euler_b": vectors(1.0),
        "euler_m": vectors(1.0),
    }


@pytest.fixture
def many_digits():
    """As the ledgers compute."""
    from boresight.derive.ledger.evaluate import DIGITS
    from boresight.derive.ledger.numbers import digits

    with digits(DIGITS):
        yield
