"""A folder's C with its covariance in one form alone, as a user chooses it for an export.

What is generated has both forms, and the compiler chooses.  Here the text chooses: conditions on BORESIGHT_UD are
resolved, the functions of the other form go, then what nothing calls any more, what the headers say of it, and the
numbers of the requirements that stood there.
"""

import re
from collections.abc import Iterator

from boresight.codegen.functions.units import units
from boresight.codegen.reach import WORD, declared
from boresight.codegen.requirements import NUMBER, blank
from boresight.codegen.text.covariance import covariance_view, nonzeros
from boresight.codegen.text.covariance_vectors import vectors_view
from boresight.codegen.text.files import rendered
from boresight.codegen.text.layout import ENDS, MORE, laid_out
from boresight.codegen.text.views import model_view
from boresight.derive.model import Model

OTHER = {"joseph": "ud", "ud": "joseph"}
SHARED = re.compile(r"include/boresight\w*\.h")  # by all models of a program
CHOICE = re.compile(r"#if (?:(?P<before>.+) && )?(?P<no>!?)BORESIGHT_UD(?: && (?P<behind>.+))?$")
ONE_LINE = re.compile(r'\w+|extern "C" \{')  # which no semicolon ends
INSIDE = ("static ", "BS_INSIDE ", "APART ")  # how begins what another file does not know
EMPTY = (  # conditions with nothing between them
    (r"^#if[^\n]*\n\s*#endif[^\n]*\n\n?", ""),
    (r"^#else\n\s*(?=#endif)", ""),
    (r"^#ifdef (\w+)\n\s*#else\n", r"#ifndef \1\n"),
    (r"^#ifndef (\w+)\n\s*#else\n", r"#ifdef \1\n"),
    (r"^#if ([^\n]+)\n\s*#else\n", r"#if !(\1)\n"),
    (r"\n{3,}", "\n\n"),
)
BREAK = re.compile(r"\s*\n\s*\* *")  # between the lines of a comment
# What headers say of both forms, regular expressions between spaces; and what of Joseph's alone, and of factors.
WORDS = (
    (
        r"Two forms of the covariance P, with the same storage: \* joseph P itself; updates in Joseph form\. "
        r"For double\. \* ud P = (.*?) (\[\S+\]) For float\.",
        "The covariance is P itself; updates in Joseph form.",
        r"The covariance is P = \1 \2",
    ),
    (r"; joseph_predict P \| Phi P; ud_predict U \| V", "; joseph_predict P | Phi P", "; ud_predict U | V"),
    (r" The ud form overwrites v\.", "", "  It overwrites v."),
    (
        r" Neither ud_predict nor joseph_step reads what Q has",
        "  joseph_step does not read what Q has",
        "  ud_predict does not read what Q has",
    ),
    (
        r"In double the covariance is flown in symmetric Joseph form, in single precision \(BORESIGHT_FLOAT\) as UD "
        r"factors\.",
        "The covariance is flown in symmetric Joseph form.",
        "The covariance is flown as UD factors.",
    ),
    (
        r"; with UD also that P is positive semidefinite; with Joseph no more than the diagonal is claimed\.",
        "; of P no more than the diagonal is claimed.",
        "; P is positive semidefinite.",
    ),
    (
        r"The variances of the states; in UD none is finite that a number which is not has a part in\.",
        "The variances of the states.",
        "The variances of the states; none is finite that a number which is not has a part in.",
    ),
    (r"its covariance, in the form of the precision, see", "its covariance, see", "its covariance, see"),
)


def self_test(model: Model, form: str) -> dict[str, str]:
    """That of the covariance's functions, of one form."""
    made = units(model)
    A, B = (nonzeros(made, name) for name in (("F", "Qc") if model.F is not None else ("Phi", "Q")))
    c = covariance_view(model, made)
    v = vectors_view(model.n, A, B, model.order if model.F is not None else None, c["moving"])
    paths, words = ("selftest/test_PREFIX_covariance.c",), {"PREFIX": model.c_prefix}
    return rendered(paths, words, m=model_view(model, []), c=c, v=v, form=form)


