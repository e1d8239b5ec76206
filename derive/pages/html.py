"""A page as one HTML file that needs no other."""

import re
from collections.abc import Mapping

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape
from sympy import Symbol

from boresight.derive.ledger.equation import Quantity, Relation
from boresight.derive.pages.blocks import NAME, REFERENCE, Form, Formulas, Page, Pair, Prose, is_name
from boresight.derive.pages.mathml import mathml_relation


def html_page(page: Page) -> str:
    loader = PackageLoader("boresight.derive.pages")
    environment = Environment(loader=loader, autoescape=True, undefined=StrictUndefined, keep_trailing_newline=True)
    anchors = page.anchors

    def written(block: Prose) -> Markup:
        if block.code:
            return Markup(", ").join(Markup("<code>{}</code>").format(name) for name in block.text.split(", "))
        return prose(block.text, anchors, page.letters)

    environment.filters |= {
        "math": math,
        "prose": written,
        "cell": cell,
        "short": lambda section: section.title.removeprefix(f"{page.title} "),
        "first_word": lambda text: re.split(r"\W", text)[0],
    }
    environment.tests |= {
        "prose": lambda block: isinstance(block, Prose),
        "formulas": lambda block: isinstance(block, Formulas),
        "pair": lambda block: isinstance(block, Pair),
    }
    return environment.get_template("page.html.j2").render(page=page)


def math(form: Form) -> Markup:
    return Markup(mathml_relation(form.relation, form.quantities, form.marks))


def cell(value: str | tuple[Form, ...]) -> str:
    return value if isinstance(value, str) else Markup(", ").join(dict.fromkeys(map(math, value)))


def prose(text: str, anchors: Mapping[str, str], letters: tuple[Quantity, ...]) -> Markup:
    """What names a section becomes a link to it, the name of a letter a formula."""
    parts, end = [], 0
    symbols = {quantity.symbol.name: quantity.symbol for quantity in letters}
    for found in re.finditer(rf"{NAME.pattern}|{REFERENCE.pattern}", text):
        name = found.group()
        if name in anchors:
            made = Markup('<a href="#{}">{}</a>').format(anchors[name], name)
        elif name[0] != "(" and is_name(name):
            made = math(Form(Relation((symbols.get(name) or Symbol(name),)), letters))
        else:
            continue
        parts += [escape(text[end : found.start()]), made]
        end = found.end()
    return Markup("").join([*parts, escape(text[end:])])
