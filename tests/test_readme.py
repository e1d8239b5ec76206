"""What the README shows runs as it stands there."""

import re
import subprocess

import numpy as np
import pytest
from conftest import ROOT

README = (ROOT / "README.md").read_text()
PAGES = [
    ROOT / "README.md",
    *(ROOT / f"{name}.md" for name in ("CHANGELOG", "CONTRIBUTING", "SECURITY")),
    *sorted((ROOT / "docs").rglob("*.md")),
    *ROOT.glob("examples/*/*.md"),
]


def block(language):
    (found,) = re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)
    return found


def test_the_python_example_runs_is_short_and_does_one_thing_a_line(capsys):
    code = block("python")
    statements = [line for line in code.splitlines() if line and not line.startswith("#")]
    assert len(statements) <= 20 and max(map(len, statements)) <= 90
    assert not any(";" in line or line.count(" = ") > 1 for line in statements)
    names = {}
    exec(code, names)
    assert np.abs(np.degrees(names["loop"].nav["mu"] - names["mu"])).max() < 0.01
    promised = code.rstrip().rsplit("# ", 1)[1]
    assert np.array(promised.split(), float) == pytest.approx(
        np.array(capsys.readouterr().out[1:-2].split(), float), abs=1e-3
    )


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
    for page in PAGES:
        for link in re.findall(r"\]\(([^)#]+)", page.read_text()):
            assert link.startswith("http") or (page.parent / link).exists(), f"{page}: {link}"


def test_prose_ends_by_column_100():
    """What cannot be broken may be longer: a table, an example, a picture, a name."""
    for page in PAGES:
        fenced = False
        for number, line in enumerate(page.read_text().splitlines(), 1):
            fenced ^= line.lstrip().startswith("```")
            if len(line) > 100 and not fenced and not line.startswith(("|", "![")):
                assert " " not in re.sub("`.*?`", "name", line.strip()), f"{page}, line {number}"
    assert max(map(len, README.splitlines())) <= 100


def test_every_command_that_the_readme_shows_exists(capsys):
    from boresight import cli

    for line in re.findall(r"^boresight (.*?)(?:   |$)", README, re.MULTILINE):
        with pytest.raises(SystemExit) as ended:
            cli.main([line.split()[0], "--help"])
        assert ended.value.code == 0
        assert capsys.readouterr().out.startswith(f"Usage: boresight {line.split()[0]}")
    targets = set(re.findall(r"^make ([\w-]+)", README, re.MULTILINE))
    assert targets and all(
        re.search(rf"^{name}:.*\n\t", (ROOT / "Makefile").read_text(), re.MULTILINE) for name in targets
    )


def test_every_target_of_the_makefile_has_a_recipe():
    makefile = (ROOT / "Makefile").read_text()
    (phony,) = re.findall(r"^\.PHONY: (.*)$", makefile, re.MULTILINE)
    for name in phony.split():
        assert re.search(rf"^{name}:.*\n\t", makefile, re.MULTILINE), name
    for benchmark in (ROOT / "benchmarks").glob("[a-z]*.py"):
        assert re.search(rf"-m benchmarks\.{benchmark.stem}\b", makefile)


def test_every_c_function_named_exists():
    header = (ROOT / "generated" / "euler_matching" / "include" / "euler_matching.h").read_text()
    for name in re.findall(r"\bem_[A-Za-z_]+", README):
        if name not in ("em_nav", "em_angles", "em_"):
            assert name in header, name
