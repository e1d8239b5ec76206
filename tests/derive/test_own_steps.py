"""Derivations of a paper of one's own: each step is judged and carried out, and what does not follow is refused."""

import re

import making as mk
import pytest
from conftest import ROOT
from tools import needs

from boresight import BoresightError, cli
from boresight.codegen.generate import load_model
from boresight.derive.ledger import passages
from boresight.derive.ledger.entries import ledger, unheld
from boresight.derive.ledger.equation import Passage
from boresight.derive.ledger.lines import standing
from boresight.derive.pages.booklet import pdf_from_latex
from boresight.derive.pages.render import render
from boresight.derive.papers.own import own
from boresight.derive.papers.own_map import tied

PAPER = r"""
title = "Attitude error in a level frame"
witness = "strapdown-ned"
[letters]
"C" = { latex = 'C', value = "C_b2n" }
"Ĉ" = { latex = '\hat{C}', value = "C_b2n_hat" }
"φ" = { latex = '\phi', value = "phi" }
"v" = { latex = 'v', value = "v_n" }
"f" = { latex = 'f', value = "f_b" }
"g" = { latex = 'g', value = "gravity_n" }
"ω_ie" = { latex = '\omega_{ie}', value = "omega_ie_n" }
"ω_en" = { latex = '\omega_{en}', value = "omega_en_n" }
"ω" = { latex = '\omega_{in}', value = "omega_in_n" }
"""
PRINT = r"""
\begin{equation} \dot{v} = C f + g - (2\omega_{ie} + \omega_{en}) \times v \tag{1} \end{equation}
\begin{equation} \dot{v} = C f + g - (\omega_{ie} + \omega_{in}) \times v \tag{2} \end{equation}
\begin{equation} \hat{C} - C = [\phi \times] C \tag{3} \end{equation}
"""
STEPS = r"""
[["2"]]
line = '\omega_{in} = \omega_{ie} + \omega_{en}'
claim = "exact"
why = "rates add"

[["2"]]
line = '\dot{v} = C f + g - (\omega_{ie} + \omega_{in}) \times v'
claim = "exact"
by = "substitute"
of = "(1)"
using = ["1"]
letters = ['\omega_{en}']
why = "(1), with the rate of n"

[["3"]]
why = "The computed axes are turned by a small angle."

[["3"]]
line = '\hat{C} = C - [\phi \times] C'
claim = "first-order"
small = ["attitude_error"]
why = "a small turn"

[["3"]]
line = '\hat{C} - C = -[\phi \times] C'
claim = "first-order"
small = ["attitude_error"]
by = "rearrange"
why = "C goes to the left"
result = true
"""


def written(folder, steps=STEPS):
    for name, text in (("paper.toml", PAPER), ("printed.tex", PRINT), ("derivation.toml", steps)):
        (folder / name).write_text(text, encoding="utf-8")
    return own(folder)


def test_a_misprint_is_found_by_its_own_derivation(tmp_path):
    one = written(tmp_path)
    entries = {entry.number: entry for entry in ledger(one)}
    assert [f"{e.status} {e.kind}".strip() for e in entries.values()] == ["exact", "exact", "erratum sign"]
    assert entries["3"].derived == r"\hat{C} - C = -[\phi \times] \, C"
    left = unheld(one)
    assert "Without a derivation, judged by the witness alone: (1)." in left
    assert "Of 5 steps 1 are prose, which proves nothing." in left
    page = render(one, "3", "text")
    assert "1. note: The computed axes" in page and "3. rearrange: C goes to the left." in page and "Origin" not in page


COMPACT = r"""
macros.rates = '\omega_{ie} + #1'

"2" = [
  { each = ['\omega_{en}'], claim = "exact", line = '\omega_{in} = \rates{#1}', why = "rates add" },
  { claim = "exact", by = "substitute", of = "(1)", using = ["1"], letters = ['\omega_{en}'], line = [
    '\dot{v} = C f + g',
    '- (\rates{\omega_{in}}) \times v',
  ], why = ["(1), with", "the rate of n"] },
]
"""


def test_steps_in_a_list_with_macros_are_those_written_out(tmp_path):
    one, other = (written(tmp_path, steps).equation("2").derivation.steps for steps in (STEPS, COMPACT))
    assert one == other and len(one) == 2


