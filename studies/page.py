"""A result as one HTML page that needs nothing beside it: the report, its pictures, and its numbers as JSON."""

import base64
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from boresight import __version__
from boresight.errors import need


def page(title: str, report: str, pictures: Iterable[tuple[str, Path]] = (), numbers: Any = None) -> str:
    """The page.

    report: Markdown.  pictures: caption and PNG or SVG file each; they are put inside.  numbers: what `json` can write;
    it stands in the element `numbers`, so that a program reads what a person sees.
    """
    need("replay")
    from jinja2 import Environment, FileSystemLoader, StrictUndefined
    from markdown_it import MarkdownIt

    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent),
        autoescape=True,
        undefined=StrictUndefined,
        keep_trailing_newline=True,
    )
    kinds = {".png": "image/png", ".svg": "image/svg+xml"}
    shown = [
        {"caption": text, "source": f"data:{kinds[path.suffix]};base64,{base64.b64encode(path.read_bytes()).decode()}"}
        for text, path in pictures
    ]
    return environment.get_template("page.html.j2").render(
        title=title,
        report=MarkdownIt("commonmark", {"html": False}).enable("table").render(report),
        pictures=shown,
        # "</script>" in a name would end the element
        numbers=None if numbers is None else json.dumps(numbers, indent=1, allow_nan=False).replace("<", "\\u003c"),
        version=__version__,
    )


def numbers_of(html: str) -> Mapping[str, Any]:
    """The numbers in a page that `page` wrote."""
    begin = html.index('<script type="application/json" id="numbers">')
    text: Mapping[str, Any] = json.loads(html[html.index(">", begin) + 1 : html.index("</script>", begin)])
    return text
