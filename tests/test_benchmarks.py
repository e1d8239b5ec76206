"""What `make bench` reads, checks and prints; nothing is timed against anything here."""

import matplotlib
import numpy as np
import pytest
from conftest import ROOT
from tools import needs

from benchmarks import runs
from benchmarks.growth import grown
from benchmarks.peers import __main__ as bench
from benchmarks.peers import batch, compiled, formulas, report
from benchmarks.peers.printers import PRINTERS
from boresight.analysis import figures
from boresight.derive.models.azimuth_hold import azimuth_hold
from boresight.evidence.machine import accesses, kind

KERNELS = {name: getattr(np, name) for name in formulas.FUNCTIONS}


@pytest.fixture(scope="module")
def small():
    """Six states, three rows of measurement."""
    return formulas.problem(grown(6))


@pytest.mark.parametrize("kind", formulas.KINDS)
def test_the_formulas_give_what_dense_matrices_give(small, kind):
    given = formulas.numbers(small)
    got = formulas.outputs(small, kind, [given["v"], given["P"], given["Q"]], KERNELS)
    wanted = formulas.reference(small, kind, given)
    assert len(got) == wanted.size == small.writes(kind)
    assert formulas.apart(small, kind, got, wanted) < compiled.EQUAL
    assert np.abs(wanted).max() > 0


def test_the_updates_take_the_operations_that_their_form_needs(small):
    n, rows, packed = 6, 3, 21
    plain, joseph = (formulas.operations(small, f"updates, {form}") for form in ("plain", "Joseph"))
    assert plain == {"add": rows * (2 + n + packed), "multiply": rows * (2 * n + packed), "divide": rows}
    further = rows * (2 * n + packed)  # (A h - R K) and its product with K
    assert joseph == {**plain, "add": plain["add"] + further, "multiply": plain["multiply"] + further}


def test_a_tool_whose_numbers_differ_is_refused(small):
    given = formulas.numbers(small)
    task = compiled.Task("peer", "predict 2", "peer", small, "", "c")
    right = formulas.reference(small, "predict 2", given)
    compiled.hold([task], right[None], given)
    for wrong in (1 + 1e-11, np.nan):
        with pytest.raises(compiled.Differs, match="peer, predict 2"):
            compiled.hold([task], np.where(np.arange(right.size) == 4, wrong * right, right)[None], given)


@needs("g++")
@pytest.mark.parametrize("counted", [False, pytest.param(True, marks=needs("valgrind"))])
def test_c_of_two_tools_is_built_held_counted_and_timed(counted, small, monkeypatch, tmp_path):
    if not counted:
        monkeypatch.setattr(compiled.shutil, "which", lambda name: None)
    missing = {}
    tasks = [*bench.of_boresight({"other": grown(6)}, small, tmp_path, ("F", "predict 2", "updates, Joseph"))]
    tasks += bench.of_peers(small, missing, ("SymPy cse",), ("predict 2",))
    assert not missing and not compiled.measure(tasks, "-O2", tmp_path, rounds=1)
    assert {task.tool for task in tasks} == {*bench.ours.FORMS, bench.ours.NON_ZEROS, "SymPy cse"}
    assert all(task.ns["-O2"] > 0 and task.apart < compiled.EQUAL for task in tasks)
    assert all(task.instructions["-O2"] > 100 if counted else not task.instructions for task in tasks)


def test_many_runs_from_python_are_held_and_timed_by_every_way_to_fly_them(monkeypatch):
    kept = {tool: made for tool, made in batch.TOOLS.items() if tool.startswith(("Boresight", "NumPy"))}
    monkeypatch.setattr(batch, "TOOLS", kept)
    found, missing = batch.measure(formulas.problem(azimuth_hold()), sizes=(1, 3), rounds=1)
    assert not missing and all(ns > 0 for ns in found.values())
    assert found.keys() == {(tool, step, N) for tool in kept for step in batch.STEPS for N in (1, 3)}
    monkeypatch.setattr(batch, "EQUAL", 0.0)
    with pytest.raises(compiled.Differs, match="Boresight, Epoch"):
        batch.measure(formulas.problem(azimuth_hold()), sizes=(1,), rounds=1)


def test_a_peer_that_fails_is_missing_and_says_why(small, monkeypatch):
    def absent(problem, kind, name):
        raise ImportError("no such peer")

    monkeypatch.setitem(PRINTERS, "peer", absent)
    missing = {}
    assert not [*bench.of_peers(small, missing, ("peer",))]
    assert missing == {"peer": "ImportError: no such peer"}


