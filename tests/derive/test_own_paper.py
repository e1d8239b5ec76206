"""A paper of one's own: a folder of letters, bound to a scenario by name, and of equations as printed."""

import json
import re
import shutil
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest
from conftest import ROOT
from tools import needs

from boresight import BoresightError, cli, kept_ledger
from boresight.derive.ledger.dimensions import listed
from boresight.derive.ledger.entries import entry_of, findings, ledger, unheld
from boresight.derive.ledger.equation import Relation, letter, negative
from boresight.derive.ledger.judge import judge
from boresight.derive.ledger.latex import latex_name
from boresight.derive.ledger.mends import mends, same
from boresight.derive.ledger.mutation import free_values
from boresight.derive.ledger.mutation import mutants as all_mutants
from boresight.derive.ledger.numbers import digits
from boresight.derive.ledger.reader import read
from boresight.derive.ledger.witness import draw
from boresight.derive.pages import notebook, witnesses
from boresight.derive.pages.booklet import pdf_from_latex
from boresight.derive.pages.page import notation
from boresight.derive.pages.plain import wrapped
from boresight.derive.pages.render import render
from boresight.derive.papers import PAPERS, paper
from boresight.derive.papers.displays import displays
from boresight.derive.papers.own import own
from boresight.derive.papers.scenarios import SCENARIOS

pytestmark = pytest.mark.usefixtures("many_digits")

FOLDER = ROOT / "examples" / "papers"
EXAMPLES = sorted(path.name for path in FOLDER.iterdir() if path.is_dir())
# What the planted slips are instead of.
RIGHT = {
    ("first", "2"): r"\delta\dot{\theta} = -[\omega \times] \delta\theta - \delta b - n_g",
    ("quaternion-error-state", "6b"): r"\delta\dot{v} = -\hat{R} [a_m - \hat{a}_b]_\times \delta\theta "
    r"- \hat{R} \delta a_b - \hat{R} a_n",
    ("quaternion-error-state", "6c"): r"\delta\dot{\theta} = -[\omega_m - \hat{\omega}_b]_\times \delta\theta "
    r"- \delta\omega_b - \omega_n",
    ("gnss-ins-ecef", "2.6"): r"\delta\dot{v}^e = G^e \delta r^e - 2 [\omega_{ie}^e \times] \delta v^e "
    r"+ [f^e \times] \psi^e + C_b^e (\delta b_a + n_a)",
    ("gnss-ins-ecef", "2.13"): r"z_r = \delta r^e + [(C_b^e l^b) \times] \psi^e - n_r",
    ("square-root-update", "A.4"): r"k = \alpha S^- \varphi",
    ("square-root-update", "A.8"): r"P^+ = (I - k h) P^- (I - k h)^T + k r k^T",
}
FIRST_ORDER = {
    "first": "",
    "quaternion-error-state": "5a 5b 7 8a 8b",
    "gnss-ins-ecef": "2.4 2.7 2.12 2.15",
    "square-root-update": "",
}


def planted(name):
    data = tomllib.loads((FOLDER / name / "paper.toml").read_text())
    return {number for number, more in data.get("equations", {}).items() if "planted" in more}


@pytest.mark.parametrize("name", EXAMPLES)
def test_of_each_example_the_planted_slips_are_errata_and_nothing_else(name):
    entries = {entry.number: entry for entry in ledger(own(FOLDER / name))}
    assert {number for number, entry in entries.items() if entry.status == "erratum"} == planted(name)
    assert len(planted(name)) == (1 if name == "first" else 2)
    assert {n for n, entry in entries.items() if entry.status == "first-order"} == set(FIRST_ORDER[name].split())
    assert all("Planted: " in entries[number].note for number in planted(name))


@pytest.mark.parametrize("name, number", RIGHT)
def test_the_right_form_of_a_planted_slip_is_true_and_among_the_first_three_mends(name, number):
    one = own(FOLDER / name)
    equation = one.equation(number)
    right = read((RIGHT[name, number],), equation.quantities)
    assert judge(one, equation, right).status in ("exact", "first-order")
    forms = [mend.relations for mend in mends(one, equation)[:3]]
    assert any(judge_same(one, equation, form, right) for form in forms)
    assert set(RIGHT) == {(name, number) for name in EXAMPLES for number in planted(name)}


def judge_same(one, equation, form, right):
    """Whether two forms have the same right side to first order: each set equal to the other stands."""
    sides = tuple(Relation((a.sides[1], b.sides[1])) for a, b in zip(form, right, strict=True))
    return form == right or judge(one, equation, sides).status in ("exact", "first-order")


@pytest.mark.parametrize("name", ["quaternion-error-state", "gnss-ins-ecef"])
def test_another_sign_of_any_term_of_what_is_true_is_refuted(name):
    one = own(FOLDER / name)
    true = [e for e in one.equations if entry_of(one, e).status in ("exact", "first-order")]
    count = 0
    for equation in true:
        for what, changed in all_mutants(equation.printed, equation.quantities):
            if what.startswith("sign of"):
                count += 1
                assert judge(one, equation, changed).status == "refuted", (equation.number, what)
    assert count >= 15


