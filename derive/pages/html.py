"""A page as one HTML file that needs no other."""

import re
from collections.abc import Mapping
from xml.dom.minidom import Element, Text, parseString

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from boresight.derive.ledger.equation import Quantity, Relation
from boresight.derive.ledger.latex import latex_name
from boresight.derive.pages.blocks import NAME, REFERENCE, TYPED, Form, Formulas, Page, Pair, Prose, is_name
from boresight.derive.pages.mathml import mathml, mathml_relation


def html_page(page: Page) -> str:
    return _rendered("page.html.j2", page)


def html_cell(page: Page) -> str:
    """What a notebook shows: the sections alone, without a page around them."""
    return _rendered("cell.html.j2", page)


def _rendered(template: str, page: Page) -> str:
    loader = PackageLoader("boresight.derive.pages")
    environment = Environment(loader=loader, autoescape=True, undefined=StrictUndefined, keep_trailing_newline=True)

    def written(block: Prose) -> Markup:
        if block.code:
            return typed(block.text)
        return prose(block.text, page.anchors, page.letters)

    environment.filters |= {
        "math": math,
        "typed": typed,
        "prose": written,
        "cell": lambda value: prose(value, {}, page.letters) if isinstance(value, str) else letters(value),
        "short": lambda title: title.removeprefix(f"{page.name or page.title} "),
        "first_word": lambda text: re.split(r"\W", text)[0],
    }
    environment.tests |= {
        "prose": lambda block: isinstance(block, Prose),
        "formulas": lambda block: isinstance(block, Formulas),
        "pair": lambda block: isinstance(block, Pair),
    }
    return environment.get_template(template).render(page=page)


def math(form: Form) -> Markup:
    """The formula as pieces between which a line may end."""
    whole = mathml_relation(form.relation, form.quantities, form.marks)
    return Markup("<wbr>".join(map(spaced, pieces(whole.replace("&#x2061;", APPLY).replace("&#x2062;", TIMES)))))


def spaced(formula: str) -> str:
    """Browsers set nothing between factors, and nothing between a function and an argument without brackets."""
    return re.sub(rf"<mo>({TIMES}|{APPLY}(?!</mo>(?:<mrow>)?<mo[^>]*>\())</mo>", r'<mo rspace=".15em">\1</mo>', formula)


def pieces(formula: str) -> list[str]:
    """A formula cut before each =, + and - that stands in no bracket and not behind another, and before a matrix."""
    (whole,) = parseString(formula).childNodes
    row = whole.firstChild
    if not isinstance(row, Element) or row.tagName != "mrow" or row.hasAttribute("class"):
        return [formula]
    cuts: list[list[Element]] = [[]]
    depth, last = 0, "="
    for item in (child for child in list(row.childNodes) if isinstance(child, Element)):
        first = item.firstChild if item.hasAttribute("class") else item  # a marked term has its sign within
        begins = first if isinstance(first, Element) else item
        text = _glyph(item) or _glyph(begins)
        if depth == 0 and last not in SIGNS and (text in SIGNS or (text == "matrix" and last == TIMES)):
            cuts.append([])
        if text in SIGNS and not cuts[-1] and len(cuts) > 1:
            begins.setAttribute("form", "infix")
        depth += (text in ("(", "[")) - (text in (")", "]"))
        cuts[-1].append(item)
        last = _glyph(item)
    inside = ("".join(item.toxml() for item in cut) for cut in cuts)
    head = formula[: formula.index(">") + 1]
    return [f"{head}{content}</math>" for content in inside]


def _glyph(item: Element) -> str:
    """Of an operator what it shows; whether the rest is a matrix."""
    if item.tagName == "mo":
        return "".join(part.data for part in item.childNodes if isinstance(part, Text))
    return "matrix" if item.getElementsByTagName("mtable") else ""


SIGNS = ("=", "+", "−", "<", "≤")
APPLY, TIMES = "\u2061", "\u2062"


def typed(names: str) -> Markup:
    """Each as code, so that a line may end between them."""
    return Markup(", ").join(map(Markup("<code>{}</code>").format, names.split(", ")))


def letters(forms: tuple[Form, ...]) -> Markup:
    return Markup(", ").join(dict.fromkeys(map(math, forms)))


def prose(text: str, anchors: Mapping[str, str], letters: tuple[Quantity, ...]) -> Markup:
    """What names a section becomes a link to it, the name of a letter a formula, what is typed code."""
    parts, end = [], 0
    symbols = {quantity.symbol.name: quantity.symbol for quantity in letters}
    for found in re.finditer(rf"{TYPED.pattern}|{NAME.pattern}|{REFERENCE.pattern}", text):
        name = found.group()
        if found[1]:
            made = typed(found[1])
        elif name in anchors:
            made = Markup('<a href="#{}">{}</a>').format(anchors[name], name)
        elif name[0] != "(" and is_name(name):
            known = symbols.get(name)
            made = math(Form(Relation((known,)), letters)) if known else Markup(mathml(latex_name(name)))
        else:
            continue
        parts += [_plain(text[end : found.start()]), made]
        end = found.end()
    return Markup("").join([*parts, _plain(text[end:])])


def _plain(text: str) -> Markup:
    return Markup(re.sub(r"\^(-?\d+|T\b)", r"<sup>\1</sup>", str(escape(text))))
