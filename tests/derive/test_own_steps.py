"""Derivations of a paper of one's own: each step is judged and carried out, and what does not follow is refused."""

import making as mk
import pytest

from boresight import BoresightError
from boresight.derive.ledger import passages
from boresight.derive.ledger.entries import ledger, unheld
from boresight.derive.ledger.equation import Passage
from boresight.derive.pages.render import render
from boresight.derive.papers.own import own

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
    (r"C - [\phi", r"C + [\phi", "(3), line 2, \\hat{C} = C + [\\phi \\times] C: halving the errors leaves 0.5"),
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
])  # fmt: skip
def test_what_does_not_follow_is_one_line(old, new, found, tmp_path):
    assert old in STEPS
    with pytest.raises(BoresightError) as raised:
        ledger(written(tmp_path, STEPS.replace(old, new, 1)))
    text = str(raised.value)
    assert found in text and "\n" not in text, text


def test_every_operation_may_be_named():
    makers = [value for name, value in vars(mk).items() if callable(value) and not name.startswith("_")
              and getattr(value, "__annotations__", {}).get("return") in (Passage, "Passage")]  # fmt: skip
    words = {"add", "add_line", "subtract_line", "identify", "solve_for", "stack"}
    made = {maker("1") if maker.__name__ in words else maker({}) if maker.__name__ in ("differentiate", "elsewhere")
            else maker(1, 1) if maker.__name__ == "take_entry" else maker() for maker in makers}  # fmt: skip
    assert {one.operation for one in made} == set(passages.OPERATIONS)
