"""What `boresight diff` prints of an edit: the entries that changed, no others, and their values."""

import json
import re
import shutil
import subprocess
from dataclasses import replace
from types import ModuleType

import mpmath
import pytest
from conftest import ROOT
from sympy import Matrix, cos, sin
from tools import tool

from boresight import side_by_side
from boresight.cli import main
from boresight.codegen.difference import compared, cost, to_json
from boresight.codegen.difference_page import differences_page
from boresight.codegen.generate import load_model
from boresight.codegen.text.equations import FILE, equations_text, read_equations
from boresight.derive.expressions import constants_in, names_in
from boresight.derive.mechanics import error_models
from boresight.derive.model import variable
from boresight.derive.models import built_in
from boresight.derive.pages.model import forms
from boresight.derive.pages.named import component_letters
from boresight.derive.pages.render import write
from boresight.evidence.spoilt import WRITERS, Shown, rendered

SWUNG = ROOT / "examples" / "pendulum.py"


def read(model):
    return read_equations(equations_text(model), model.name)


def difference(old, new):
    return compared(new.name, "HEAD", read(old), read(new))


@pytest.fixture(scope="module")
def coriolis():
    """The phi model, the same once the 2 of Coriolis is dropped from its source, and their difference."""
    text = (ROOT / "derive" / "mechanics" / "mechanization.py").read_text()
    right, wrong = "rate = 2 * omega_ie_n(lat, frame) +", "rate = omega_ie_n(lat, frame) +"
    assert text.count(right) == 1
    changed = ModuleType("changed")
    exec(compile(text.replace(right, wrong), "mechanization.py", "exec"), changed.__dict__)
    before = built_in("phi-error")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(error_models, "turning_n", changed.turning_n)
        after = built_in("phi-error")
    return before, after, difference(before, after)


def test_the_two_of_coriolis_is_seen_in_the_quantity_and_in_the_four_entries_that_move(coriolis):
    """In ENU omega_ie is (0, cos, sin) of the latitude times the Earth's rate: each falls by it once."""
    *_, found = coriolis
    rate = 7.292115e-5
    expected = {"dv_e by dv_n": sin, "dv_n by dv_e": sin, "dv_e by dv_u": cos, "dv_u by dv_e": cos}
    assert {(e.matrix, e.place) for e in found.entries} == {("F", place) for place in expected}
    assert [(e.matrix, e.place) for e in found.quantities] == [
        ("omega_cor_n", "omega_cor_n_n"), ("omega_cor_n", "omega_cor_n_u")
    ]  # fmt: skip
    assert not found.statements and all(e.by == ("omega_cor_n",) for e in found.entries)
    sizes = [(e, expected[e.place]) for e in found.entries] + list(zip(found.quantities, (cos, sin), strict=True))
    for entry, function in sizes:
        part = float(function(entry.at["lat"]))
        assert entry.largest == pytest.approx(rate * abs(part), rel=1e-6)
        assert abs(part) > 0.995, "the box has a latitude where it is larger"
        assert not entry.rounding and not entry.constants


def test_a_dropped_term_is_one_pair_and_the_places_that_move(coriolis):
    *_, found = coriolis
    text = write(differences_page([found]), "text")
    assert text.count("\nbefore\n") == text.count("\nafter\n") == 2
    assert len(text.partition("\nNamed")[0].splitlines()) < 25
    flat = " ".join(text.split())
    assert "moves F: dv_e by dv_n, dv_e by dv_u, dv_n by dv_e, dv_u by dv_e;" in flat
    assert "omega_cor_n, 2 omega_ie_n + omega_en_n of the Coriolis acceleration, rad/s" in flat
    document = to_json(found)
    assert [(e["quantity"], e["entry"]) for e in document["quantities"]] == [
        ("omega_cor_n", "omega_cor_n_n"), ("omega_cor_n", "omega_cor_n_u")
    ]  # fmt: skip
    assert all(e["by"] == ("omega_cor_n",) for e in document["entries"])
    texts = {*document["where"].values(), *(e[side] for e in document["quantities"] for side in ("before", "after"))}
    assert "2*omega_ie_n(2) + omega_en_n(2)" in texts
    assert texts & {"omega_ie_n(2) + omega_en_n(2)", "omega_en_n(2) + omega_ie_n(2)"}