def with_form(files: dict[str, str], prefix: str, form: str) -> dict[str, str]:
    """The files, path -> text, without the other form; those that all models share stay as they are."""
    made = dict(files)
    for path, text in files.items():
        if path.endswith((".c", ".h")) and not SHARED.fullmatch(path):
            left = needed(chosen(text, form == "ud"), prefix, form, path.endswith(".c"))
            made[path] = reworded(tidy(left) if left != text else text, form)
    return unnumbered(made, stated(files) - stated(made))


def chosen(text: str, ud: bool) -> str:
    """The lines that a compiler sees with this BORESIGHT_UD."""
    lines = []
    conditions: list[tuple[bool, bool]] = []  # whether its own lines stay, and those between them
    for line in text.split("\n"):
        stays = True
        if line.startswith("#if"):
            choice = CHOICE.match(line)
            holds = choice is None or ud != bool(choice["no"])
            more = choice and (choice["before"] or choice["behind"])
            stays = choice is None or bool(holds and more)
            line = f"#if {more}" if more and stays else line
            within, conditions = conditions, [*conditions, (stays, holds)]
        elif line.startswith(("#else", "#endif")):
            *within, (stays, held) = conditions
            conditions = [*within, (stays, held if stays else not held)] if line.startswith("#else") else within
        else:
            within = conditions
        if stays and all(seen for _, seen in within):
            lines.append(line)
    return "\n".join(lines)


def parts(text: str) -> Iterator[tuple[str, str]]:
    """What stands at the margin, in order, each with its kind: "comment", "code" (a declaration or a definition), "#"
    (of the preprocessor), or "" (a blank line)."""
    lines, plain = text.split("\n"), blank(text).split("\n")
    i = 0
    while i < len(lines):
        begin, kind = (
            i,
            "#" if lines[i].startswith("#") else "code" if plain[i].strip() else "comment" if lines[i] else "",
        )
        depth = 0  # of braces
        while kind == "code" and not ONE_LINE.fullmatch(plain[i].rstrip()):
            depth += plain[i].count("{") - plain[i].count("}")
            line = plain[i].rstrip()
            if line.startswith("}") or (line.endswith((";", "}")) and not depth):
                break
            i += 1
        while kind == "#" and lines[i].endswith("\\"):
            i += 1
        i += 1
        while i < len(lines) and lines[i] and not plain[i].strip() and not lines[i].lstrip().startswith("/*"):
            i += 1  # a comment that goes on
        yield kind, "\n".join(lines[begin:i])


def needed(text: str, prefix: str, form: str, source: bool) -> str:
    """Without the functions of the other form, and in a C file without what they alone use.

    What is numbered in such a function and nowhere else is kept by its counterpart.
    """
    found = list(parts(text))
    plain = [blank(part) for _, part in found]
    words = [frozenset(WORD.findall(part)) for part in plain]
    names = [
        declared(part) if kind in ("code", "#") else frozenset() for (kind, _), part in zip(found, plain, strict=True)
    ]
    other = f"{prefix}_{OTHER[form]}_"
    gone = removed = {k for k, named in enumerate(names) if any(name.startswith(other) for name in named)}
    while source and removed:
        used = frozenset[str]().union(*(words[k] - names[k] for k in range(len(found)) if k not in gone))
        hidden = {k for k, part in enumerate(plain) if names[k] and part.startswith(INSIDE)}
        removed = {k for k in hidden - gone if not names[k] & used}
        gone = gone | removed
    unsaid = gone | said_of(gone, found)
    kept = {k: part for k, (_, part) in enumerate(found) if k not in unsaid}
    for k, condition in narrowed(plain, names, gone).items():
        first = k - 1 if k - 1 in kept and found[k - 1][0] == "comment" else k
        kept[first] = f"{condition}\n{kept[first]}"
        kept[k] += "\n#endif"
    numbered = {number for part in kept.values() for number in NUMBER.findall(part)}
    for k in gone if source else ():
        lost = [number for number in NUMBER.findall(found[k][1]) if number not in numbered]
        heirs = {name.replace(other, f"{prefix}_{form}_") for name in names[k]} if lost else set()
        for of in kept:
            if heirs & names[of]:
                kept[of] = f"/* {' '.join(f'[{number}]' for number in lost)} */\n{kept[of]}"
    return "\n".join(kept.values())