@pytest.mark.parametrize(("old", "new", "found"), [
    (r"= \omega_{ie} + \omega_{en}", r"= \omega_{ie} - \omega_{en}", "derivation.toml, (2), line 1, "),
    (r"C - [\phi", r"C + [\phi", "(3), line 2, `\\hat{C} = C + [\\phi \\times] C`: halving the errors leaves 0.5"),
    (r"'\hat{C} - C = -[\phi \times] C'", r"'C = \hat{C} + \frac{1}{2} [\phi \times] (C + \hat{C})'", "(3), line 3, "),
    ('of = "(1)"', 'of = "(3)"', "substitute: "),
    ('using = ["1"]', 'using = ["7"]', "substitute: line 7 does not stand before line 2"),
    ('"rearrange"', '"rearange"', "derivation.toml:29:1: step 3 of (3): 'rearange' is no operation (did you mean 're"),
    ('"first-order"', '"firstorder"', "step 2 of (3): 'firstorder' is no claim (did you mean 'first-order'?)"),
    ('["attitude_error"]', '["attitude"]', "step 2 of (3): the witness has no error 'attitude' (did you mean"),
    ('why = "rates add"', "", "derivation.toml:2:1: step 1 of (2): it has no why"),
    ('claim = "exact"\nwhy', "why", "step 1 of (2): it says of its line no claim; there are exact, definition,"),
    ("using", "usng", "step 2 of (2): no key 'usng' (did you mean 'using'?)"),
    ('using = ["1"]', 'using = "1"', "step 2 of (2): using must be a list"),
    ('[["3"]]', '[["33"]]', "step 1 of (33): printed.tex has no such equation; it has 1, 2, 3"),
    (r"\hat{C} = C - ", r"\hat{C} = \zeta - ", r"step 2 of (3): cannot read '\zeta - [\phi"),
    ('[["2"]]', '[["2"]', "derivation.toml:2:6: Expected"),
    ('[["2"]]', '"4" = 3\n[["2"]]', "derivation.toml:2:1: step 1 of (4): printed.tex has no such equation"),
])  # fmt: skip
def test_what_does_not_follow_is_one_line(old, new, found, tmp_path):
    """Of the equation alone whose step it is; what is of no equation there is refuses the paper."""
    assert old in STEPS
    try:
        one = written(tmp_path, STEPS.replace(old, new, 1))
        (text,) = [text for e in one.equations if (text := standing(one, e).refused)]
    except BoresightError as error:
        text = str(error)
        assert "no such equation" in text or "Expected" in text
    assert found in text and "\n" not in text, text


