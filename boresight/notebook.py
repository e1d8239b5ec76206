"""How a notebook shows models, equations and derivations: registered by the names of their types, which so import no
page."""

import sys
from typing import Any

SHOWN = (
    ("boresight.derive.model", "Model"),
    ("boresight.derive.ledger.equation", "Equation"),
    ("boresight.derive.ledger.equation", "Derivation"),
)


def register() -> None:
    """With the IPython shell that runs, if one does: nothing is imported before the first value is shown."""
    shell = sys.modules["IPython"].get_ipython()
    for form, made in (("text/html", html), ("text/latex", latex)) if shell else ():
        for module, name in SHOWN:
            shell.display_formatter.formatters[form].for_type_by_name(module, name, made)


def html(value: Any) -> str:
    from boresight.derive.pages import notebook

    return notebook.html(value)


def latex(value: Any) -> str:
    from boresight.derive.pages import notebook

    return notebook.latex(value)
