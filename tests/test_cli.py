"""The command line as its user meets it: whole names, lines that fit, JSON alone, one line for what is wrong."""

import hashlib
import io
import json
import os
import pty
import re
import subprocess
import sys

import pytest
from conftest import PENDULUM, ROOT

from boresight import __version__, cli, report, terminal
from boresight.derive.ledger import frames
from boresight.derive.ledger.entries import ledger
from boresight.derive.ledger.lines import count_steps
from boresight.derive.letters import number_label
from boresight.derive.papers import PAPERS, paper
from boresight.runtime.manifest import built_in, folder_of, read_manifest
from boresight.studies.known import STUDIES, study


@pytest.fixture
def run(capsys, monkeypatch):
    """The command line in this process: its status, what it printed and its errors."""

    def run(*words, columns=80):
        monkeypatch.setenv("COLUMNS", str(columns))
        with pytest.raises(SystemExit) as ended:
            cli.main([str(word) for word in words])
        return ended.value.code or 0, *capsys.readouterr()

    return run


def fits(text, columns):
    return [line for line in text.splitlines() if len(line) > columns]


def test_help_names_every_command(run):
    status, out, _ = run("--help")
    assert status == 0
    for command in (
        "new",
        "models",
        "equations",
        "show",
        "generate",
        "verify",
        "study",
        "budget",
        "observe",
        "many",
        "replay",
        "observe",
        "noise",
        "export",
    ):
        assert command in out
    assert "..." not in out.split("Commands:")[1] and not fits(out, 80)


@pytest.mark.parametrize("columns", [80, 110])
def test_models_are_one_line_each_with_their_whole_names(run, columns):
    _, out, _ = run("models", columns=columns)
    assert not fits(out, columns)
    for name in built_in():
        assert re.search(rf"^{name}\s", out, re.MULTILINE), name
    if columns == 110:
        assert len(out.splitlines()) == len(built_in()) + 3


@pytest.mark.parametrize("columns", [80, 100])
@pytest.mark.parametrize("name", built_in())
def test_a_model_shows_each_state_input_and_function_by_its_whole_name_with_unit(run, columns, name):
    _, out, _ = run("models", name, columns=columns)
    assert not fits(out, columns)
    manifest = read_manifest(folder_of(name))
    words = set(out.split())
    for block in manifest["blocks"]:
        assert set(block["components"]) | set(block["unit"].split(", ")) <= words
    for fields in manifest["structs"].values():
        for field in fields:
            if field["name"] != "x":
                assert {field["name"], *field["unit"].split(", ")} <= words
    assert {unit["c_name"] for unit in manifest["units"].values()} | set(manifest["measurements"]) <= words


@pytest.mark.parametrize("columns", [80, 100])
@pytest.mark.parametrize("name", PAPERS)
def test_equations_are_a_table_of_whole_sentences(run, columns, name):
    one = paper(name)
    _, out, _ = run("equations", name, columns=columns)
    assert not fits(out, columns)
    for entry in (entry.to_dict() for entry in ledger(one)):
        said = entry["found"]
        assert re.fullmatch(r"[A-Z].*[^ .]\.", said), said
        assert "Origin" not in said
        flat = " ".join(out.split())
        row = rf"^ *{re.escape(number_label(entry['number']))} +{entry['status']} +{entry['kind']}"
        assert re.search(row, out, re.MULTILINE)
        assert entry["depends"].startswith(("Robust", "Nothing")) or entry["depends"][:40] in flat
        assert said in " ".join(out.replace("\n", " ").split()) or len(said) > columns - 30
    for text in (one.conditions.text, one.point.text):
        assert " ".join(out.split()).count(text) <= 1
    last = " ".join(out.partition("\nNot held:\n")[2].split())
    assert ("No frame is known of" in last) == bool(frames.found(one).unknown)
    assert ("are prose, which proves nothing" in last) == (", prose 0" not in str(count_steps(one.equations)))
    for text in one.witness.left_out.values():
        assert f"the witness leaves out {text}." in last


@pytest.mark.parametrize("columns", [80, 100])
def test_the_evidence_on_one_equation_has_its_numbers_and_the_conditions_once(run, columns):
    _, out, _ = run("equations", "kang-2025", "3", columns=columns)
    assert not fits(out, columns)
    flat = " ".join(out.split())
    assert flat.count(paper("kang-2025").point.text) == 1
    for text in ("erratum", "0.099879", "halving the errors", "no scan adds a term", "if the lever arm is small too"):
        assert text in flat
    c = flat.rpartition("In C ")[2].split(", ")
    assert "va_velocity_H" in c and "va_dcm_H" not in c


