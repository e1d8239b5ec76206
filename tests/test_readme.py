"""What the README shows runs as it stands there."""

import re
import subprocess

import numpy as np
from conftest import ROOT

README = (ROOT / "README.md").read_text()


def block(language):
    (found,) = re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)
    return found


def test_the_python_example_runs_and_is_short():
    code = block("python")
    assert len(code.splitlines()) <= 15
    names = {}
    exec(code, names)
    assert np.abs(np.degrees(names["loop"].nav["mu"] - names["mu"])).max() < 0.01


def test_the_c_example_compiles_and_runs(tmp_path):
    head, body = block("c").split("\n\n", 1)
    check = "if (H[EM_IX_DMU_X] != -1.0) {\n    return 1;\n}"
    (tmp_path / "main.c").write_text(f"{head}\nint main(void)\n{{\n{body}\n{check}\nreturn 0;\n}}\n")
    folder = ROOT / "generated" / "euler_matching"
    sources = sorted(map(str, (folder / "src").glob("*.c")))
    program = str(tmp_path / "main")
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", f"-I{folder / 'include'}"]
    subprocess.run(["cc", *flags, str(tmp_path / "main.c"), *sources, "-lm", "-o", program], check=True)
    subprocess.run([program], check=True)


def test_every_link_leads_somewhere():
    for link in re.findall(r"\]\(([^)#]+)", README):
        assert (ROOT / link).exists(), link


def test_every_c_function_named_exists():
    header = (ROOT / "generated" / "euler_matching" / "include" / "euler_matching.h").read_text()
    for name in re.findall(r"\bem_[A-Za-z_]+", README):
        if name not in ("em_nav", "em_angles", "em_"):
            assert name in header, name