def test_a_derivation_that_does_not_stand_leaves_the_other_equations_their_statuses(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    later = '[["2"]]\nline = \'\\dot{v} = C f + g - (\\omega_{ie} + \\omega_{in}) \\times v\'\nclaim = "exact"\n'
    later += 'by = "rearrange"\nof = "(3)"\nwhy = "of what is refused"\n'
    one = written(tmp_path, STEPS.replace(r"C - [\phi", r"C + [\phi", 1) + later)
    found = {entry.number: entry for entry in ledger(one)}
    assert [entry.status for entry in found.values()] == ["exact", "exact", "erratum"]
    assert (
        found["2"].found.startswith("Its derivation is refused: ") and "By the witness alone: Both" in found["2"].found
    )
    assert "(3), line 2, " in found["3"].found and "True with one edit: " in found["3"].found
    assert "Its derivation is refused:" in render(one, "3", "text") and "rearrange" not in render(one, "3", "text")
    assert "Without a derivation, judged by the witness alone: (1), (2), (3)." in unheld(one)
    with pytest.raises(SystemExit) as ended:
        cli.main(["equations", "."])
    assert ended.value.code == 1 and "3 equations, 2 exact, 1 erratum" in capsys.readouterr().out


TURN = """title = "A turn"
witness = "strapdown-ned"
[letters]
"C" = { latex = 'C', value = "C_b2n" }
"Ĉ" = { latex = '\\hat{C}', value = "C_b2n_hat" }
"θ" = { latex = '\\theta', value = "-phi" }
"I" = { latex = 'I', value = "eye(3)" }
"""
RATES = r"""
[["1"]]
line = '\hat{C} = (I + [\theta \times]) C'
claim = "first-order"
why = "a small turn"
result = true

[["1"]]
line = '\dot{\hat{C}} = [\dot{\theta} \times] C + (I + [\theta \times]) \dot{C}'
claim = "first-order"
by = "differentiate"
letters = ['\hat{C}', '\theta', 'C']
with = ['\dot{\hat{C}}', '\dot{\theta}', '\dot{C}']
why = "by time"
"""


@pytest.mark.parametrize(("old", "new", "found"), [
    ("", "", ""),  # the rates stand in no row, and in no print
    (", 'C']", "]", ":13:1: step 2 of (1): 2 letters, and 3 in `with`: write in `with` for each of `letters` its rate"),
    (r"'\dot{C}']", r"'C \dot{t}']", r"differentiate: cannot read '\dot{t}' in 'C \dot{t}': write in `with` for each"),
    (r"'\dot{C}']", r"'C C']", r"differentiate: C C is no letter: write in `with` for each of `letters` its rate"),
    (r"letters = ['\hat{C}', '\theta', 'C']", "", r"differentiate needs letters = ['\delta x'], which it is about"),
    ('claim = "first-order"\nby', 'claim = "approximation"\nby', "an approximation needs dropped = '...', the whole"),
    (r"\hat{C} = (I", r"\hat{C} = Q (I", r"derivation.toml:3:19: step 1 of (1): cannot read 'Q (I + [\theta \times])'"),
])  # fmt: skip
def test_what_a_step_lacks_is_said_with_what_to_write(old, new, found, tmp_path):
    (tmp_path / "paper.toml").write_text(TURN, encoding="utf-8")
    (tmp_path / "printed.tex").write_text(r"\[ \hat{C} - C = [\theta \times] C \tag{1} \]")
    (tmp_path / "derivation.toml").write_text(RATES.replace(old, new, 1))
    one = own(tmp_path)
    (equation,) = one.equations
    text = standing(one, equation).refused
    assert found in text and bool(found) == bool(text), text


def test_every_operation_may_be_named():
    makers = [value for name, value in vars(mk).items() if callable(value) and not name.startswith("_")
              and getattr(value, "__annotations__", {}).get("return") in (Passage, "Passage")]  # fmt: skip
    words = {"add", "add_line", "subtract_line", "identify", "solve_for", "stack"}
    made = {maker("1") if maker.__name__ in words else maker({}) if maker.__name__ in ("differentiate", "elsewhere")
            else maker(1, 1) if maker.__name__ == "take_entry" else maker() for maker in makers}  # fmt: skip
    assert {one.operation for one in made} == set(passages.OPERATIONS)


@needs("pdflatex")
def test_the_page_of_a_refused_derivation_compiles(tmp_path):
    one = written(tmp_path, STEPS.replace(r"\hat{C} = C - ", r"\hat{C} = \zeta^2 φ_{k} - ", 1))
    assert pdf_from_latex(render(one, None, "latex")).startswith(b"%PDF")
    for form in ("text", "html"):
        assert r"\zeta^2 φ_{k}" in re.sub(r"<[^>]*>|\n *", "", render(one, "3", form))


def test_the_page_has_each_operation_with_what_it_needs():
    page = (ROOT / "docs" / "your-paper.md").read_text()
    table = re.search(r"\| operation \|.*?\n\n", page, re.DOTALL)[0]
    rows = [[re.findall(r"`([^`]*)`", cell) for cell in row.split("|")[1:4]] for row in table.splitlines()[2:] if row]
    assert sorted(name for names, _, _ in rows for name in names) == sorted(passages.OPERATIONS)
    for names, _, keys in rows:
        assert all(set(passages.NEEDS.get(name, ())) <= set(keys) for name in names), names


DEFINED = r"""
[["1"]]
line = 'S = \theta'
claim = "definition"
why = "a name"

[["1"]]
line = 'S = 2 \theta'
claim = "exact"
by = "rearrange"
why = "which is wrong"
result = true
"""
HANGING = r"""
\begin{equation} S = \theta \tag{1} \end{equation}
\begin{equation} W = [S \times] \tag{2} \end{equation}
\begin{equation} \hat{C} - C = W C \tag{3} \end{equation}
\begin{equation} \hat{C} - C = [\theta \times] C \tag{4} \end{equation}
"""


def test_a_definition_whose_derivation_is_refused_gives_what_it_prints_and_what_hangs_on_it_says_so(tmp_path):
    letters = "\"S\" = { latex = 'S', shape = 3 }\n\"W\" = { latex = 'W', shape = [3, 3] }\n"
    for name, text in (("paper.toml", TURN + letters), ("printed.tex", HANGING), ("derivation.toml", DEFINED)):
        (tmp_path / name).write_text(text, encoding="utf-8")
    found = {entry.number: entry for entry in ledger(own(tmp_path))}
    assert [entry.status for entry in found.values()] == ["definition", "definition", "first-order", "first-order"]
    assert "Its derivation is refused" in found["1"].found
    says = "(1) gives S as it is printed, since its derivation is refused."
    assert [says in entry.found for entry in found.values()] == [False, True, True, False]


def test_a_label_of_the_print_names_its_equation_wherever_its_number_may(tmp_path):
    labelled = PRINT.replace(r"\tag{1}", r"\tag{1} \label{eq:v}").replace(r"\tag{2}", r"\tag{2} \label{eq:w}")
    rows = '[equations."{}"]\nnote = "a note"\n[model]\nname = "euler-matching"\nstates = ["eps", "dmu"]\n'
    rows += 'noises = ["gyro_noise"]\nmatches = {{ "{}" = "A" }}\n'

    def of(one, other):
        steps = STEPS.replace('[["2"]]', f'[["{other}"]]').replace('of = "(1)"', f'of = "({one})"')
        texts = PAPER + rows.format(other, one), labelled, steps
        for name, text in zip(("paper.toml", "printed.tex", "derivation.toml"), texts, strict=True):
            (tmp_path / name).write_text(text, encoding="utf-8")
        return own(tmp_path)

    by_label, by_number = of("eq:v", "eq:w"), of("1", "2")
    assert by_label.equations == by_number.equations and by_label.equation("2").note == "a note"
    assert render(by_label, "eq:w", "text") == render(by_number, "2", "text")
    of("eq:v", "eq:w")
    with pytest.raises(BoresightError, match=r"paper.toml:20:13: 'A' is nothing that a model makes"):
        tied(tmp_path, load_model)  # where the label stands
    with pytest.raises(BoresightError, match=r"paper.toml:\d+:1: 'eq:w' and '2' are one equation"):
        of("1", 'eq:w"]\nnote = "another"\n[equations."2')