def test_equations_of_all_papers_fit_on_one_screen(run):
    _, out, _ = run("equations")
    assert not fits(out, 80) and len(out.splitlines()) < 20
    for name in PAPERS:
        assert name in out
        assert all(f"({entry.number})" in out for entry in ledger(paper(name)) if entry.kind and entry.number.isdigit())


def test_verify_names_every_function_whole(run):
    status, out, err = run("verify", "strapdown")
    assert status == 0 and err == ""
    assert not fits(out, 80)
    assert {"strapdown", *read_manifest(folder_of("strapdown"))["units"]} <= set(out.split())


def test_no_name_of_a_function_or_model_is_too_long_for_the_table_of_verify(capsys, monkeypatch):
    from boresight.codegen.verify import UnitCheck

    manifests = [read_manifest(folder_of(name)) for name in built_in()]
    checks = [
        UnitCheck(m["model"], unit, 1064, 256, False, 1e-300, 123456.7, 1e-300, True)
        for m in manifests
        for unit in m["units"]
    ]
    monkeypatch.setenv("COLUMNS", "80")
    terminal.page(*report.verified(checks))
    out, _ = capsys.readouterr()
    assert not fits(out, 80) and "…" not in out
    assert {check.unit for check in checks} | {check.model for check in checks} <= set(out.split())


def test_show_prints_prose_that_fits(run):
    for columns in (80, 100):
        _, out, _ = run("show", "kang-2025", "3", columns=columns)
        assert "As printed: " in out
        assert not fits(out, columns)


def test_slips_are_coloured_and_underlined_on_a_terminal_that_shows_colours(monkeypatch):
    assert terminal.marked("a ›b‹") == "a ›b‹", "in a pipe the signs alone"
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True, raising=False)
    monkeypatch.delenv("NO_COLOR", raising=False)
    assert terminal.marked("a ›b‹ c") == "a \x1b[4;31m›b‹\x1b[0m c"
    monkeypatch.setenv("NO_COLOR", "1")
    assert terminal.marked("a ›b‹") == "a ›b‹"


def test_models_as_json(run):
    listed = {model["model"]: model for model in json.loads(run("models", "--json")[1])}
    assert "stationary-detector" not in listed, "a kernel is no model"
    model = listed["euler-matching"]
    assert model["states"] == ["eps_n", "eps_e", "eps_d", "dmu_x", "dmu_y", "dmu_z"]
    assert set(model["measurements"]) == {"euler", "euler_exact"}
    assert json.loads(run("models", "euler-matching", "--json")[1]) == [model]


def test_equations_as_json_have_the_documented_fields(run):
    entries = json.loads(run("equations", "song-lee-2001", "--json")[1])
    assert [entry["number"] for entry in entries if entry["number"].isdigit()] == [str(k) for k in range(1, 29)]
    fields = {"paper", "number", "status", "kind", "origin", "printed", "derived", "note", "evidence"}
    fields |= {"found", "decisions", "depends"}
    for entry in entries:
        assert set(entry) == fields
        assert entry["status"] in ("exact", "first-order", "definition", "erratum")
        assert bool(entry["kind"]) == bool(entry["origin"]) == (entry["status"] == "erratum")
    assert json.loads(run("equations", "song-lee-2001", "19", "--json")[1]) == [entries[19]]


def test_show_prints_a_derivation_and_a_model_shows_its_own(run):
    for words in (("song-lee-2001", "19"), ("euler-matching", "19")):
        status, out, _ = run("show", *words)
        assert status == 0 and "19" in out


@pytest.mark.parametrize("name", ["strapdown", f"{ROOT / 'examples' / 'own_model.py'}:TANK"])
def test_show_describes_a_model_in_every_format(run, name):
    status, out, _ = run("show", name)
    assert status == 0 and "Inputs" in out and "C functions" in out
    assert not fits(out, 80)
    for form, begin in (("latex", "\\documentclass"), ("html", "<!doctype html>")):
        status, out, _ = run("show", name, "--format", form)
        assert status == 0 and out.startswith(begin)


def test_show_prints_the_closed_form_of_an_unknown_delay(run):
    status, out, _ = run("show", "delay-error", "--format", "html")
    assert status == 0 and "angular momentum" in out


