"""What several tests need: folders of their own to generate and compile in, and the model's functions."""

import functools
import gc
import hashlib
import os
import re
import shutil
import subprocess
import sys
import threading
from contextlib import contextmanager
from fcntl import LOCK_EX, flock
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices: a second thread waits, and costs what it waits

import numpy as np
import pytest
from xdist.scheduler import LoadFileScheduling

gc.set_threshold(50_000, 20, 100)  # expressions live as long as a file of tests: to look through them costs a twelfth
pytest_plugins = ("tools",)
ROOT = Path(__file__).parent.parent
LEDGERS = ("tests/test_cli.py", "tests/test_kept_ledger.py", "tests/test_notebook.py")  # beside tests/derive
# flags that write files beside the object
BESIDE = ("--coverage", "-g", "-M", "-fstack-usage", "-fcallgraph-info", "-save-temps")
PENDULUM = f"{ROOT / 'tests' / 'pendulum.py'}:PENDULUM"


def pytest_collection_modifyitems(items):
    """The dearest files first, so that at the end no processor waits for one.

    tests/costs.txt is what `python tests/costs.py FILE | grep tests/` prints, and need not be fresh.
    """
    rows = (line.split(maxsplit=1) for line in (ROOT / "tests" / "costs.txt").read_text().splitlines())
    seconds = {name: float(cost) for cost, name in rows}
    items.sort(key=lambda item: -seconds.get(item.nodeid.split("::")[0], 0.0))


class BySubject(LoadFileScheduling):
    """A worker takes a file of tests at a time, in the order of the collection, so that what a file shares is made
    once; and all that computes ledgers, each of which takes up to half a minute, is one file to it."""

    def _split_scope(self, nodeid):
        path = super()._split_scope(nodeid)
        return "ledgers" if path.startswith("tests/derive/") or path in LEDGERS else path


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    config.option.loadscopereorder = False
    return BySubject(config, log)


@pytest.fixture(scope="session")
def run_folder(tmp_path_factory):
    """A folder for the whole run, which workers side by side share."""
    base = tmp_path_factory.getbasetemp()
    return base.parent if "PYTEST_XDIST_WORKER" in os.environ else base


@pytest.fixture(scope="session")
def compiled_once(run_folder):
    """Caches of compiled libraries and of their objects for the whole run, beside the user's own.

    The objects are for folders that differ in a file or two, as spoilt ones do: what is the same is compiled once.
    """
    from boresight.runtime import compiler

    kept = Objects(run_folder / "objects", compiler.run)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("BORESIGHT_CACHE", str(run_folder / "cache"))
        patch.setattr(compiler, "run", kept.run)
        patch.setattr(compiler, "compile_sources", functools.partial(together, compiler.compile_sources))
        yield


def together(compile_sources, command, sources, out):
    """`compiler.compile_sources` that compiles the printed units of a folder as one text, whose headers are read once.

    Not where they are optimised, so that no function is put into another.  What stands alone has helpers or macros
    whose names others have too.  tests/codegen/test_c_build.py holds that each file compiles by itself.
    """
    alone = re.compile(r"_(filter|live|covariance|digest)$")
    printed = [path for path, more in sources.items() if path.parent.name == "src" and not more]
    units = [path for path in printed if not alone.search(path.stem)]
    words = [str(word) for word in command]
    plain = [word for word in words if word.startswith("-O")][-1:] == ["-O0"]
    of_one = len(units) > 1 and len({path.parent for path in units}) == 1
    if not (plain and of_one) or any(word.startswith(BESIDE) for word in words):
        return compile_sources(command, sources, out)
    text = out / "units.c"
    text.write_text("".join(path.read_text() for path in units))
    rest = {path: more for path, more in sources.items() if path not in units}
    return compile_sources([*command, "-I", units[0].parent], {text: (), **rest}, out)