FORMULA = r"\n    \S+ = .*(?:\n    .+)*"


def formula(text):
    """The value of what is printed, by the values of its letters."""
    text = " ".join(text.translate(str.maketrans("⋅^", "*#", "›‹")).split()).replace("#", "**").replace("√", "sqrt")
    assert re.fullmatch(r"[\w\s.()*/+-]+", text), text
    text = re.sub(r"(?<![\w.])\d+(?:\.\d+)?(?:e[-+]\d+)?", r"mpf('\g<0>')", text)
    return lambda letters: mpmath.mpf(eval(text, {"__builtins__": {}}, {**vars(mpmath), **letters}))


def letters_of(text, values):
    """The letters of the page at these values of the model's components: what it defines is computed as it says."""
    found = dict(values)
    for name, value in re.findall(r"^    (\w+) +([\w.⋅()/^√ *+-]+?)  +\S", text.partition("\nConstants")[2], re.M):
        if name != "constant":
            found[name] = formula(value)(found)
    for name, value in re.findall(r"^    (\w+) = (.*(?:\n    [-+=].*)*)", text.partition("\nNamed")[2], re.M):
        if not set("⎡⎢⎣") & set(value):
            found[name] = formula(value)(found)
    return found


def values_of(model, seed=0.37):
    found = {}
    for v in (*model.states, *model.inputs):
        for i, symbol in enumerate(v.symbols):
            found[symbol] = v.low[i] + (v.high[i] - v.low[i]) * mpmath.mpf(seed * (i + 3) % 1)
    return found


def test_what_is_printed_are_the_entries_of_both_models(coriolis):
    mpmath.mp.dps = 30
    *models, found = coriolis
    text = write(differences_page([found]), "text")
    shown = re.findall(
        r"^(\w+): by (\S+) at .*(?:\n  .*)*"
        r"\nbefore\n    \1 = (.*(?:\n    .*)*)\nafter\n    \1 = (.*(?:\n    .*)*)",
        text,
        re.M,
    )
    assert len(shown) == 2 == text.count("\nbefore\n")
    for name, size, *sides in shown:
        values = []
        for model, side in zip(models, sides, strict=True):
            at = values_of(model)
            called = component_letters(model)
            letters = letters_of(text, {called[s].name: value for s, value in at.items()})
            (own,) = (entry.value.evalf(30, subs=at) for entry in names_in(model.F) if entry.name == name)
            values.append(formula(side)(letters))
            assert abs(values[-1] - own) < 1e-25, (name, side)
        assert 0 < abs(values[0] - values[1]) < float(size) * 1.01


@pytest.mark.parametrize("form", list(WRITERS))
def test_every_formula_of_a_difference_is_shown_as_it_is(coriolis, form):
    *_, found = coriolis
    page = differences_page([found])
    shown = [form for section in page.sections for form in forms(section) if len(form.relation.sides) > 1]
    assert len(shown) >= 8
    for one in shown:
        relation = Shown("", one.relation, one.quantities)
        assert relation.holds(form, rendered(relation, form))
    document = write(page, "html" if form == "mathml" else form)
    if form == "mathml":
        assert document.count("<math") >= len(shown)
        marked = [WRITERS[form](one.relation, one.quantities, marks=one.marks) for one in shown]
        assert document.count('class="slip"') == "".join(marked).count('class="slip"') >= 2
    else:
        flat = plain(document)
        assert all(plain(WRITERS[form](one.relation, one.quantities, marks=one.marks)) in flat for one in shown)


def plain(text):
    """Without spaces and line breaks."""
    return re.sub(r"\s|\\piece\{|\}%|\{\}", "", text)


def pendulum():
    return load_model(f"{SWUNG}:PENDULUM")