def test_study_as_json_and_as_a_report_that_fits(run):
    status, out, _ = run("study", "euler-table", "--runs", 4, "--json")
    said = json.loads(out)
    assert said["study"] == "euler-table" and said["scenario"]["runs"] == 4 and said["good"] == (status == 0)
    assert said["result"]["cells"] == 147 and said["result"]["linear"]["agree"] == 147
    assert [claim["says"] for claim in said["claims"]] and "history" not in said["result"] and said["figures"] == []
    assert not fits(run("study", "euler-table", "--runs", 4)[1], 80)


def test_study_without_a_name_lists_them(run):
    shown = "".join(run("study")[1:])
    assert {line.split()[0] for line in shown.split("Commands:")[1].splitlines() if line.strip()} >= set(STUDIES)
    assert all(title in " ".join(shown.split()) for title in STUDIES.values())


@pytest.mark.parametrize("name", list(STUDIES))
def test_a_study_has_its_own_options_and_refuses_every_other_one_by_naming_them(run, name):
    own = {f"--{option.name.replace('_', '-')}" for option in study(name).options()}
    own |= {"--seeds"} if study(name).claims else set()
    own |= {"--out", "--svg", "--json"}
    _, shown, _ = run("study", name, "--help")
    assert {word.strip(",") for word in shown.split() if word.startswith("--")} == own | {"--help"}
    for option in {"--runs", "--seconds", "--switch", "--explore"} - own:
        status, out, err = run("study", name, option, "3")
        assert status == 1 and out == "" and len(err.splitlines()) == 1
        assert err.startswith(f"boresight: study {name} takes no {option}; ")
        assert {word.strip(",") for word in err.split(";")[1].split() if word.startswith("--")} == own


def test_claims_over_seeds_are_bands_that_hold_what_each_seed_says(run):
    words = ("study", "euler-table", "--runs", 2, "--seconds", 20, "--json")
    _, out, _ = run(*words, "--seeds", 2)
    each = [json.loads(run(*words, "--seed", seed)[1])["claims"][1] for seed in (0, 1)]
    said = json.loads(out)["claims"][1]
    assert said["held"] == sum(claim["holds"] for claim in each)
    for name, (low, middle, high) in said["numbers"].items():
        values = sorted(claim["numbers"][name] for claim in each)
        assert [low, high] == values and middle == pytest.approx(sum(values) / 2)


@pytest.mark.parametrize("svg", [False, True])
def test_a_figure_says_what_it_was_made_from(run, tmp_path, monkeypatch, svg):
    from boresight.studies.euler_table import figures

    monkeypatch.setattr(figures, "history", lambda *of_a_case: None)  # one figure of the ten
    run("study", "euler-table", "--runs", 2, "--seconds", 5, "--seed", 7, "-o", tmp_path, *["--svg"] * svg)
    (path,) = tmp_path.glob("euler_table.*")
    files = json.loads((ROOT / "generated" / "euler_matching" / "manifest.json").read_text())["files"]
    digest = hashlib.sha256(json.dumps([files], sort_keys=True).encode()).hexdigest()[:8]
    wanted = f"euler-table, seed 7, boresight {__version__}, C {digest}"
    assert wanted.encode() in path.read_bytes()  # PNG keeps its metadata as plain text, SVG the foot as well
    assert path.read_bytes().count(wanted.encode()) == (2 if svg else 1)


def test_a_model_of_ones_own_is_written_to_a_folder_by_its_own_name(run, tmp_path, monkeypatch):
    from boresight.codegen import generate as g

    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text(
        "import sys\nsys.path.insert(0, {!r})\nfrom pendulum import PENDULUM as P\n".format(PENDULUM.rsplit("/", 1)[0])
    )
    assert g.default_folder(f"{tmp_path}/mine.py:P") == g.default_folder(PENDULUM)
    assert g.default_folder(PENDULUM).name == g.load_model(PENDULUM).name.replace("-", "_")


