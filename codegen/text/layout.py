"""The layout of generated C.  A template writes a comment, a prototype or a call on one line, however long; here it is
broken so that no line ends beyond the width.  Rows of tables of numbers stay as they are."""

import re
import textwrap

WIDTH = 100
COMMENT = re.compile(r" *(/(?=\*)|(?=\* ))")
TRAILING = re.compile(r"( *)(.*\S) +(/\* .* \*/)")
FARTHEST = 60  # column at which a comment may begin behind code
ENDS = (".", ":", "*/", "]")  # where the words of a comment's line do not go on in the next one
MORE = re.compile(r" *\* (?!in {2}|out {2}|returns )")
HANGING = re.compile(
    r"\* ( *BS_\w+ +as [a-z ]+? {2,}|(in|out) {2,}\S+ +|\w+ {2,})"
)  # further lines stand below the meaning
FACTORS = r"(?:\(?[a-zA-Z]'? )*(?![-+=/] )(?:\S*\[\w+ x\]\S*|\S+)(?: C_\w+)?"
FORMULA = rf"(?<!\S){FACTORS}(?: [-+=/] {FACTORS}){{1,3}}"
WHOLE = re.compile(  # formulas, units, ranges and the end are not torn
    rf"(?:{FORMULA}|\((?:[^()]|\(\w*\)){{1,30}}\)|[-+.\de]+ to \S+|\S+(?= \*/$))(?: \*/$)?"
)
PROTOTYPE = re.compile(r"\w[\w *]*\(.*\);?")
BREAK = re.compile(r"(?<=[,;]) | (?=: )|(?<=\|\|) |(?<=&&) |(?<= [-+*]) ")


def laid_out(text: str) -> str:
    """C with lines of at most WIDTH columns, the same but for white space and where a comment stands."""
    lines: list[str] = []
    given = text.split("\n")[::-1]
    while given:
        line = given.pop()
        if len(line) <= WIDTH or is_row(line):
            lines.append(line)
            continue
        while COMMENT.match(line) and not line.endswith(ENDS) and given and MORE.match(given[-1]):
            line += " " + given.pop().lstrip(" *")
        lines += broken(line)
    return "\n".join(lines)


def is_row(line: str) -> bool:
    """Whether the line is one row of a table of numbers."""
    return line.startswith("    { ") and line.endswith((" }", " },"))


def broken(line: str) -> list[str]:
    begins, behind = COMMENT.match(line), TRAILING.fullmatch(line)
    if begins:
        return comment(line, begins.end())
    if behind and behind.start(3) < FARTHEST:
        return comment(line, behind.start(3) + 1)
    if behind:
        indent, code, words = behind.groups()
        return laid_out(f"{indent}{words}\n{indent}{code}").split("\n")
    if PROTOTYPE.fullmatch(line):
        return prototype(line)
    return fold(line, [len(line) - len(line.lstrip()) + 4])


def comment(line: str, star: int) -> list[str]:
    """The words of a comment whose first star is at column `star`, below each other."""
    hanging = HANGING.match(line, star)
    start = hanging.end() if hanging else star + 2
    whole = WHOLE.sub(lambda found: found[0].replace(" ", "\N{NO-BREAK SPACE}"), line[start:])
    below = " " * star + "*" + " " * (start - star - 1)
    lines = textwrap.wrap(
        whole,
        WIDTH,
        initial_indent=line[:start],
        subsequent_indent=below,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return [line.replace("\N{NO-BREAK SPACE}", " ") for line in lines]


def prototype(line: str) -> list[str]:
    """One parameter a line, below each other."""
    column = line.index("(") + 1
    places = [match for match, columns in breaks(line, [0]) if len(columns) == 2]
    starts = [column, *(match.end() for match in places)]
    ends = [*(match.start() for match in places), len(line)]
    parameters = [line[start:end] for start, end in zip(starts, ends, strict=True)]
    return [line[:column] + parameters[0], *(" " * column + parameter for parameter in parameters[1:])]


def fold(line: str, columns: list[int]) -> list[str]:
    """Code broken where the fewest brackets are open, as late as fits; it goes on below what the innermost bracket
    holds.  columns: where that is for each bracket that is open at the start, first that of the statement itself."""
    places = [(match, inner) for match, inner in breaks(line, columns) if inner[-1] < match.start() <= WIDTH]
    if len(line) <= WIDTH or not places:
        return [line] if len(line) <= WIDTH else torn(line, columns)
    match, inner = min(reversed(places), key=lambda place: len(place[1]))
    return [line[: match.start()], *fold(" " * inner[-1] + line[match.end() :], inner)]


def torn(line: str, columns: list[int]) -> list[str]:
    """Code whose string does not fit, as two strings below each other, which are one to a compiler."""
    cut = line.rfind(" ", 0, WIDTH - 1) + 1
    begin = line.rfind('"', 0, cut)
    if line.count('"', 0, cut) % 2 == 0 or cut == begin + 1:
        return [line]
    return [line[:cut] + '"', *fold(" " * begin + '"' + line[cut:], [*columns, begin])]


def breaks(line: str, columns: list[int]) -> list[tuple[re.Match[str], list[int]]]:
    """Where code may be broken, outside of strings, and where what each open bracket holds begins."""
    spaces = {match.start(): match for match in BREAK.finditer(line)}
    found, inner, quoted = [], list(columns), False
    for i, letter in enumerate(line):
        quoted ^= letter == '"'
        if quoted:
            continue
        if letter in "([{":
            inner.append(i + (2 if line.startswith("{ ", i) else 1))
        elif letter in ")]}" and len(inner) > 1:
            inner.pop()
        elif i in spaces:
            found.append((spaces[i], list(inner)))
    return found