def test_sizes_are_the_largest_of_the_box_and_a_part_of_their_row():
    """damping omega^2 in the place of damping omega: at the corner damping = 1, omega = -20 it is 420 away; F's entry
    by omega is -2 damping omega in the place of -damping, twice as large as the row's largest where omega is -1/2."""
    old = pendulum()
    omega, damping = old.states[1].scalar, old.structs[0].fields[0].symbols[1]
    new = replace(old, f=old.f + Matrix([0, damping * omega - damping * omega**2]))
    found = {(e.matrix, e.place): e for e in difference(old, new).entries}
    assert found.keys() == {("f", "omega"), ("F", "omega by omega")}
    f, F = found["f", "omega"], found["F", "omega by omega"]
    assert f.largest == pytest.approx(420) and {"omega": -20, "damping": 1}.items() <= f.at.items()
    assert (F.largest, F.at) == (pytest.approx(41), {"omega": -20, "damping": 1})
    assert 1.5 < F.relative <= 2


def test_what_is_stated_is_told_before_and_after():
    old = pendulum()
    heat = variable("heat", "temperature", "K", "of the bearing", 200, 400)
    plant, step = old.structs
    new = replace(
        old,
        states=(old.states[0], replace(old.states[1], meaning="its angular rate", high=(30.0,))),
        structs=(replace(plant, fields=(*plant.fields, heat)), step),
        frame="the plane",
    )
    text = write(differences_page([difference(old, new)]), "text")
    for line in (
        "state rate, box: was -20 to 20; is -20 to 30",
        "state rate, meaning: was its rate; is its angular rate",
        "input heat: new; temperature, K, of the bearing, 200 to 400, plant",
        "model, frame: was none; is the plane",
    ):
        assert f"\n{line}\n" in text
    back = write(differences_page([difference(new, old)]), "text")
    assert "\ninput heat: gone; temperature" in back and "model, frame: was the plane; is none" in back
    assert write(differences_page([difference(old, old)]), "text").endswith("\nNo difference.\n")


def test_rows_that_are_new_or_moved_are_no_other_difference():
    old = pendulum()
    moved = replace(old, states=old.states[::-1], f=Matrix([old.f[1], old.f[0]]), G=Matrix([1, 0]))
    found = difference(old, moved)
    assert [(s.field, s.before, s.after) for s in found.statements] == [
        ("order of states", "angle, rate", "rate, angle")
    ]
    assert not found.entries
    renamed = replace(old, measurements=(replace(old.measurements[0], name="resolver"),))
    entries = {(e.matrix, e.place): (e.before, e.after) for e in difference(old, renamed).entries}
    theta = old.states[0].scalar
    assert entries["encoder h", "angle"] == (theta, None) and entries["resolver h", "angle"] == (None, theta)
    text = write(differences_page([difference(old, renamed)]), "text")
    assert "resolver h: 1 of 1 entries" in text and "angle: new\n    h_angle = theta" in text


def test_a_variable_may_lose_components_and_a_constant_become_an_input():
    old = pendulum()
    plant, step = old.structs
    (rod,) = plant.fields
    g = next(iter(constants_in(old.f)))
    gravity = variable("gravity", "g", "m/s^2", "gravity", 9, 10)
    shorter = replace(rod, symbols=rod.symbols[:1], unit="m", low=rod.low[:1], high=rod.high[:1])
    f = Matrix([old.f[0], old.f[1].subs({g: gravity.scalar, rod.symbols[1]: 0})])
    new = replace(old, f=f, structs=(replace(plant, fields=(shorter, gravity)), step))
    for found in (difference(old, new), difference(new, old)):
        text = write(differences_page([found]), "text")
        assert "g_0⋅sin(theta)" in text and "constant g: " in text and "input gravity: " in text
        assert "input rod, components: was length" in text
        (entry,) = (e for e in found.entries if e.matrix == "f")
        assert entry.largest >= 19.9, "the damping of a rate of 20"


def test_a_constant_and_another_way_of_writing_are_told_apart(tmp_path):
    text = SWUNG.read_text()
    (tmp_path / "mine.py").write_text(text.replace('"9.81"', '"9.82"'))
    found = difference(pendulum(), load_model(f"{tmp_path / 'mine.py'}:PENDULUM"))
    assert [(s.part, s.field, s.before, s.after) for s in found.statements] == [("constant g", "value", "9.81", "9.82")]
    assert {e.place: e.constants for e in found.entries} == {"omega": True, "omega by theta": True}
    (f,) = (e for e in found.entries if e.matrix == "f")
    assert f.largest == pytest.approx(0.01 / 0.1, rel=1e-2)  # at the shortest rod, where the sine is 1
    text = write(differences_page([found]), "text")
    assert "omega: a constant alone; by 0.1 at" in text and "before" not in text

    old = pendulum()
    theta = old.states[0].scalar
    turned = old.f.replace(sin, lambda angle: 2 * sin(angle / 2) * cos(angle / 2))
    found = difference(old, replace(old, f=turned))
    assert all(e.rounding and e.largest < 1e-13 for e in found.entries if e.matrix == "f")
    assert "written otherwise; no value differs beyond rounding" in write(differences_page([found]), "text")
    assert theta in found.entries[0].after.free_symbols


