"""A notebook shows a model as its page, though no model imports a page: by IPython's own lookup of a type's name."""

import subprocess
import sys

import pytest
from conftest import ROOT
from tools import needs

# IPython is where a notebook runs before a user imports anything; a stand-in of its two functions where it is missing.
STAND_IN = """
import sys, types

class Formatter(dict):
    def for_type_by_name(self, module, name, made):
        self[module, name] = made

    def __call__(self, value):
        made = self.get((type(value).__module__, type(value).__name__))
        return made and made(value)

formatters = {"text/html": Formatter(), "text/latex": Formatter()}
shell = types.SimpleNamespace(display_formatter=types.SimpleNamespace(formatters=formatters))
sys.modules["IPython"] = types.SimpleNamespace(get_ipython=lambda: shell)
"""
IPYTHON = """
import sys
from IPython.core.interactiveshell import InteractiveShell

formatters = InteractiveShell.instance().display_formatter.formatters
"""
CELLS = """
import boresight
assert not {"sympy", "jinja2"} & set(sys.modules)
from boresight.derive.models import built_in
from boresight.derive.papers import paper
model, equation = built_in("strapdown"), paper("delay-error").equations[0]
assert "boresight.derive.pages.notebook" not in sys.modules
for value in (model, equation, equation.derivation):
    assert "<math" in formatters["text/html"](value), value
for value in (built_in("phi-error"), equation, equation.derivation):
    assert "gathered" in formatters["text/latex"](value), value
assert formatters["text/html"](model.structs[0]) is None
"""


@pytest.mark.parametrize(
    "before", [pytest.param(STAND_IN, id="stand-in"), pytest.param(IPYTHON, id="IPython", marks=needs("IPython"))]
)
def test_a_notebook_shows_models_equations_and_derivations(before):
    done = subprocess.run([sys.executable, "-c", before + CELLS], cwd=ROOT, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr


def test_where_no_notebook_runs_nothing_is_registered():
    code = "import sys, boresight; assert 'boresight.notebook' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True, timeout=60)