class Objects:
    """`compiler.run` that compiles no source twice by one command with the same headers."""

    def __init__(self, folder, run):
        self.folder, self._run = folder, run
        folder.mkdir(exist_ok=True)

    def run(self, command, cwd=None):
        words = [str(word) for word in command]
        elsewhere = ("-I/", "-I.", "-isystem", "-iquote")  # headers that are not looked for below
        known = "-c" in words and "-o" in words and words[words.index("-c") + 1].endswith(".c")
        if cwd or not known or any(word.startswith(BESIDE + elsewhere) for word in words):
            return self._run(words, cwd)
        key, headers, out = hashlib.sha256(), set(), Path(words[words.index("-o") + 1])
        for before, word in zip(["", *words], words, strict=False):
            if before in ("-c", "-include"):
                key.update(Path(word).read_bytes())
                headers |= {*Path(word).parent.glob("*.h")}
            elif before == "-I":
                headers |= {*Path(word).rglob("*.h")}
            elif before != "-o":
                key.update(word.encode() + b"\0")
        for header in sorted(headers, key=lambda path: (path.name, str(path))):
            key.update(header.name.encode() + b"\0" + header.read_bytes())
        kept = self.folder / key.hexdigest()
        if kept.exists():
            shutil.copy(kept, out)
            return ""
        printed = self._run(words)
        aside = kept.with_suffix(f".{os.getpid()}-{threading.get_ident()}")
        shutil.copy(out, aside)
        aside.replace(kept)
        return printed


@pytest.fixture(scope="module", autouse=True)
def quickly():
    """C without optimisation, which is compiled in a fraction of the time and has the same bits; the flags that ship.

    `test_c_as_it_ships_has_the_bits_of_c_without_optimisation` of tests/runtime/test_lanes.py holds that it does.
    """
    from boresight.runtime import compiler

    def plain(flags):
        return tuple(flag for flag in flags if not flag.startswith("-O"))

    shipped = compiler.FLAGS, compiler.LANES
    with optimised((*plain(compiler.FLAGS), "-O0"), plain(compiler.LANES)):
        yield shipped


@contextmanager
def optimised(flags, lanes):
    from boresight.runtime import compiler

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiler, "FLAGS", flags)
        patch.setattr(compiler, "LANES", lanes)
        compiler.in_lanes.cache_clear()
        yield
    compiler.in_lanes.cache_clear()


@pytest.fixture(autouse=True)
def _cache(compiled_once):
    """Every test compiles into the run's own cache."""


@pytest.fixture(scope="session")
def library(compiled_once):
    from boresight.runtime.library import load

    return load("euler-matching")


@pytest.fixture(scope="session")
def folder_of(compiled_once, run_folder):
    """The folder of a model, FILE.py:NAME: it is generated once in a run, by whichever worker is first."""
    from boresight.codegen.generate import generate

    def folder(target):
        path, name = target.rsplit(":", 1)
        made = run_folder / "generated" / f"{Path(path).parent.name}_{Path(path).stem}_{name}"
        made.parent.mkdir(exist_ok=True)
        with made.with_suffix(".lock").open("w") as lock:
            flock(lock, LOCK_EX)
            if not made.is_dir():
                generate(target, made)
        return made

    return folder


@pytest.fixture(scope="session")
def pendulum_folder(folder_of):
    return folder_of(PENDULUM)


@pytest.fixture(scope="session")
def radar_folder(folder_of):
    return folder_of(f"{ROOT / 'tests' / 'radar.py'}:RADAR")


@pytest.fixture
def em_copy(tmp_path):
    """A copy of the generated folder, to be spoilt."""
    return Path(shutil.copytree(ROOT / "generated" / "euler_matching", tmp_path / "euler_matching"))


@pytest.fixture
def sd_copy(tmp_path):
    """The same of a small folder."""
    return Path(shutil.copytree(ROOT / "generated" / "strapdown", tmp_path / "strapdown"))


@pytest.fixture
def checkout(tmp_path):
    """A copy of the sources, to be edited, and a way to run the command line in it."""
    copy = tmp_path / "checkout"
    copy.mkdir()
    for name in ("boresight", "derive", "codegen", "runtime", "analysis", "studies", "generated"):
        shutil.copytree(ROOT / name, copy / name, symlinks=True, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", copy)

    def run(*words, **more):
        env = {**os.environ, **more}
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