def test_what_the_tools_print_is_read():
    assert compiled.medians("1.0 10.0\n3.0 30.0\n2.0 20.0\n") == [2.0, 20.0]
    dump = "version: 1\ndesc: Trigger: Client Request: f_one\nevents: Ir\ntotals: 4711\n"
    assert compiled.instructions([dump, "desc: Trigger: Program termination\ntotals: 1\n"]) == {"f_one": 4711}
    assert (
        compiled.text_of("   text    data     bss     dec     hex filename\n   1234       8       0    1242  4da x\n")
        == 1234
    )
    assert report.without_paths("g++: /home/me/a/b.cc:1: error: 1/2") == "g++: b.cc:1: error: 1/2"
    assert report.machine("processor\t: 0\nmodel name\t: Some CPU 7\n") == "Some CPU 7"


def test_the_table_says_who_wins():
    cells = {("Boresight", "a"): 2.0, ("Boresight, UD factors", "a"): 0.5, ("peer", "a"): 1.0, ("other", "a"): 3.0,
             ("Boresight", "b"): 1.0, ("peer", "b"): 4.0, ("peer", "c"): 5.0}  # fmt: skip
    table = report.compared("title", cells, "abc", {("peer", "a"): 70.0}, [("limit", {"a": "0.5"})])
    assert table.markdown().splitlines()[2:] == [
        "|  | a | b | c |",
        "|---|---|---|---|",
        "| Boresight | 2 | **1** | - |",
        "| Boresight, UD factors | 0 * | - | - |",
        "| peer | **1** / 70 | 4 | **5** |",
        "| other | 3 | - | - |",
        "| Boresight over the best peer | 2.00, peer wins | 0.25, Boresight wins | - |",
        "| limit | 0.5 | - | - |",
    ]
    assert [len(line) for line in table.text().splitlines()[1:]] == [len(table.text().splitlines()[1])] * 7
    assert "**" not in table.text()
    plain = report.compared(
        "", {("Boresight", "updates, Joseph"): 3.0, ("peer", "updates, plain"): 2.0}, formulas.KINDS
    )
    assert plain.rows[-1][1][3:5] == [
        "1.50, peer wins",
        "-",
    ]  # ours has no plain form: its Joseph form stands beside it


