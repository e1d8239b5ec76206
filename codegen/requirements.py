"""What the C of a folder demands of itself: where each requirement is stated, kept and tried, and with what result.

A number as [VA-F-012] stands in a comment: in a header behind the words that demand something, in the C beside the
statement that keeps it, in the self-test beside the lines that try it.  The list is read from there, and is no second
text.  A letter says which part: U a unit, B the box of a field, F the filter, C the covariance, D the digest, L the
live loop, M an elementary function, G how a measurement is taken, S a status.  What follows a point says whose it is,
where a model has several; so what is added later moves no number.
"""

import csv
import io
import re
from bisect import bisect
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
BRACKET = re.compile(r"[](){}[]")
NUMBER = re.compile(r"\[([A-Z]+-[A-Z]-\d{3}(?:\.\w+)*)\]")
FUNCTION = re.compile(r"^(?!typedef|enum|struct)[A-Za-z_][\w *]*?\b(\w+)\((?!.*;$)", re.MULTILINE)
CHECKS = re.compile(r"\bfailures = (?!0;)|\bfailures \+= |\+\+failures;|return failures \+ ")
STARTS = re.compile(r"(?:in|out) {2,}|returns |BS_\w+ {2,}")  # of a line that no other goes on in
SENTENCE = re.compile(r"(?<=\.) +(?=[A-Z])")
NAME = re.compile(r"#define (\w+)|(\w+)\(|(\w+)(?:\[[^\]]*\])* *[=;,]")  # what a line declares
RUNNER = ("selftest.c", "selftest.h", "cycles.c")  # which tries nothing by itself
# What a model's numbers may leave no way to try by its own functions, why, and who tries it.
UNTRIED = {
    "U-005": "no point of the self-test leads it to an end of its box; hostile calls do",
    "F-024": "no measurement has an innovation that could be so large, as of angles, which are at most pi, and of an R "
    "of at least 1e-30; mutants of the check are looked at",
    "F-057": "hostile calls with spoilt memory",
}
SHARED = "BS-"  # of all models: a folder has of these what its C keeps or tries


@dataclass(frozen=True)
class Place:
    """A statement: its first and last line, and the function that it stands in, if it does in one."""

    path: str
    line: int
    end: int
    function: str

    def __str__(self) -> str:
        return f"{self.function + ' ' if self.function else ''}{self.path}:{self.line}"


@dataclass
class Requirement:
    """text: the words of the header.  tested: the functions of the self-test that try it."""

    number: str
    text: str = ""
    equations: list[str] = field(default_factory=list)
    stated: list[Place] = field(default_factory=list)
    kept: list[Place] = field(default_factory=list)
    tried: list[Place] = field(default_factory=list)


@dataclass(frozen=True)
class Tag:
    """A comment with numbers: by number its words and its line, and the statement that it stands beside."""

    words: dict[str, str]
    lines: dict[str, int]
    place: Place


def blank(text: str) -> str:
    """Comments as spaces, so that places stay."""
    return COMMENT.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def end_of_statement(lines: list[str], begin: int) -> int:
    """The last line of the statement or definition that begins on this line; of lines without comments."""
    depth = 0
    for i in range(begin, len(lines)):
        line = lines[i].rstrip()
        if line.lstrip().startswith("#"):
            if i == begin:  # a macro
                return i
            continue
        depth += sum(1 if one in "({[" else -1 for one in BRACKET.findall(line))
        if depth <= 0 and line.endswith((";", "}")):
            return i
        if depth < 0:
            return max(begin, i - 1)
    return len(lines) - 1


def tags(text: str, path: str) -> list[Tag]:
    """The comments with numbers, each with the statement on its line, or else on the next line of code."""
    plain = blank(text)
    code, found = plain.split("\n"), []
    breaks = [one.start() for one in re.finditer("\n", text)]
    functions = {bisect(breaks, one.start()): one[1] for one in FUNCTION.finditer(plain)}
    ends = {begin: end_of_statement(code, begin) for begin in functions}
    for comment in COMMENT.finditer(text):
        numbers = list(NUMBER.finditer(comment[0]))
        if not numbers:
            continue
        begin = first = bisect(breaks, comment.start())
        while begin < len(code) - 1 and (not code[begin].strip() or (begin > first and code[begin].startswith("#"))):
            begin += 1
        inside = [name for line, name in functions.items() if line <= begin <= ends[line]]
        place = Place(path, begin + 1, end_of_statement(code, begin) + 1, inside[-1] if inside else "")
        lines = {number[1]: bisect(breaks, comment.start() + number.start()) + 1 for number in numbers}
        found.append(Tag(words(comment[0], code[begin]), lines, place))
    return found


def words(comment: str, declared: str) -> dict[str, str]:
    """By number the sentence or clause before it; declared: the line that the comment is of, which it tells of."""
    parts: list[str] = []
    ended = False
    for line in comment.removeprefix("/*").removesuffix("*/").split("\n"):
        line = re.sub(r"^\s*\* ?", "", line).strip()
        if not parts or (ended and not NUMBER.match(line)) or STARTS.match(line):
            parts.append(line)
        else:
            parts[-1] += " " + line
        ended = not line or line.endswith(".")
    of = NAME.search(declared)
    name = next(filter(None, of.groups()), "") if of else ""
    found: dict[str, str] = {}
    for part in parts:
        before = 0
        for number in NUMBER.finditer(part):
            clause = SENTENCE.split(" ".join(part[before : number.start()].split()))[-1].strip(" ,;")
            if not clause and before:  # a second number of the same words
                clause = list(found.values())[-1]
            elif clause and name:
                clause = f"{name}: {clause}"
            found[number[1]] = clause
            before = number.end()
    return found


