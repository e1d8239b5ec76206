"""What is installed from a wheel, built from an sdist, works away from the checkout, and with as little as it needs."""

import hashlib
import importlib.metadata
import json
import lzma
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
import venv
import zipfile

import pytest
from conftest import ROOT

from boresight import BoresightError
from boresight.errors import EXTRAS
from boresight.runtime import gpu as gpu  # which names its extra
from boresight.runtime.manifest import read_manifest, unpacked
from boresight.studies.known import EXPLORATIONS, STUDIES


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The sdist, the wheel made from it, and the wheel unpacked."""
    # the rooms, without what git ignores: a checkout may hold much else
    tmp_path = tmp_path_factory.mktemp("built")
    tree = tmp_path / "tree"
    tree.mkdir()
    ignored = shutil.ignore_patterns(*(line.strip("/") for line in (ROOT / ".gitignore").read_text().split()))
    rooms = {path.resolve().name for path in (ROOT / "boresight").iterdir() if path.is_symlink()}
    for room in ("boresight", *sorted(rooms)):
        shutil.copytree(ROOT / room, tree / room, symlinks=True, ignore=ignored)
    for name in ("pyproject.toml", "README.md", "LICENSE", "MANIFEST.in", "setup.py"):
        if (ROOT / name).is_file():
            shutil.copy(ROOT / name, tree)
    sdist = make("sdist", tree, tmp_path)
    with tarfile.open(sdist) as archive:
        archive.extractall(tmp_path / "sdist")
    wheel = make("wheel", next((tmp_path / "sdist").iterdir()), tmp_path)
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path / "site")
    return sdist, wheel, tmp_path / "site"


def make(what, tree, folder):
    """An sdist or a wheel of the tree, by the setuptools that is installed: an isolated build would download one."""
    code = f"from setuptools import build_meta; build_meta.build_{what}({str(folder)!r})"
    done = subprocess.run([sys.executable, "-c", code], cwd=tree, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    (made,) = folder.glob("*.tar.gz" if what == "sdist" else "*.whl")
    return made


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
    wanted = {
        "codegen/templates/src/UNIT.c.j2", "derive/model.py", "codegen/templates/src/stationary_detector.c.j2",
        "derive/pages/templates/page.html.j2", "runtime/random.c", "runtime/recording/built_in/fog_mems_transfer.toml",
        "derive/papers/delay_error/derivation.toml",
        "runtime/gpu/run.h", "runtime/gpu/runs.c", "studies/sea_state/many.c",
        "runtime/recording/built_in/template.toml", "studies/euler_table/table.py", "examples/pendulum.py",
        "examples/fly_gnss_ins.py", "evidence/trace.py", "cli.py", "py.typed",
        "examples/papers/first/paper.toml", "examples/papers/first/printed.tex",
    }  # fmt: skip
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    assert {f"boresight/{name}" for name in wanted} <= names
    assert {name.split("/")[0] for name in names if "dist-info" not in name} == {"boresight"}
    with tarfile.open(sdist) as archive:
        inside = {name.split("/", 1)[-1] for name in archive.getnames()}
    wanted |= {"generated/euler_matching/manifest.json", "evidence/attack.py", "studies/explorations/sea_state.py"}
    assert {f"boresight/{name}" for name in wanted} <= inside

    code = (
        "import boresight, numpy as np; from boresight.runtime.library import load; "
        f"assert boresight.__file__.startswith({str(site)!r}); load('euler-matching').F(omega_in_n=np.zeros(3)); "
        "from boresight.codegen.generate import default_folder; "
        "assert str(default_folder('euler-matching')) == 'generated/euler_matching'; "
        "from boresight.codegen.new import new; from pathlib import Path; new('mine', 'ins', Path()); "
        "from boresight.derive.papers import paper; assert len(paper('kang-2025').equations) == 6; "
        "from boresight.codegen import proof; from boresight.codegen.folder import Folder; "
        "from boresight.runtime.manifest import folder_of; import boresight.evidence.own; "
        "print('kept:', *proof.kept(Folder(folder_of('euler-matching'))))"
    )
    env = {**os.environ, "PYTHONPATH": str(site)}
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("kept: ") and "trace" in done.stdout
    assert (tmp_path / "mine.py").is_file() and (tmp_path / "fly_mine.py").is_file()


def test_a_wheel_holds_what_a_user_uses(built):
    """The generated C in one file, evidence of that C, and neither campaigns nor explorations."""
    _, wheel, site = built
    assert wheel.stat().st_size < 2.75e6
    package = site / "boresight"
    texts = json.loads(lzma.decompress((package / "generated.json.xz").read_bytes()))
    assert texts.keys() >= {"euler_matching/CMakeLists.txt", "velocity_dcm/src/vd_F_kernel.h"}
    assert all((ROOT / "generated" / name).read_text() == text for name, text in texts.items())
    folders = {name.split("/")[0] for name in texts}
    assert folders == {path.parent.name for path in (ROOT / "generated").glob("*/manifest.json")}
    results = {path.stem for path in (package / "evidence" / "results").iterdir()}
    assert results == folders & {path.stem for path in (ROOT / "evidence" / "results").glob("*.json")}
    assert not {"kinds.py", "spoilt.py", "flights", "proofs"} & {path.name for path in (package / "evidence").iterdir()}
    assert not any((package / name).exists() for name in ("generated", "studies/explorations", "examples/flight"))


def test_a_paper_of_ones_own_is_begun_and_judged_by_an_installed_wheel(built, tmp_path):
    code = "import sys; from boresight.cli import main; main(sys.argv[1:])"
    env = {**os.environ, "PYTHONPATH": str(built[2]), "BORESIGHT_CACHE": str(tmp_path / "cache")}
    for words in (["new", "mine", "--kind", "paper"], ["equations", "mine"]):
        command = [sys.executable, "-c", code, *words]
        done = subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("mine: 2 equations, 1 exact, 1 erratum\n")


def test_a_wheel_says_which_studies_are_in_the_checkout(built, tmp_path):
    code = (
        "import sys; from contextlib import suppress; from boresight.cli import main\n"
        "for words in (['study'], ['study', 'sea-claims']):\n"
        "    with suppress(SystemExit):\n"
        "        main(words)\n"
        "    print('----', file=sys.stderr)\n"
    )
    env = {**os.environ, "PYTHONPATH": str(built[2])}
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, env=env, capture_output=True, text=True)
    listed, refused, _ = done.stderr.split("----\n")
    here, elsewhere = listed.split("Commands:")[1].split("In the checkout:")
    assert all(f"  {name} " in (elsewhere if name in EXPLORATIONS else here) for name in STUDIES)
    said = f"study sea-claims is not installed; in the checkout: {', '.join(EXPLORATIONS)}"
    assert refused == f"boresight: {said}\n" and done.stdout == ""


def test_the_archive_of_a_wheel_is_unpacked_once_and_says_what_it_cannot(monkeypatch, tmp_path):
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "cache"))
    archive = tmp_path / "generated.json.xz"
    manifest = json.dumps({"files": {"src/a.c": hashlib.sha256(b"int a;\n").hexdigest()}})
    archive.write_bytes(lzma.compress(json.dumps({"a/src/a.c": "int a;\n", "a/manifest.json": manifest}).encode()))
    place = unpacked(archive)
    assert place.parent == tmp_path / "cache" and read_manifest(place / "a")["files"]
    assert [path.name for path in place.parent.iterdir()] == [place.name]
    (place / "a" / "src" / "a.c").unlink()
    assert unpacked(archive) == place
    with pytest.raises(BoresightError, match=rf"a\.c is missing; delete {place}, which is unpacked again"):
        read_manifest(place / "a")
    (tmp_path / "file").touch()
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "file"))
    with pytest.raises(BoresightError, match="set BORESIGHT_CACHE to a folder"):
        unpacked(archive)


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
        ("replay", "from boresight.analysis.figures import figure; figure('a.png', 3, 3).__enter__()"),
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
        ("many --runs 1 --device gpu", "gpu"),
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
    from boresight.runtime.recording.tables import table

    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(BoresightError, match=rf"boresight\[{extra}\]"):
        table(tmp_path / f"a.{ending}")


def test_every_module_of_an_extra_is_named_in_it():
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    project = {"flint": "python-flint", "markdown_it": "markdown-it-py", "elftools": "pyelftools",
               "cuda": "cuda-bindings", "nvidia": "nvidia-cuda-nvrtc-cu12"}  # fmt: skip
    for extra, modules in EXTRAS.items():
        assert {re.match(r"[\w-]+", line).group() for line in extras[extra]} == {project.get(m, m) for m in modules}
    (everything,) = extras["all"]
    included = set(re.fullmatch(r"boresight\[(.*)\]", everything).group(1).split(","))
    assert included == set(EXTRAS) - {"ardupilot", "cluster", "evidence", "gpu"}
    assert extras["test"][0] == "boresight[all,ardupilot,cluster,evidence]"


def test_the_layers_import_nothing_that_their_extra_does_not_bring():
    """What a layer imports, at any depth, is the standard library, the base, or of its own extra."""
    from test_imports import files, imported

    formats = ("parquet", "excel", "hdf5", "ulog", "ardupilot", "ros", "cluster", "gpu")
    allowed = {
        "derive": ("derive",), "codegen": ("derive",), "runtime": ("replay", *formats),
        "analysis": ("replay", "parquet"), "studies": ("replay",)
    }  # fmt: skip
    for layer, extras in allowed.items():
        known = {"numpy", "scipy", "platformdirs", "boresight"} | {m for extra in extras for m in EXTRAS[extra]}
        for path in files(layer):
            for name in imported(path):
                assert name.split(".")[0] in known | set(sys.stdlib_module_names), f"{path} imports {name}"