# ---- Mends of the errata of the papers -------------------------------------------------------------------------------

# Errata that differ from what is derived in more than one place, or by what is no single edit.
SEVERAL = {"song-lee-2001": "10", "kim-2018": "5 6 9 23 29", "kang-2025": "3 5"}


@pytest.mark.parametrize("name", PAPERS)
def test_where_one_edit_mends_a_misprint_the_derived_form_is_among_the_first_three(name):
    one = paper(name)
    errata = [e for e in one.equations if judge(one, e, e.read()).status == "refuted"]
    assert len(errata) > 3
    for equation in errata:
        first = [mend.relations for mend in mends(one, equation)[:3]]
        free = free_values(one, equation)
        found = any(form == equation.derived or same(form, equation.derived, free) for form in first)
        assert found != (equation.number in SEVERAL[name].split()), equation.number


def test_a_true_equation_of_another_sign_is_mended_by_that_sign():
    one = own(FOLDER / "quaternion-error-state")
    equation = one.equation("8b")
    left, right = equation.printed[0].sides
    wrong = (Relation((left, negative(right))),)
    found = mends(one, replace(equation, printed=wrong, derived=wrong))
    assert found[0].what.startswith("the other sign of") and len(found) == 1


# ---- The commands ----------------------------------------------------------------------------------------------------


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A copy of the first example, as the current folder's `mine`; nothing is kept of another test."""
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    shutil.copytree(FOLDER / "first", tmp_path / "mine")
    return tmp_path / "mine"


def run(capsys, *words):
    with pytest.raises(SystemExit) as ended:
        cli.main(list(words))
    return ended.value.code or 0, *capsys.readouterr()


def renumbered(folder, number):
    toml = folder / "paper.toml"
    toml.write_text(toml.read_text().replace('[equations."2"]', f'[equations."{number}"]'))
    tex = folder / "printed.tex"
    tex.write_text(tex.read_text().replace(r"\tag{2}", rf"\tag{{{number}}}"))


@pytest.mark.parametrize("number", ["2.14", "A.3", "12a", "3-7", "7'"])
def test_numbers_are_as_books_have_them(folder, capsys, number):
    renumbered(folder, number)
    for words in ((number,), (f"({number})",)):
        status, out, _ = run(capsys, "equations", "mine", *words)
        assert status == 0 and out.startswith(f"mine ({number}): erratum; kind sign\n")
    status, out, _ = run(capsys, "show", "mine", number)
    assert status == 0 and out.startswith(f"mine ({number})  erratum: sign  [printed.tex, line 7]")
    _, out, _ = run(capsys, "equations", "mine")
    assert "mine: 2 equations, 1 exact, 1 erratum" in out and "without a number" not in out
    status, _, err = run(capsys, "equations", "mine", "99")
    assert status == 1 and err == f"boresight: no equation '99'; there are 1, {number}\n"


def test_a_number_by_label_is_one_too_and_the_label_itself(folder, capsys):
    tex = folder / "printed.tex"
    tex.write_text(tex.read_text().replace(r"\tag{2}", r"\label{eq:2}"))
    assert [e.number for e in own(folder).equations] == ["1", "2"]
    tex.write_text(tex.read_text().replace("eq:2", "eq:rates").replace(r"\tag{1}", r"\tag{1} \label{eq:first}"))
    toml = folder / "paper.toml"
    toml.write_text(toml.read_text().replace('[equations."2"]', '[equations."rates"]'))
    for label, shown in (("rates", "rates"), ("eq:rates", "rates"), ("eq:first", "(1)"), ("1", "(1)")):
        for command in ("equations", "show"):
            status, out, _ = run(capsys, command, "mine", label)
            assert status == 0 and out.startswith(f"mine {shown}")


ROWS = {  # by their numbers what stands in printed.tex
    "1 two": r"\begin{align} x &= y \tag{1} \\ y &= x \label{eq:two} \end{align}",
    "1 2": r"\begin{align} x &= y \nonumber \\ &\quad + x \tag{1} \\[2pt] y &= x \tag{2} \\ &= x + y \end{align}",
    "3.1 3.2": r"\begin{eqnarray} x & = & y \label{3.1} \\ y & = & x \label{3.2} \end{eqnarray}",
    "5 6": r"\begin{gather} x = y \tag{5} \\ \begin{bmatrix} x \\ y \end{bmatrix} = y \tag{6} \end{gather}",
    "4a 4b 4c": r"\begin{subequations} \label{eq:4} \begin{align} x &= y \\ y &= x \end{align} \[ x = x + y \] "
    r"\end{subequations}",
    "4a X": r"\begin{subequations} \begin{align} x &= y \label{4a} \\ y &= x \tag{X} \end{align} \end{subequations}",
    "7": r"\begin{align} x &= y \\ y &= x \tag{7} \end{align}",
    "8": r"\begin{equation} \begin{split} x &= y \\ &\quad + x \end{split} \label{eqn:8} \end{equation}",
    "9": r"$$ x = y \eqno(9) $$",
}
LOST = {  # what is said where a number would be lost
    r"\begin{align} x &= y \tag{1} \\ y &= x \\ x &= x \tag{2} \end{align}": "1:33: this row has no number: add \\tag",
    r"\begin{align} x &= y \tag{1} \\ &= x \tag{2} \end{align}": "1:33: (2) begins with a sign: write its left side",
    r"\[ x = y \tag{1} y = x \tag{2} \]": "1:24: one equation is called 1 and 2: write align",
    r"\[ x = y \tag{1} \] \begin{dmath} y = x \tag{2} \end{dmath}": "1:41: this number stands in no display",
    r"\[ x = y \tag{\ref{a}'} \]": "1:10: this number cannot be read",
}


