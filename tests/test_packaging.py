"""What is installed from a wheel, built from an sdist, works away from the checkout."""

import os
import subprocess
import sys
import tarfile
import zipfile

from conftest import ROOT


def test_sdist_and_wheel_hold_the_package_and_an_installed_one_flies(tmp_path):
    # only what git would hand out: a checkout may hold much else
    tree = tmp_path / "tree"
    tree.mkdir()
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True)
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
    wanted = (
        "generated/euler_matching/manifest.json", "generated/euler_matching/CMakeLists.txt",
        "generated/euler_matching/src/em_euler_H_kernel.h", "codegen/templates/src/UNIT.c.j2", "derive/model.py",
        "codegen/templates/src/stationary_detector.c.j2", "generated/stationary_detector/src/stationary_detector.c",
        "runtime/recordings/fog_mems_transfer.toml", "studies/euler_table.py", "cli.py", "py.typed",
    )  # fmt: skip
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
        archive.extractall(tmp_path / "site")
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
        "assert boresight.__file__.startswith({!r}); load('euler-matching').F(omega_in_n=np.zeros(3)); "
        "from boresight.codegen.generate import default_folder; "
        "assert str(default_folder('euler-matching')) == 'generated/euler_matching'".format(str(tmp_path / "site"))
    )
    env = {**os.environ, "PYTHONPATH": str(tmp_path / "site")}
    subprocess.run([sys.executable, "-c", code], cwd=tmp_path, env=env, check=True)
