"""What is installed from a wheel, built from an sdist, works away from the checkout, and with as little as it needs."""

import importlib.metadata
import os
import re
import subprocess
import sys
import tarfile
import tomllib
import venv
import zipfile

import pytest
from conftest import ROOT
from tools import tool

from boresight.errors import EXTRAS


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The sdist, the wheel made from it, and the wheel unpacked."""
    # only what git would hand out: a checkout may hold much else
    tmp_path = tmp_path_factory.mktemp("built")
    tree = tmp_path / "tree"
    tree.mkdir()
    listed = subprocess.run([tool("git"), "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True)
    for name in filter(None, listed.stdout.split("\0")):
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        if (ROOT / name).is_symlink():
            (tree / name).symlink_to(os.readlink(ROOT / name))
        elif (ROOT / name).is_file():
            (tree / name).write_bytes((ROOT / name).read_bytes())
    subprocess.run(
        [sys.executable, "-m", "build", "--outdir", str(tmp_path / "dist"), str(tree)], check=True, capture_output=True
    )
    (sdist,) = (tmp_path / "dist").glob("*.tar.gz")
    (wheel,) = (tmp_path / "dist").glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path / "site")
    return sdist, wheel, tmp_path / "site"


@pytest.fixture(scope="module")
def bare(built, tmp_path_factory):
    """The Python of an environment with the wheel and the packages that it requires, and none of any extra."""
    folder = tmp_path_factory.mktemp("bare")
    venv.create(folder, with_pip=False)
    (site,) = folder.glob("lib/python*/site-packages")
    for path in built[2].iterdir():
        (site / path.name).symlink_to(path)
    for name in required(built[2]):
        for root in {file.parts[0] for file in importlib.metadata.files(name) or () if file.parts[0] != ".."}:
            (site / root).symlink_to(importlib.metadata.distribution(name).locate_file(root))

    def run(*words):
        # away from the checkout, and without the path of the tests
        env = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
        command = [folder / "bin" / "python", *words]
        return subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True, check=False)

    return run


def required(site):
    """Names of what the wheel requires without any extra."""
    (metadata,) = site.glob("*.dist-info/METADATA")
    lines = re.findall(r"^Requires-Dist: (.*)$", metadata.read_text(), re.MULTILINE)
    return [re.match(r"[\w-]+", line).group() for line in lines if "extra ==" not in line]


def test_sdist_and_wheel_hold_the_package_and_an_installed_one_flies(built, tmp_path):
    sdist, wheel, site = built
    wanted = (
        "generated/euler_matching/manifest.json", "generated/euler_matching/CMakeLists.txt",
        "generated/euler_matching/src/em_euler_H_kernel.h", "codegen/templates/src/UNIT.c.j2", "derive/model.py",
        "codegen/templates/src/stationary_detector.c.j2", "derive/pages/templates/page.html.j2",
        "generated/stationary_detector/src/stationary_detector.c",
        "runtime/recording/built_in/fog_mems_transfer.toml", "runtime/recording/built_in/template.toml",
        "studies/euler_table/table.py",
        "examples/pendulum.py", "examples/fly_gnss_ins.py", "cli.py", "py.typed",
    )  # fmt: skip
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    assert {f"boresight/{name}" for name in wanted} <= names
    assert {name.split("/")[0] for name in names} <= {
        "boresight",
        next(n.split("/")[0] for n in names if "dist-info" in n),
    }
    with tarfile.open(sdist) as archive:
        inside = {name.split("/", 1)[-1] for name in archive.getnames()}
    assert {f"boresight/{name}" for name in wanted} <= inside

    code = (
        "import boresight, numpy as np; from boresight.runtime.library import load; "
        f"assert boresight.__file__.startswith({str(site)!r}); load('euler-matching').F(omega_in_n=np.zeros(3)); "
        "from boresight.codegen.generate import default_folder; "
        "assert str(default_folder('euler-matching')) == 'generated/euler_matching'; "
        "from boresight.codegen.new import new; from pathlib import Path; new('mine', 'ins', Path())"
    )
    env = {**os.environ, "PYTHONPATH": str(site)}
    subprocess.run([sys.executable, "-c", code], cwd=tmp_path, env=env, check=True)
    assert (tmp_path / "mine.py").is_file() and (tmp_path / "fly_mine.py").is_file()


def test_the_base_flies_alone(built, bare):
    assert set(required(built[2])) == {"numpy", "scipy", "platformdirs"}
    (example,) = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
    done = bare("-c", example + "\nassert 'site-packages' in __import__('boresight').__file__")
    assert done.returncode == 0, done.stderr
    studies = "from boresight.studies.euler_table import table; "
    done = bare("-c", studies + "print(table.run(table.Scenario(runs=1, seconds=2))['cells'])")
    assert done.stdout == "147\n", done.stderr


@pytest.mark.parametrize(
    ("extra", "code"),
    [
        ("derive", "import boresight.derive.model"),
        ("derive", "import boresight.codegen.generate"),
        ("replay", "from boresight.runtime.recording import read; read('drive.toml')"),
        ("replay", "from boresight.studies.figures import figure; figure('a.png', 3, 3).__enter__()"),
    ],
)
def test_a_layer_without_its_extra_says_in_one_line_what_to_install(bare, extra, code):
    done = bare("-c", code)
    assert done.returncode == 1
    last = done.stderr.strip().splitlines()[-1]
    assert last.startswith("boresight.BoresightError: ") and f"pip install 'boresight[{extra}]'" in last


def test_the_command_line_without_its_packages_says_in_one_line_what_to_install(bare):
    done = bare("-m", "boresight.cli", "models")
    assert done.returncode == 1 and done.stdout == ""
    assert done.stderr.count("\n") == 1 and "pip install 'boresight[cli]'" in done.stderr


# modules that ask for an extra as they are imported
FOUND_AGAIN = ("boresight.derive", "boresight.codegen", "boresight.runtime.cluster")


@pytest.mark.parametrize(
    ("words", "extra"),
    [
        ("generate examples/own_model.py:TANK", "derive"),
        ("verify strapdown", "derive"),
        ("equations", "derive"),
        ("show kang-2025", "derive"),
        ("export euler-matching -o out", "derive"),
        ("replay drive.csv", "replay"),
        ("study euler-table -o out", "replay"),
        ("many -o out", "parquet"),
        ("many --runs 1 --dask tcp://127.0.0.1:1", "cluster"),
    ],
)
def test_a_command_without_its_extra_says_in_one_line_what_to_install(monkeypatch, capsys, tmp_path, words, extra):
    from boresight import cli

    monkeypatch.chdir(tmp_path)
    for name in [name for name in sys.modules if name.startswith(FOUND_AGAIN)]:
        monkeypatch.delitem(sys.modules, name)
    for name in set(EXTRAS[extra]) - {"pydantic"}:  # which typer may bring
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(SystemExit) as ended:
        cli.main(words.split())
    out, err = capsys.readouterr()
    assert ended.value.code == 1 and out == ""
    assert err.count("\n") == 1 and f"pip install 'boresight[{extra}]'" in err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("ending", "module", "extra"),
    [
        ("parquet", "pyarrow", "parquet"),
        ("xlsx", "openpyxl", "excel"),
        ("h5", "h5py", "hdf5"),
        ("ulg", "pyulog", "ulog"),
        ("bin", "pymavlink", "ardupilot"),
        ("bag", "rosbags", "ros"),
    ],
)
def test_a_file_whose_extra_is_missing_says_what_to_install(monkeypatch, tmp_path, ending, module, extra):
    from boresight import BoresightError
    from boresight.runtime.recording.tables import table

    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(BoresightError, match=rf"boresight\[{extra}\]"):
        table(tmp_path / f"a.{ending}")


def test_every_module_of_an_extra_is_named_in_it():
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    project = {"flint": "python-flint", "markdown_it": "markdown-it-py"}
    for extra, modules in EXTRAS.items():
        assert {re.match(r"[\w-]+", line).group() for line in extras[extra]} == {project.get(m, m) for m in modules}
    (everything,) = extras["all"]
    assert set(re.fullmatch(r"boresight\[(.*)\]", everything).group(1).split(",")) == set(EXTRAS)


def test_the_layers_import_nothing_that_their_extra_does_not_bring():
    """What a layer imports, at any depth, is the standard library, the base, or of its own extra."""
    from test_imports import files, imported

    formats = ("parquet", "excel", "hdf5", "ulog", "ardupilot", "ros", "cluster")
    allowed = {
        "derive": ("derive",), "codegen": ("derive",), "runtime": ("replay", *formats), "studies": ("replay",)
    }  # fmt: skip
    for layer, extras in allowed.items():
        known = {"numpy", "scipy", "platformdirs", "boresight"} | {m for extra in extras for m in EXTRAS[extra]}
        for path in files(layer):
            for name in imported(path):
                assert name.split(".")[0] in known | set(sys.stdlib_module_names), f"{path} imports {name}"