@pytest.mark.parametrize("numbers", ROWS)
def test_each_row_with_a_number_is_an_equation_and_none_is_lost(tmp_path, numbers):
    (tmp_path / "printed.tex").write_text(ROWS[numbers])
    found = list(displays(tmp_path / "printed.tex"))
    assert [one.number for one in found] == numbers.split()
    x, y = (letter(name, name, "s", "") for name in "xy")
    sides = [str(relation.sides[0]) for one in found for relation in read(one.latex, (x, y))]
    assert len(sides) == ROWS[numbers].count("=") - ROWS[numbers].count(r"&= x + y")


@pytest.mark.parametrize("latex", LOST)
def test_a_number_that_would_be_lost_is_asked_for(tmp_path, latex):
    (tmp_path / "printed.tex").write_text(latex)
    with pytest.raises(BoresightError) as refused:
        list(displays(tmp_path / "printed.tex"))
    assert f"printed.tex:{LOST[latex]}" in str(refused.value)


def test_rates_and_macros_are_read_as_they_are_typed(tmp_path):
    letters = {"v": r"{ latex = '\vel', value = 'v_n' }", "p": "{ latex = 'p^n', value = 'p_n' }"}
    rates = (
        r"\frac{d p^n}{dt}",
        r"\frac{d}{dt} p^{n}",
        "dp^n/dt",
        r"\frac{\mathrm{d} p^n}{\mathrm{d} t}",
        r"\rate{p^n}",
    )
    prints = {str(i): rf"\vel = {rate}" for i, rate in enumerate(rates)}
    prints["4"] = r"\newcommand{\rate}[1]{\dot{#1}} " + prints["4"] + " % \\def\\rate{x}\n"
    one = written(tmp_path, "motion", letters, prints, "[macros]\nvel = '\\mathbf{v}^n'\n")
    assert statuses(one) == dict.fromkeys("01234", "exact")
    tex = tmp_path / "printed.tex"
    tex.write_text(tex.read_text().replace(r"\vel = \rate", r"\vel + \unknown = \rate"))
    with pytest.raises(BoresightError, match=r"printed.tex:5:43: cannot read '\\unknown = \\rate"):
        own(tmp_path)


def test_the_rate_of_brackets_is_judged_in_numbers_units_and_frames_and_shown_as_it_is_printed(tmp_path):
    values = {"v": "v_n", "C": "C_b2n", "f": "f_b", "r": "p_n"}
    letters = {name: f"{{ latex = '{name}', value = '{value}' }}" for name, value in values.items()}
    prints = {"1": r"\frac{d}{dt}(C f) = \dot{C} f + C \dot{f}", "2": r"\frac{d}{dt}(C f) = C \dot{f} - \dot{C} f",
              "3": r"\frac{d}{dt}(v + v) = \dot{r}", "4": r"\frac{d}{dt}(C f) = \dot{f}"}  # fmt: skip
    one = written(tmp_path, "motion", letters, prints)
    assert statuses(one) == {"1": "exact", "2": "erratum", "3": "erratum", "4": "erratum"}
    assert [text for text in findings(one) if "do not fit" in text] == [
        "The units of (3) do not fit: m/s^2 and m/s.", "The frames of (4) do not fit: n and b.",
    ]  # fmt: skip
    assert "d/dt (C⋅f) = Ċ⋅f + C⋅ḟ" in render(one, "1", "text")
    assert r"\frac{d}{dt}(C f)" in render(one, "1", "latex")  # verbatim
    assert "<mfrac><mi>d</mi><mrow><mi>d</mi><mi>t</mi></mrow></mfrac>" in render(one, "1", "html")


