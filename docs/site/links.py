"""The links of a built site: none is dead, and how many clicks lie between two pages."""

import os
import re
from collections import deque
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from html import unescape
from pathlib import Path
from urllib.parse import unquote

SCRIPT = re.compile(r"<(script|style)\b.*?</\1>", re.DOTALL)
ARTICLE = re.compile(r"<article.*</article>", re.DOTALL)
REFERENCE = re.compile(r'\b(?:href|src)="([^"]*)"')
IDENTITY = re.compile(r'\b(?:id|name)="([^"]+)"')
HOST = re.compile(r"(?:[a-z]+:)?//([^/?#]+)")


@dataclass(frozen=True)
class Site:
    """links: of each page the pages that its text leads to, menus left out.  dead: "page: target".  hosts: elsewhere.
    count: of all links within the site."""

    links: Mapping[str, frozenset[str]]
    dead: tuple[str, ...]
    hosts: frozenset[str]
    count: int


def read(folder: Path) -> Site:
    """Every link of every page below a folder."""
    texts = {path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8") for path in folder.rglob("*.html")}
    texts = {name: SCRIPT.sub("", text) for name, text in sorted(texts.items())}
    anchors = {name: frozenset(map(unescape, IDENTITY.findall(text))) for name, text in texts.items()}
    links: dict[str, frozenset[str]] = {}
    dead: list[str] = []
    hosts: set[str] = set()
    count = 0
    for name, text in texts.items():
        body = ARTICLE.search(text)
        own = set(REFERENCE.findall(body[0])) if body else set()
        to = set()
        for target in dict.fromkeys(REFERENCE.findall(text)):
            if elsewhere := HOST.match(target):
                hosts.add(elsewhere[1])
                continue
            if re.match(r"(data|mailto|javascript):", target):
                continue
            count += 1
            place, _, anchor = unquote(unescape(target)).partition("#")
            place = place.partition("?")[0]
            there = os.path.normpath(os.path.join(os.path.dirname(name), place)) if place else name
            if not (folder / there).is_file() or (anchor and there in anchors and anchor not in anchors[there]):
                dead.append(f"{name}: {target}")
            elif there in texts and target in own:
                to.add(there)
        links[name] = frozenset(to)
    return Site(links, tuple(dead), frozenset(hosts), count)


def clicks(links: Mapping[str, Collection[str]], start: str, wanted: Collection[str]) -> int | None:
    """The fewest clicks from a page to one of those that are wanted; None if none leads there."""
    far, waiting = {start: 0}, deque([start])
    while waiting:
        page = waiting.popleft()
        if page in wanted:
            return far[page]
        for other in links.get(page, ()):
            if other not in far:
                far[other] = far[page] + 1
                waiting.append(other)
    return None