def test_the_page_is_written_between_its_markers_alone(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(f"before\n{report.BEGIN}\nold\n{report.END}\nafter\n")
    report.written(page, "new")
    assert page.read_text() == f"before\n{report.BEGIN}\nnew\n{report.END}\nafter\n"
    page.write_text("no marker")
    with pytest.raises(ValueError, match="one pair of markers"):
        report.written(page, "new")
    assert page.read_text() == "no marker"
    committed = (ROOT / "docs" / "benchmarks.md").read_text()
    assert committed.count(report.BEGIN) == committed.count(report.END) == 1


def test_the_readme_quotes_the_page():
    page, readme = ((ROOT / name).read_text() for name in ("docs/benchmarks.md", "README.md"))
    won = {}
    for label in compiled.HOSTS:
        lines = page.split(f"**One call at {label}: ns / instructions.**")[1].splitlines()[2:]
        columns = [cell.strip() for cell in lines[0].split("|")[2:-1]]
        (row,) = [line for line in lines[: lines.index("", 1)] if line.startswith("| Boresight over the best peer")]
        won[label] = dict(zip(columns, (cell.split(",")[0].strip() for cell in row.split("|")[2:-1]), strict=True))
    quoted = readme.split("| one call | -O2 | -O3 v3 |")[1].split("\n\n")[0].splitlines()[2:]
    kinds = [kind for kind in formulas.KINDS if kind != "updates, plain"]
    assert quoted == [f"| {kind} | {won['-O2'][kind]} | {won['-O3 v3'][kind]} |" for kind in kinds]


@pytest.mark.parametrize(
    ("halves", "expected"),
    [
        ((0x6808,), (False, 1)),  # ldr r0, [r1, #0]
        ((0xF8CC, 0x0000), (True, 1)),  # str.w r0, [ip]
        ((0xE92D, 0x43F8), (True, 8)),  # stmdb sp!, {r3-r9, lr}
        ((0xED91, 0x1A01), (False, 1)),  # vldr s2, [r1, #4]
        ((0xED2D, 0x8B02), (True, 2)),  # vpush {d8}
        ((0xECB2, 0x7A01), (False, 1)),  # vldmia r2!, {s14}
        ((0xEE37, 0x7A87), (False, 0)),  # vadd.f32
        ((0xEC51, 0x0B10), (False, 0)),  # vmov r0, r1, d0
        ((0xBDF0,), (False, 5)),  # pop {r4-r7, pc}
    ],
)
def test_loads_and_stores_are_read_from_the_instructions(halves, expected):
    """As objdump names them."""
    assert accesses(*halves) == expected


@pytest.mark.parametrize(
    ("halves", "expected"),
    [
        ((0xEE37, 0x7A87), "floating"),  # vadd.f32 s14, s15, s14
        ((0xEE27, 0x7B06), "floating"),  # vmul.f64 d7, d7, d6
        ((0xEEC7, 0x7A87), "quotient"),  # vdiv.f32 s15, s15, s14
        ((0xEE86, 0x7B07), "quotient"),  # vdiv.f64 d7, d6, d7
        ((0xEEF1, 0x7AE7), "root"),  # vsqrt.f32 s15, s15
        ((0xEEB1, 0x7BC7), "root"),  # vsqrt.f64 d7, d7
        ((0xEEF1, 0x7A67), "floating"),  # vneg.f32 s15, s15
        ((0xEE47, 0x7A27), "accumulation"),  # vmla.f32 s15, s14, s15
        ((0xEC51, 0x0B10), "two registers"),  # vmov r0, r1, d0
        ((0xEE17, 0x3A90), ""),  # vmov r3, s15
        ((0xFB93, 0xF3F2), "division"),  # sdiv r3, r3, r2
        ((0xFBB3, 0xF3F2), "division"),  # udiv r3, r3, r2
        ((0xFB02, 0xF303), ""),  # mul.w r3, r2, r3
        ((0xED91, 0x1A01), ""),  # vldr s2, [r1, #4]
        ((0x6808,), ""),  # ldr r0, [r1, #0]
    ],
)
def test_divisions_and_roots_are_read_from_the_instructions(halves, expected):
    """As objdump names them."""
    assert kind(*halves) == expected


def test_the_committed_figure_is_that_of_the_tables_of_its_page_and_a_tool_has_one_colour(tmp_path):
    """To the byte, by the version of matplotlib that is pinned; by another, as many curves and bars."""
    text, kept = (ROOT / "docs" / "benchmarks.md").read_text(), ROOT / "docs" / "figures" / "benchmarks.svg"
    report.figure(tmp_path / "benchmarks.svg", text)
    made = (tmp_path / "benchmarks.svg").read_text()
    if f"matplotlib=={matplotlib.__version__}\n" in (ROOT / "benchmarks" / "constraints.txt").read_text():
        assert made == kept.read_text(), "run 'python -m benchmarks.peers --page docs/benchmarks.md --draw'"
    tables = report.read_back(text)
    assert tables["One call at -O2: ns / instructions."]["Boresight", "F"] == 82
    assert ("Boresight", "updates, plain") not in tables["One call at -O2: ns / instructions."]
    tools = {tool for cells in tables.values() for tool, _ in cells if not tool.startswith("Boresight")}
    assert {tool.partition(", plain form")[0] for tool in tools} <= figures.TOOLS.keys()
    assert all(colour in made for tool, colour in figures.TOOLS.items() if f">{tool}<" in made and colour[0] == "#")


def test_the_figure_of_many_runs_is_that_of_its_table(tmp_path):
    text = (ROOT / "docs" / "how-to" / "fly-many-runs.md").read_text()
    runs.figure(tmp_path / "many.svg", text)
    made = (tmp_path / "many.svg").read_text()
    if f"matplotlib=={matplotlib.__version__}\n" in (ROOT / "benchmarks" / "constraints.txt").read_text():
        kept = (ROOT / "docs" / "figures" / "many.svg").read_text()
        assert made == kept, "run 'python -m benchmarks.runs --page docs/how-to/fly-many-runs.md --draw'"
    assert all(f">{name}<" in made for name, _ in report.read_back(text)[runs.TITLE])


def test_a_long_line_is_a_picture_in_svg_and_the_file_is_the_same_twice(tmp_path):
    texts = []
    for points in (figures.MANY // 2, 2 * figures.MANY, 2 * figures.MANY):
        with figures.figure(tmp_path / "a.svg", 3, 2) as (_, ax):
            ax.plot(np.arange(points), np.sin(np.arange(points)), color=figures.BLUE, label="long")
            ax.fill_between(np.arange(9), 0, 1, **figures.FAINT)
        texts.append((tmp_path / "a.svg").read_text())
    assert [text.count("<image") for text in texts] == [0, 1, 1] and texts[1] == texts[2]
    assert len(texts[1]) < 40_000