def test_a_folder_without_a_paper_says_how_one_begins(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty").mkdir()
    for command in ("equations", "show"):
        status, _, err = run(capsys, command, "empty")
        assert status == 1
        assert err == "boresight: empty holds no paper.toml; 'boresight new NAME --kind paper' begins a paper\n"


def test_equations_say_what_is_true_what_not_with_numbers_and_how_it_is_mended(folder, capsys):
    _, out, _ = run(capsys, "equations", "mine", "2")
    flat = " ".join(out.split())
    assert "True with one edit: sign of [ω x] θ." in flat
    assert re.search(r"left \[[-\d., ]+\], right \[[-\d., ]+\], the sides differ by [\d.]+ deg/h", flat)
    assert "a point with the attitude error 0.001 rad" in flat
    assert "Note Planted: the first term has the other sign." in flat
    _, out, _ = run(capsys, "equations", "mine", "--json")
    first, second = json.loads(out)
    assert (first["status"], second["status"], second["origin"]) == ("exact", "erratum", "")


def test_a_ledger_is_kept_until_a_file_of_the_folder_changes(folder, capsys, monkeypatch):
    seen, compute = [], kept_ledger.compute
    monkeypatch.setattr(kept_ledger, "compute", lambda name, *more: seen.append(name) or compute(name, *more))
    for _ in range(2):
        run(capsys, "equations", "mine")
    assert seen == ["mine"]
    tex = folder / "printed.tex"
    tex.write_text(tex.read_text().replace("= [", "= -["))
    _, out, _ = run(capsys, "equations", "mine")
    assert seen == ["mine"] * 2 and "1 exact, 1 first-order" in out


# ---- Pages -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("form", ["text", "latex", "html"])
def test_a_page_has_nothing_that_is_not_of_the_paper(form):
    one = own(FOLDER / "first")
    page = " ".join(re.sub(r"<[^>]*>", " ", render(one, None, form)).split())
    for ours in ("tests/", "computed - true", "Units are SI", "papers write it", "Origin", "In C of"):
        assert ours not in page
    assert "Attitude error of a strapdown navigator, as commonly written" in page
    assert "2 equations: 1 exact, 1 erratum; 2 without a derivation." in page
    assert "An error is true - computed." in page
    assert "Mend 1 of 1" in page and "boresight equations" in page


def test_the_notation_has_each_letter_with_its_frame_and_its_unit():
    rows = {forms[0].relation.sides[0].name: (text, unit) for forms, text, unit in notation(own(FOLDER / "first")).rows}
    assert rows["θ"] == ("attitude error, in b", "rad")
    assert rows["θ̇"] == ("rate of θ", "rad/s")
    assert rows["w"] == ("rate of change of the gyro bias, in b", "rad/s^2")


def test_a_notebook_shows_an_equation_of_ones_own():
    one = paper(str(FOLDER / "first"))
    assert "<math" in notebook.html(one.equation("2"))


@needs("pdflatex")
def test_a_paper_of_ones_own_compiles():
    assert pdf_from_latex(render(own(FOLDER / "square-root-update"), None, "latex")).startswith(b"%PDF")


# ---- Other scenarios -----------------------------------------------------------------------------------------------


def written(tmp_path, witness, letters, equations, more=""):
    """A paper of letters and of equations by number."""
    rows = "\n".join(f"{json.dumps(name, ensure_ascii=False)} = {entry}" for name, entry in letters.items())
    (tmp_path / "paper.toml").write_text(f'title = "A"\nwitness = "{witness}"\n[letters]\n{rows}\n{more}')
    shown = (rf"\[ {latex} \tag{{{number}}} \]" for number, latex in equations.items())
    (tmp_path / "printed.tex").write_text("\n".join(shown))
    return own(tmp_path)


def statuses(one):
    return {entry.number: entry.status for entry in ledger(one)}


LEVEL = {
    "v": r"{ latex = 'v', value = 'v_n' }",
    "C": r"{ latex = 'C', value = 'C_b2n' }",
    "f": r"{ latex = 'f', value = 'f_b' }",
    "ω": r"{ latex = '\omega_{ib}', value = 'omega_ib_b' }",
    "ω_ie": r"{ latex = '\omega_{ie}', value = 'omega_ie_n' }",
    "ω_en": r"{ latex = '\omega_{en}', value = 'omega_en_n' }",
    "g": r"{ latex = 'g', value = 'gravity_n' }",
    "δv": r"{ latex = '\delta v', value = 'v_n_hat - v_n', unit = 'm/s' }",
    "δω_ie": r"{ latex = '\delta\omega_{ie}', value = 'omega_ie_n_hat - omega_ie_n', unit = 'rad/s' }",
    "δω_en": r"{ latex = '\delta\omega_{en}', value = 'omega_en_n_hat - omega_en_n', unit = 'rad/s' }",
    "δg": r"{ latex = '\delta g', value = 'gravity_n_hat - gravity_n', unit = 'm/s^2' }",
    "δf": r"{ latex = '\delta f', value = 'f_b_hat - f_b', unit = 'm/s^2' }",
    "δω": r"{ latex = '\delta\omega_{ib}', value = 'omega_ib_b_hat - omega_ib_b', unit = 'rad/s' }",
    "φ": r"{ latex = '\phi', value = 'phi' }",
    "ψ": r"{ latex = '\psi', value = 'psi' }",
    "φ̇": r"{ latex = '\dot{\phi}', value = 'rate(phi)', unit = 'rad/s' }",
    "L": r"{ latex = 'L', value = 'lat' }",
    "h": r"{ latex = 'h', value = 'height' }",
    "v_N": r"{ latex = 'v_N', value = 'v_n[NORTH]', unit = 'm/s' }",
    "M": r"{ latex = 'R_M', value = 'R_M' }",
}
LEVEL_PRINT = {
    "1": r"\dot{v} = C f + g - (2 [\omega_{ie} \times] + [\omega_{en} \times]) v",
    "2": r"\dot{C} = C [\omega_{ib} \times] - [(\omega_{ie} + \omega_{en}) \times] C",
    "3": r"\dot{L} = \frac{v_N}{R_M + h}",
    "4": r"\delta\dot{v} = [(C f) \times] \phi - [(2 \omega_{ie} + \omega_{en}) \times] \delta v "
    r"- [(2 \delta\omega_{ie} + \delta\omega_{en}) \times] v + \delta g + C \delta f",
    "5": r"\dot{\phi} = -[(\omega_{ie} + \omega_{en}) \times] \phi + \delta\omega_{ie} + \delta\omega_{en} "
    r"- C \delta\omega_{ib}",
    "6": r"\dot{\psi} = -[(\omega_{ie} + \omega_{en}) \times] \psi - C \delta\omega_{ib}",
    "7": r"\dot{\phi} = -[(\omega_{ie} + \omega_{en}) \times] \phi - \delta\omega_{ie} - \delta\omega_{en} "
    r"- C \delta\omega_{ib}",
    "8": r"\dot{\psi} = -[(\omega_{ie} + \omega_{en}) \times] \psi + C \delta\omega_{ib}",
}


@pytest.mark.parametrize("level, north", [("ned", 0), ("enu", 1)])
def test_strapdown_in_a_level_has_newtons_law_and_both_error_models(tmp_path, level, north):
    letters = {name: entry.replace("NORTH", str(north)) for name, entry in LEVEL.items()}
    found = statuses(written(tmp_path, f"strapdown-{level}", letters, LEVEL_PRINT))
    assert found == dict.fromkeys("123", "exact") | dict.fromkeys("456", "first-order") | dict.fromkeys("78", "erratum")


def test_a_lever_arm_and_a_delay_are_exact_or_of_first_order_in_the_delay(tmp_path):
    letters = {
        "v_1": "{ latex = 'v_1', value = 'v_n' }",
        "v_2": "{ latex = 'v_2', value = 'v_2_n' }",
        "a_1": "{ latex = 'a_1', value = 'a_n' }",
        "a_2": "{ latex = 'a_2', value = 'a_2_n' }",
        "C": "{ latex = 'C', value = 'C_b2n' }",
        "ω": r"{ latex = '\omega', value = 'omega_b' }",
        "l": "{ latex = 'l', value = 'lever_b' }",
        "τ": r"{ latex = '\tau', value = 'delay' }",
        "v_τ": r"{ latex = 'v_\tau', value = 'old(v_n)', unit = 'm/s' }",
    }
    prints = {
        "1": r"v_2 = v_1 + C [\omega \times] l",
        "2": r"a_2 = a_1 + C \left( [\dot{\omega} \times] + [\omega \times]^2 \right) l",
        "3": r"v_\tau = v_1 - \tau a_1",
        "4": r"v_\tau = v_1 + \tau a_1",
    }
    found = statuses(written(tmp_path, "motion", letters, prints))
    assert found == {"1": "exact", "2": "exact", "3": "first-order", "4": "erratum"}


def test_a_kalman_step_has_josephs_form_for_any_gain_and_factors(tmp_path):
    names = ["P", "H", "R", "S", "K", "P_plus", "K_any", "P_any", "I", "Phi", "Q", "P_next"]
    names += ["U", "D", "L", "U_plus", "D_plus"]
    b = {name: rf"\mathbf{{{name.replace('_', '-')}}}" for name in names}
    letters = {name: f"{{ latex = '{b[name]}', value = '{name}' }}" for name in names}
    left = f"({b['I']} - {b['K_any']} {b['H']})"
    prints = {
        "1": f"{b['S']} = {b['H']} {b['P']} {b['H']}^T + {b['R']}",
        "2": f"{b['K']} = {b['P']} {b['H']}^\\top {b['S']}^{{-1}}",
        "3": f"{b['P_plus']} = ({b['I']} - {b['K']} {b['H']}) {b['P']}",
        "4": f"{b['P_any']} = {left} {b['P']}",
        "5": f"{b['P_any']} = {left} {b['P']} {left}^{{\\mathrm T}} + {b['K_any']} {b['R']} {b['K_any']}^T",
        "6": f"{b['P_next']} = {b['Phi']} {b['P']} {b['Phi']}^T + {b['Q']}",
        "7": f"{b['P']} = {b['U']} {b['D']} {b['U']}^T = {b['L']} {b['L']}^T",
        "8": f"{b['P_plus']} = {b['U_plus']} {b['D_plus']} {b['U_plus']}^T",
    }
    one = written(tmp_path, "kalman", letters, prints)
    assert statuses(one) == dict.fromkeys("1235678", "exact") | {"4": "erratum"}
    assert "<math" in render(one, None, "html")


@pytest.mark.parametrize(("prints", "says"), [
    (("X = X + v",), r"\(1\) would define X by itself: write value"),
    (("X = Z + v", "Z = X - v"), r"\(1\) would define X by itself, through Z: write value"),
])  # fmt: skip
def test_what_is_defined_by_itself_is_asked_for(tmp_path, prints, says):
    letters = {"X": "{ latex = 'X', shape = 3 }", "v": "{ latex = 'v', value = 'v_n' }"}
    letters |= {"Z": "{ latex = 'Z', shape = 3 }"} if len(prints) > 1 else {}
    with pytest.raises(BoresightError, match=says):
        written(tmp_path, "motion", letters, {str(k + 1): one for k, one in enumerate(prints)})


def test_a_definition_of_another_shape_than_its_letter_is_refused(tmp_path):
    letters = {"J": "{ latex = 'J', shape = [3, 3] }", "v": "{ latex = 'v', value = 'v_n' }"}
    with pytest.raises(BoresightError, match=r"\(1\) gives J the shape \[3\], not \[3, 3\]"):
        written(tmp_path, "motion", letters, {"1": "J = 2 v"})


def test_a_step_is_taken_and_any_unit_is_said(tmp_path):
    letters = {
        "p": "{ latex = 'p', value = 'p_n' }",
        "p⁺": "{ latex = 'p^+', value = 'after(p_n)', unit = 'm' }",
        "v": "{ latex = 'v', value = 'v_n' }",
        "m": "{ latex = 'm', value = 'p_n[0]*p_n[1]', unit = 'm^2' }",
        "m⁺": "{ latex = 'm^+', value = 'after(p_n[0]*p_n[1])', unit = 'm^2' }",
        "T": "{ latex = 'T', value = 'step' }",
    }
    one = written(tmp_path, "motion", letters, {"1": "p^+ = p + T v", "2": r"m^+ = m + T \dot{m}", "3": "p = T v"})
    first, second, third = ledger(one)
    assert re.fullmatch(r"Its remainder is at most \S+ m\.", first.found)
    assert re.fullmatch(r"Its remainder is at most \S+ m\^2\.", second.found)
    assert third.status == "erratum" and re.search(r"right \[.*\], the sides differ by \S+ m$", third.evidence)


def test_what_depends_on_a_decision_says_on_which(tmp_path):
    """x is the velocity error and as much of it as the step is long: x = δv if the step is small too."""
    letters = {
        "δv": r"{ latex = '\delta v', value = 'v_n - v_hat', unit = 'm/s' }",
        "T": "{ latex = 'T', value = 'step' }",
        "x": r"{ latex = 'x', value = '(v_n - v_hat) + step*(v_n - v_hat)', unit = 'm/s' }",
    }
    (entry,) = ledger(written(tmp_path, "motion", letters, {"1": r"x = \delta v"}))
    assert entry.status == "first-order" and "Small: all errors" in entry.decisions
    more = '[equations."1"]\nsmall = ["velocity_error"]\n'
    (entry,) = ledger(written(tmp_path, "motion", letters, {"1": r"x = \delta v"}, more))
    assert entry.status == "erratum" and "first-order, if the step is small too" in entry.depends


def test_units_that_do_not_fit_are_named(tmp_path):
    letters = {
        "p": "{ latex = 'p', value = 'p_n' }",
        "v": "{ latex = 'v', value = 'v_n' }",
    }
    one = written(tmp_path, "motion", letters, {"1": "p = v"})
    assert one.findings() == ("The units of (1) do not fit: m and m/s.",)
    assert unheld(one)[0] == "Without a derivation, judged by the witness alone: (1)."


def test_what_is_said_beside_a_formula_is_left_out_and_listed(tmp_path):
    letters = {"x": "{ latex = 'x', value = '1.5' }", "y": "{ latex = 'y', value = '2.5' }"}
    equations = {
        "1": r"\max(x, y) = y \quad \text{for } x < 3",
        "2": r"x + \mathcal{O}(x^2) = 1.5",
        "3": r"\begin{aligned} x &= 1.5 + \cdots \\ \min(x, y) &= x, \text{ if } y > x \end{aligned}",
        "4": r"y = \max(x, y) + 1",
    }
    one = written(tmp_path, "motion", letters, equations)
    assert statuses(one) == dict.fromkeys("123", "exact") | {"4": "erratum"}
    texts = [text.partition("formula, ")[2] for text in unheld(one)]
    assert texts[:3] == ["'for x < 3'.", "'O(x^2)'.", "'..., if y > x'."]
    with pytest.raises(BoresightError, match=r"cannot read .*cdots"):
        written(tmp_path, "motion", letters, {"1": r"y = \cdots + x"})


def test_a_letter_without_a_unit_has_that_of_its_value_or_of_its_equation_or_none_that_is_known(tmp_path):
    letters = {
        "v": r"{ latex = 'v', value = '-v_n' }",
        "g": r"{ latex = 'g', value = 'gravity_n' }",
        "a": r"{ latex = 'a', shape = 3 }",
        "b": r"{ latex = 'b', shape = 3 }",
        "s": r"{ latex = 's', value = 'cross(omega_ib_b, lever_b)' }",
    }
    equations = {"1": "a = v", "2": "a = g", "3": "b = a + s", "4": "v = s"}
    one = written(tmp_path, "strapdown-ned", letters, equations)
    assert one.findings() == ("The units of (2) do not fit: m/s and m/s^2.",)
    assert 'No unit is known of b, s: write unit = "...".' in unheld(one)


@pytest.mark.parametrize(("value", "unit"), [
    ("v_n[0]", "m/s"), ("v_n_hat[1] - v_n[1]", "m/s"), ("eye(3)", "1"), ("-2*lat", "rad"), ("rate(C_b2n_hat)", "1/s"),
    ("rotation_vector(C_b2n)", "rad"), ("T(C_b2n)", "1"), ("C_b2n[0, 1]", "1"), ("sin(lat)", "1"), ("v_n/2", "m/s"),
    ("lat*height", "?"), ("cross(omega_ib_b, lever_b)", "?"),
])  # fmt: skip
def test_the_unit_of_a_value_is_known_where_it_is_plain(tmp_path, value, unit):
    one = written(tmp_path, "strapdown-ned", {"x": f"{{ latex = 'x', value = '{value}' }}"}, {"1": "x = x"})
    text = f" {value}" if unit == "?" else f"{value}, {unit}"
    assert one.quantities()[0].meaning.endswith(text.strip())
    ((_, meaning, shown),) = notation(one).rows
    assert (meaning, shown) == (value, "" if unit == "?" else unit)


def test_a_letter_and_its_marks_stay_on_one_line():
    text = "rate of φ̇ and δλ̇̂ " * 9
    for width in range(4, 40):
        lines = wrapped(text, width)
        assert all(len(line.translate(dict.fromkeys((0x302, 0x307)))) <= max(width, 4) for line in lines)
        assert not any(line.startswith(("\u0302", "\u0307")) for line in lines) and "".join(lines).count("λ̇̂") == 9


@pytest.mark.parametrize(("name", "latex"), [("C_b2n_hat", r"\hat{C}_{b}^{n}"), ("v_n_hat", r"\hat{v}_{n}"),
                                             ("x_hat", r"\hat{x}"), ("v_hat_n", r"\hat{v}_{n}")])  # fmt: skip
def test_a_hat_at_the_end_of_a_name_stands_on_its_letter(name, latex):
    assert latex_name(name) == latex


@needs("git")
def test_a_difference_outside_git_wants_another_folder_of_a_paper(folder, capsys):
    status, _, err = run(capsys, "diff", "mine")
    assert status == 1 and "lies in no git repository; name another folder of a paper with --against" in err


def test_one_equation_is_one(folder, capsys):
    tex = folder / "printed.tex"
    tex.write_text(tex.read_text().partition(r"\end{equation}")[0] + r"\end{equation}")
    toml = folder / "paper.toml"
    toml.write_text(toml.read_text().partition("[equations")[0])
    assert "mine: 1 equation, 1 exact" in run(capsys, "equations", "mine")[1]


@pytest.mark.parametrize("name", SCENARIOS)
def test_every_name_of_a_scenario_has_a_value_and_a_unit(name):
    scenario = SCENARIOS[name]
    with digits(60):
        values = scenario.values(draw(scenario.base, 3, scenario.sizes))
        for one, described in scenario.names.items():
            assert values[one] is not None and listed(described.unit) and described.meaning
    assert scenario.exact <= scenario.names.keys() and set(scenario.errors) <= set(scenario.base.__dataclass_fields__)


def test_the_reference_of_the_witnesses_is_made_of_the_scenarios_here():
    path = ROOT / "docs" / "reference" / "witnesses.md"
    assert path.read_text() == witnesses.page(), f"run python -m boresight.derive.pages.witnesses > {path}"


def test_a_product_that_is_a_number_is_one_in_a_root_and_before_a_vector(folder):
    toml, printed = folder / "paper.toml", folder / "printed.tex"
    toml.write_text(toml.read_text().replace("[letters]", """[letters]\n"v" = { latex = 'v', value = "v_n" }"""))
    lines = (r"\|v\| = \sqrt{v^T v} \tag{5}", r"(v^T v) v = v v^T v \tag{6}", r"\|v\| = 2 v^T v \tag{7}")
    with printed.open("a") as file:
        file.writelines(rf"\begin{{equation}} {line} \end{{equation}}" + "\n" for line in lines)
    found = {entry.number: entry.status for entry in ledger(own(Path("mine")))}
    assert found["5"] == found["6"] == "exact" and found["7"] == "erratum"


# ---- What is wrong in a file -----------------------------------------------------------------------------------------

VALUE = '"theta_local"'
BOUND = 'value = "theta_local", '
MEANING = 'meaning = "attitude error"'
TERM = r"[\omega \times] \delta\theta"
WRONG = [  # file, what stands there, what is written in its place, line and column, what is said
    ("paper.toml", 'title = "', "title = ", "4:9", "Invalid value"),
    ("paper.toml", "witness =", "wittness =", "6:1", "no key 'wittness' here (did you mean 'witness'?)"),
    ("paper.toml", '"motion"', '"moton"', "6:1", "no witness 'moton' (did you mean 'motion'?)"),
    ("paper.toml", VALUE, '"theta_locl"', "15:42", "motion has no 'theta_locl' (did you mean 'theta_local'?)"),
    ("paper.toml", VALUE, '"2 * rat(p_n)"', "15:46", "no function is called 'rat'"),
    ("paper.toml", VALUE, '"p_n +"', "15:42", "'p_n +' cannot be read: invalid syntax"),
    ("paper.toml", VALUE, '"p_n + delay"', "15:33", "the value of θ has no meaning: terms of two shapes"),
    ("paper.toml", VALUE, '"rate(rate(p_n))"', "15:47", "rate() within rate() is not to be had"),
    ("paper.toml", VALUE, '"old(v_hat)"', "15:46", "v_hat is exact at its own time only, and not in old()"),
    ("paper.toml", VALUE, '"θ + 1"', "15:42", "motion has no 'θ'"),
    ("paper.toml", VALUE, '"sqrt(-1)*p_n"', "15:33", "the value of θ has no meaning: the root of a negative number"),
    ("paper.toml", VALUE, '"p_n/0"', "15:33", "the value of θ is not finite"),
    ("paper.toml", VALUE, '"quaternion(p_n)"', "15:33", "the value of θ has no meaning: one of its functions"),
    ("paper.toml", VALUE, '["p_n"]', "15:33", "value must be a text"),
    ("paper.toml", MEANING, 'unit = "furlong"', "15:69", "furlong is 201.168 m; declare m"),
    ("paper.toml", MEANING, 'unit = "3 m, 3 rad"', "15:69", "θ has 6 x 1 units for the shape [3]"),
    ("paper.toml", MEANING, "meaning = 3", "15:69", "meaning must be a text"),
    ("paper.toml", "[letters]", "sizes = 3\n[letters]", "14:1", "sizes must be a table"),
    ("paper.toml", "planted =", 'small = "step"\nplanted =', "22:1", 'small must be a list, as ["step"]'),
    ("printed.tex", TERM, r"\begin{bmatrix} 1 & 2 \\ 3 \end{bmatrix} b", "8:63", "cannot read 'b"),
    ("printed.tex", TERM, r"(\delta\theta", "9:1", "(2) ends before a formula is whole"),
    ("printed.tex", r"\delta\dot{\theta} =", "", "7:17", "(2) sets nothing equal"),
    ("paper.toml", BOUND, "", "15:1", "θ has neither a value nor a shape: write value"),
    ("paper.toml", 'value = "omega_hat"', "shape = 3", "16:1", "ω of (2) has no value: write value"),
    ("paper.toml", r"latex = '\omega'", r"latex = '\delta\theta'", "16:1", "θ and ω are both written"),
    ("paper.toml", 'frame = "b"', 'farme = "b"', "15:56", "no key 'farme' here (did you mean 'frame'?)"),
    ("paper.toml", 'frame = "b"', 'frame = "b to n"', "15:56", "'b to n' is no frame of a vector"),
    ("paper.toml", "[letters]", '[computed]\nc = "d"\n[letters]', "15:1", "c stands for d, in which no letter is"),
    (
        "paper.toml",
        "[letters]",
        '[computed]\nc = "c"\n[letters]',
        "15:1",
        "c stands for 'c', which is no frame of its own",
    ),
    ("paper.toml", '[equations."2"]', '[equations."3"]', "21:1", "printed.tex has no equation '3'; it has 1, 2"),
    ("paper.toml", "planted =", 'small = ["step2"]\nplanted =', "22:1", "motion has no error 'step2' (did you mean"),
    ("paper.toml", "[letters]", "[sizes]\nattitude = -1\n[letters]", "15:1", "attitude must be a size"),
    ("printed.tex", r"n_g \tag{2}", r"n_x \tag{2}", "8:64", "cannot read 'n_x' in (2): no letter of paper.toml"),
    ("printed.tex", "- n_g", r"- \cdots", "8:64", r"cannot read '\cdots' in (2): of a sum that goes on only the end"),
    ("printed.tex", r"\tag{2}", "", "7:1", r"the equation has no number: add \tag{1}"),
    ("printed.tex", r"\tag{2}", r"\tag{1}", "7:1", "two equations are called 1; line 3 has the first"),
    ("printed.tex", r"\begin{equation}", "", "1:1", "no equation is displayed; write"),
    ("printed.tex", "- n_g", "- n_g^{999999999}", "8:68", "cannot read '{999999999}' in (2): a power above 100"),
    ("printed.tex", "- n_g", "- " + 999 * "(" + "n_g", "7:17", "(2) is nested too deeply to be read"),
    ("paper.toml", BOUND, "shape = [0, 600000], ", "15:33", "θ has the shape [0, 600000]; a size is 1 to 60"),
]


@pytest.mark.parametrize("file, old, new, place, says", WRONG)
def test_what_is_wrong_is_said_with_file_line_and_column(folder, file, old, new, place, says):
    path = folder / file
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1 if file == "paper.toml" else -1))
    with pytest.raises(BoresightError) as refused:
        ledger(own(Path("mine")))
    assert str(refused.value).startswith(f"mine/{file}:{place}: {says}") and "\n" not in str(refused.value)