def test_bare_generate_writes_nothing_where_the_package_was_installed(run, tmp_path, monkeypatch):
    from boresight.codegen import generate as g

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(g, "is_checkout", lambda: False)
    status, out, err = run("generate")
    assert status == 1 and out == "" and len(err.splitlines()) == 1 and "FILE.py:NAME" in err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("words", "offered"),
    [
        ("models vel", {"velocity-attitude", "velocity-attitude-lever", "velocity-attitude-sensors", "velocity-dcm"}),
        ("verify azimuth-hold-", {"azimuth-hold-reference"}),
        ("equations k", {"kim-2018", "kang-2025"}),
        ("show eu", {"euler-matching"}),
        ("study ", set(STUDIES)),
    ],
)
def test_the_shell_completes_names(words, offered):
    env = {**os.environ, "_BORESIGHT_COMPLETE": "complete_bash", "COMP_WORDS": f"boresight {words}"}
    env["COMP_CWORD"] = str(len(f"boresight {words}".split(" ")) - 1)
    command = [sys.executable, "-c", "import sys; sys.argv = ['boresight']; from boresight.cli import main; main()"]
    done = subprocess.run(command, env=env, cwd=ROOT, capture_output=True, text=True, check=False)
    assert set(done.stdout.split()) == offered


def on_a_terminal(*words, lines, **env):
    """What a command prints on a terminal of 80 columns, `cat` with a mark as its pager."""
    here, there = pty.openpty()
    env = {**os.environ, "PAGER": "echo PAGED; cat", "TERM": "xterm", "COLUMNS": "80", "LINES": str(lines), **env}
    command = [sys.executable, "-m", "boresight.cli", *words]
    with subprocess.Popen(command, cwd=ROOT, env=env, stdin=there, stdout=there, stderr=there) as process:
        os.close(there)
        printed = b""
        while True:
            try:
                piece = os.read(here, 4096)
            except OSError:
                break
            if not piece:
                break
            printed += piece
    os.close(here)
    assert process.returncode == 0, printed.decode()
    return printed.decode()


def test_what_is_longer_than_the_terminal_is_paged_and_whole_in_a_pipe(run):
    whole = run("models", "velocity-attitude")[1]
    paged = on_a_terminal("models", "velocity-attitude", lines=24)
    assert "PAGED" in paged and whole.splitlines()[-1].strip() in paged
    assert "PAGED" not in on_a_terminal("models", lines=24)
    assert len(whole.splitlines()) > 24


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("models", "eular"), "euler-matching"),
        (("models", "examples/pendulum.py:PENDULUM"), "'boresight show FILE.py:NAME' describes one of your own"),
        (("verify", "examples/pendulum.py"), "name a model in it, as examples/pendulum.py:NAME"),
        (("equations", "song-lee-2002"), "there are song-lee-2001"),
        (("equations", "kang-2025", "7"), "there are 1, 2"),
        (("show", "song-lee-2001", "29"), "29"),
        (("show", "nothing"), "there are song-lee-2001"),
        (("show", "stationary-detector"), "without a model"),
        (("show", "examples/pendulum.py:PENDULUM", "3"), "uses no equation of a paper"),
        (("show", "euler-table"), "velocity-dcm; 'boresight study euler-table' runs the study of that name"),
        (("show", "my-filter"), "velocity-dcm; your own is FILE.py:NAME, or the folder of a paper"),
        (("show", "nothing.py:X"), "nothing.py is not found"),
        (("show", "song-lee-2001", "--format", "word"), "there are"),
        (("show", "song-lee-2001", "--format", "pdf"), "-o"),
        (("generate", "eular"), "euler-matching, "),
        (("verify", "eular"), "euler-matching"),
        (("study", "eular"), "there are euler-table, euler-exploration"),
        (("study", "euler-table", "--runs", "0"), "runs"),
        (("study", "euler-table", "--switch", "sideways"), "there are"),
        (("replay", "nowhere.npz"), "nowhere.npz"),
        (("replay", "pyproject.toml"), "pyproject.toml"),
        (("show", "song-lee-2001", "-o", "pyproject.toml/below"), "cannot write"),
    ],
)
def test_what_is_wrong_is_one_line_and_a_status(run, words, said, monkeypatch):
    monkeypatch.chdir(ROOT)
    status, out, err = run(*words)
    assert status not in (0, None)
    assert said in err
    assert len(err.strip().splitlines()) == 1, err
    assert out == ""


def test_an_encoding_that_lacks_a_sign_is_one_clear_line(capsys, monkeypatch):
    written = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written, encoding="ascii"))
    with pytest.raises(SystemExit) as ended:
        cli.main(["show", "kang-2025", "4"])
    said = "boresight: the output has signs that ascii lacks; set PYTHONIOENCODING=utf-8\n"
    assert (ended.value.code, written.getvalue(), capsys.readouterr().err) == (1, b"", said)