def requirements(files: dict[str, str], manifest: dict[str, Any]) -> dict[str, Requirement]:
    """By number, all that a folder demands of itself; files: path below the folder -> text."""
    found: dict[str, Requirement] = {}
    for path in sorted(files):
        header = path.endswith(".h") and not path.startswith("selftest/")
        for tag in tags(files[path], path) if path.startswith(("include/", "src/", "selftest/")) else ():
            for number, text in tag.words.items():
                one = found.setdefault(number, Requirement(number))
                if path.startswith("selftest/"):
                    one.tried.append(tag.place)
                elif header and text:
                    line = tag.lines[number]
                    one.stated.append(Place(path, line, line, ""))
                    one.text = one.text or text
                else:
                    one.kept.append(tag.place)
    for one in found.values():
        one.equations = equations(one.number, manifest)
    return {
        number: found[number]
        for number in sorted(found)
        if not number.startswith(SHARED) or found[number].kept or found[number].tried
    }


def equations(number: str, manifest: dict[str, Any]) -> list[str]:
    """What a unit computes, or a measurement, by its equations; of a rule there is none."""
    kind, _, of = number.partition(".")
    if kind.endswith("-U-001"):
        return list(manifest["units"].get(of, {}).get("equations", ()))
    if kind.endswith("-F-100"):
        return list(manifest["measurements"].get(of, {}).get("equations", ()))
    return []


def untried(number: str) -> str:
    """Who tries what no self-test does."""
    return UNTRIED.get(number) or UNTRIED.get(number.split("-", 1)[1].split(".")[0], "")


def gaps(found: dict[str, Requirement]) -> list[str]:
    """What is not stated, not kept or not tried, a line each; but for what is known to be tried by others."""
    return [
        f"{one.number} is {what}"
        for one in found.values()
        for what, places in (("not stated", one.stated), ("not kept", one.kept), ("not tried", one.tried))
        if not places and not (what == "not tried" and untried(one.number))
    ]


def test_of(place: Place, files: dict[str, str]) -> str:
    """The test of the self-test's main program that a place of it belongs to: one a file."""
    (name,) = re.findall(r"^int (test_\w+)\(void\)", files[place.path], re.MULTILINE) or [""]
    return str(name)


def check_lines(text: str) -> Iterator[int]:
    """The lines of a self-test on which a statement begins that may count a failure, from 1."""
    code = blank(text).split("\n")
    for i, line in enumerate(code):
        if CHECKS.search(line):
            yield i + 1


def unnumbered(files: dict[str, str]) -> list[str]:
    """Lines of the self-test that may count a failure and are within no numbered statement or function."""
    found = []
    for path, text in sorted(files.items()):
        if path.startswith("selftest/") and path.endswith(".c") and Path(path).name not in RUNNER:
            spans = [(tag.place.line, tag.place.end) for tag in tags(text, path)]
            for line in check_lines(text):
                if not any(begin <= line <= end for begin, end in spans):
                    found.append(f"{path}:{line}")
    return found


# ---------------------------------------------------------------- the trace


def rows(found: dict[str, Requirement], files: dict[str, str], result: dict[str, str]) -> list[dict[str, str]]:
    """A row each; result: by function of the self-test what is known of it."""
    made = []
    by_path = {place.path: place for one in found.values() for place in one.tried}
    test = {path: test_of(place, files) for path, place in by_path.items()}
    for one in found.values():
        tests = list(dict.fromkeys(test[place.path] for place in one.tried))
        known = sorted({result[name] for name in tests if name in result})
        made.append(
            {
                "requirement": one.number,
                "text": one.text,
                "stated": joined(one.stated),
                "equation": "; ".join(one.equations),
                "kept": joined(one.kept),
                "tested by": "; ".join(tests),
                "tried": joined(one.tried),
                "result": "; ".join(known) if tests else f"no line of the self-test: {untried(one.number)}",
            }
        )
    return made


def back(found: dict[str, Requirement]) -> list[dict[str, str]]:
    """From each numbered statement of the C and of the self-test to its requirements."""
    by_place: dict[Place, list[str]] = {}
    for one in found.values():
        for place in (*one.kept, *one.tried):
            by_place.setdefault(place, []).append(one.number)
    ordered = sorted(by_place, key=lambda place: (place.path, place.line))
    return [
        {"file": p.path, "line": str(p.line), "function": p.function, "requirements": "; ".join(by_place[p])}
        for p in ordered
    ]


def joined(places: Iterable[Place]) -> str:
    return "; ".join(map(str, places))


def as_csv(table: list[dict[str, str]]) -> str:
    out = io.StringIO()
    writer = csv.DictWriter(out, list(table[0]) if table else [], lineterminator="\n")
    writer.writeheader()
    writer.writerows(table)
    return out.getvalue()