def test_operations_and_code_are_of_the_functions_that_differ():
    old = pendulum()
    made = cost(read(old), read(replace(old, G=Matrix([0, 2]))))
    changes = {c.name: (c.before, c.after) for c in made.changes}
    assert "Q" in changes and "encoder_h" not in changes
    assert changes["Q"][1] > changes["Q"][0]
    assert not made.unknown and 0 < made.before < made.after


def test_without_a_compiler_the_size_is_unknown(monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")
    old = pendulum()
    found = difference(old, new := replace(old, G=Matrix([0, 2])))
    found = replace(found, cost=cost(read(old), read(new)))
    text = write(differences_page([found]), "text")
    assert "code of what differs: unknown: no C compiler: 'no-such-compiler' is not found" in text
    assert to_json(found)["bytes"]["before"] is None


# ---------------------------------------------------------------- the command


def git(folder, *words):
    command = [tool("git"), "-c", "user.name=n", "-c", "user.email=e", *words]
    return subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout


@pytest.fixture
def repository(tmp_path, monkeypatch):
    """A repository with the pendulum's file and its equations, one revision without them before."""
    monkeypatch.chdir(tmp_path)
    git(tmp_path, "init", "-q")
    (tmp_path / "mine.py").write_text(SWUNG.read_text())
    git(tmp_path, "add", "mine.py")
    git(tmp_path, "commit", "-qm", "the model")
    folder = tmp_path / "generated" / "pendulum"
    folder.mkdir(parents=True)
    (folder / FILE).write_text(equations_text(pendulum()))
    git(tmp_path, "add", ".")
    git(tmp_path, "commit", "-qm", "its equations")
    return tmp_path


def run(capsys, *words):
    with pytest.raises(SystemExit) as left:
        main(["diff", *words])
    printed = capsys.readouterr()
    return left.value.code or 0, printed.out, printed.err


def test_a_paper_is_held_against_what_is_committed(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    git(tmp_path, "init", "-q")
    shutil.copytree(ROOT / "examples" / "papers" / "first", tmp_path / "mine")
    git(tmp_path, "add", ".")
    git(tmp_path, "commit", "-qm", "the paper")
    assert run(capsys, "mine") == (0, "mine: the same statuses\n", "")
    printed = tmp_path / "mine" / "printed.tex"
    printed.write_text(printed.read_text().replace("[\\omega", "-[\\omega"))
    status, out, _ = run(capsys, "mine")
    assert status == 1 and out.startswith("(2) erratum sign -> first-order\n    before  ")
    status, out, _ = run(capsys, "mine", "--json")
    (change,) = json.loads(out)
    assert status == 1 and (change["before"]["status"], change["now"]["status"]) == ("erratum sign", "first-order")
    status, _, err = run(capsys, "mine", "--against", "nothing")
    assert status == 1 and "no such revision" in err and err.count("\n") == 1


def test_an_edit_is_held_against_what_is_committed(repository, capsys):
    assert run(capsys, "mine.py:PENDULUM") == (
        0,
        "pendulum: against HEAD\n======================\n\nNo difference.\n",
        "",
    )
    text = (repository / "mine.py").read_text()
    (repository / "mine.py").write_text(text.replace("- damping * omega", "+ damping * omega"))
    status, out, _ = run(capsys, "mine.py:PENDULUM")
    assert status == 1
    assert "F_{omega,omega} = -›damping‹" in out or "F_{omega,omega} = ›-damping‹" in out
    (repository / FILE).write_text((repository / "generated" / "pendulum" / FILE).read_text())
    status, other, _ = run(capsys, "mine.py:PENDULUM", "--against", ".")
    assert status == 1 and other.splitlines()[2:] == out.splitlines()[2:]

    status, out, _ = run(capsys, "mine.py:PENDULUM", "--json")
    (found,) = json.loads(out)["models"]
    assert status == 1 and not found["same"] and json.loads(out)["study"] is None
    assert [(e["matrix"], e["entry"], e["before"], e["after"]) for e in found["entries"]] == [
        ("F", "omega by omega", "-damping", "damping"),
        ("f", "omega", "-damping*omega + _1", "damping*omega + _1"),
    ]
    assert found["where"] == {"_1": "-g*sin(theta)/length"}
    assert {c["function"] for c in found["operations"]} >= {"F", "Phi"}

    status, out, _ = run(capsys, "mine.py:PENDULUM", "--format", "html", "-o", "out/page.html")
    assert (status, out) == (1, "") and "<math" in (repository / "out" / "page.html").read_text()


def test_what_cannot_be_compared_is_refused_in_one_line(repository, capsys, monkeypatch):
    for words, message in (
        (["mine.py:PENDULUM", "--against", "HEAD~1"], "HEAD~1 has no generated/pendulum/equations.json"),
        (["mine.py:PENDULUM", "--against", "nowhere"], "there is no folder 'nowhere', and .* has no such revision"),
        (["mine.py:PENDULUM", "--against", "--all"], "there is no folder '--all'"),
        (["mine.py:PENDULUM", "--against", ".git"], "holds no equations.json of pendulum"),
        (["mine.py:PENDULUM", "--format", "pdf"], "no format 'pdf'"),
        (["mine.py:PENDULUM", "--study", "azimuth", "--against", "generated"], "needs a revision"),
    ):
        status, out, err = run(capsys, *words)
        assert (status, out, err.count("\n")) == (1, "", 1) and re.search(message, err), err
    monkeypatch.chdir("/")
    _, _, err = run(capsys, f"{repository / 'mine.py'}:PENDULUM")
    assert re.fullmatch(r"boresight: / lies in no git repository; .*\n", err)
    monkeypatch.setenv("PATH", "")
    _, _, err = run(capsys, f"{repository / 'mine.py'}:PENDULUM")
    assert re.fullmatch(r"boresight: git is not installed; .*\n", err)


def test_a_study_runs_in_the_tree_of_the_revision_and_in_this_one(tmp_path, monkeypatch):
    """A tree of its own, of which the command line prints what it says."""
    package = tmp_path / "boresight"
    package.mkdir()
    (package / "__init__.py").write_text("")
    source = "import json, sys\nprint(json.dumps({{'error': {}, 'same': [1, 2], 'words': sys.argv[1:]}}))\n"
    git(tmp_path, "init", "-q")
    for error in ("0.5", "0.75"):
        (package / "cli.py").write_text(source.format(error))
        git(tmp_path, "add", ".")
        git(tmp_path, "commit", "-qm", error)
    (package / "cli.py").write_text(source.format("0.25"))
    monkeypatch.setattr(side_by_side, "PACKAGE", tmp_path)
    monkeypatch.setattr(side_by_side.g, "model_names", list)
    flown = side_by_side.both_flown("sea --runs 2", "HEAD~1", lambda text: None)
    assert (flown["before"]["error"], flown["after"]["error"]) == (0.5, 0.25)
    assert flown["after"]["words"] == ["study", "sea", "--runs", "2", "--json"]
    assert git(tmp_path, "worktree", "list").count("\n") == 1, "the tree of the revision was left behind"
    title, table = side_by_side.report(flown, "HEAD~1")
    assert title.strip() == "study sea --runs 2: 1 of 8 results differ"
    assert [list(column.cells) for column in table.renderable.columns] == [["error"], ["0.5"], ["0.25"], ["-0.25"]]

    (package / "cli.py").write_text("import sys\nsys.exit('boresight: no such study')\n")
    with pytest.raises(side_by_side.BoresightError, match=r"^study sea of this tree: no such study$"):
        side_by_side.both_flown("sea", "HEAD", lambda text: None)
    assert git(tmp_path, "worktree", "list").count("\n") == 1