def narrowed(plain: list[str], names: list[frozenset[str]], gone: set[int]) -> dict[int, str]:
    """What only some of the conditions that it is printed under need any more: by place, such a condition."""
    needs = list[dict[str, frozenset[str]]]()  # of each part: by word the conditions that all its lines stand under
    conditions, within = list[str](), list[frozenset[str]]()
    for part in plain:
        within.append(frozenset(conditions))
        needs.append({})
        for line in part.split("\n"):
            if line.startswith("#if"):
                conditions.append(line.rstrip())
            elif line.startswith("#else"):
                word, _, rest = conditions.pop().partition(" ")
                other = {"#ifdef": f"#ifndef {rest}", "#ifndef": f"#ifdef {rest}"}
                conditions.append(other.get(word, f"#if !({rest})"))
            elif line.startswith("#endif"):
                conditions.pop()
            for word in WORD.findall(line):
                needs[-1][word] = needs[-1].get(word, frozenset(conditions)) & frozenset(conditions)

    def common(k: int, out: set[int]) -> frozenset[str]:
        users = (i for i in range(len(plain)) if i not in out | {k})
        found = [needs[i][name] for i in users for name in names[k] if name in needs[i]]
        return frozenset.intersection(*found) - within[k] if found else frozenset()

    places = [k for k, part in enumerate(plain) if part.startswith(INSIDE) and k not in gone]
    more = {k: common(k, gone) - common(k, set()) for k in places}
    return {k: min(conditions) for k, conditions in more.items() if conditions}


def said_of(gone: set[int], found: list[tuple[str, str]]) -> set[int]:
    """The comments of what is gone: behind it nothing else follows without a blank line."""
    comments = set()
    for k, (kind, _) in enumerate(found):
        of = k + 1
        while of in gone:
            of += 1
        if kind == "comment" and of > k + 1 and (of == len(found) or found[of][0] in ("", "#")):
            comments.add(k)
    return comments


def tidy(text: str) -> str:
    before = ""
    while before != text:
        before = text
        for pattern, left in EMPTY:
            text = re.sub(pattern, left, text, flags=re.MULTILINE)
    return text


def reworded(text: str, form: str) -> str:
    """Comments that speak of this form alone."""
    text = re.sub(rf"^ \* {OTHER[form]}_predict  .*\n(?: \*  .*\n)*", "", text, flags=re.MULTILINE)
    for both, joseph, ud in WORDS:
        pattern = both.replace(r" \* ", " ").replace(" ", r"(?:\s+\* +|\s+)")
        found = re.search(pattern, text, re.DOTALL)
        if found:
            here = BREAK.sub(" ", found.expand(ud if form == "ud" else joseph))
            begin = text.rfind("\n", 0, found.start()) + 1
            line, *behind = (text[begin : found.start()] + here + text[found.end() :]).split("\n")
            while not line.endswith(ENDS) and MORE.match(behind[0]):
                line += " " + behind.pop(0).lstrip(" *")
            text = text[:begin] + "\n".join([laid_out(line), *behind])
    return text


def stated(files: dict[str, str]) -> set[str]:
    return {number for path, text in files.items() if path.startswith("include/") for number in NUMBER.findall(text)}


def unnumbered(files: dict[str, str], gone: set[str]) -> dict[str, str]:
    """Without these numbers, and without comments that held nothing else."""
    numbers = re.compile(rf" ?\[(?:{'|'.join(map(re.escape, sorted(gone)))})\]")
    made = {path: numbers.sub("", text) if gone else text for path, text in files.items()}
    nothing = re.compile(r"^ */\*\s*\*/\n|\s*/\*\s*\*/", re.MULTILINE)
    return {path: nothing.sub("", text) if text != files[path] else text for path, text in made.items()}
