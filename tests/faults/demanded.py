"""Requirements drawn by a seed: the code that keeps each is deleted, and the test that the trace names has to be red.

    python tests/faults/demanded.py                      twenty of velocity-attitude
    python tests/faults/demanded.py euler-matching 40    forty of another model
    python tests/faults/demanded.py velocity-attitude VA-F-021 VA-F-036

Every statement that the trace says keeps the requirement is deleted in a copy of the generated C: a call, an assignment
or a check with its block; a function loses its body, a value that is returned or begun with is BS_OK or 0.  Each test
function then runs in a process of its own.  A line of the self-test is red where what it adds to the failures is not 0.
It ends with 1 where no named line is red, or more than two tests are that the trace does not name; but of an
elementary function, which every unit may call.
"""

import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from boresight.codegen import requirements
from boresight.codegen.folder import Folder
from boresight.runtime.manifest import generated

SEED, COUNT, OTHERS = 35, 20, 2
FLAGS = ("-std=c99", "-O1", "-w", "-ffp-contract=off")
LONGEST = 20  # s, of one test: what never ends is red
LOGGED = """#include <stdio.h>
static inline int logged(int line, int red)
{
    if (red != 0) {
        printf("RED %d\\n", line);
        fflush(stdout);
    }
    return red;
}
"""
CALLED = (r"(failures = )(?!0;)(.*?);\s*$", r"(failures \+= )(.*?);\s*$", r"(return failures \+ )(.*?);\s*$")
BEGUN = re.compile(r"^(\s*(?:const )?(bs_status|bs_msg_fate|bool|int|bs_real) \w+(\[\d+\])? =).*;\s*$", re.DOTALL)
NONE = {"bs_status": "BS_OK"}


def logging(text):
    """A self-test that prints each line which counts a failure; no line moves."""
    lines = text.split("\n")
    code = requirements.blank(text).split("\n")
    for number in requirements.check_lines(text):
        end = requirements.end_of_statement(code, number - 1) + 1
        if re.search(r"\+\+failures;", code[number - 1]):
            lines[number - 1] = lines[number - 1].replace("++failures;", f"failures += logged({number}, 1);")
            continue
        whole = "\n".join(code[number - 1 : end])
        for pattern in CALLED:
            whole, found = re.subn(pattern, rf"\1logged({number}, \2);", whole, count=1, flags=re.DOTALL)
            if found:
                lines[number - 1 : end] = whole.split("\n")
                break
    return "\n".join(["#define _POSIX_C_SOURCE 200809L", LOGGED, "#line 1", *lines])


def without(text, places):
    """The C without these statements."""
    lines = requirements.blank(text).split("\n")
    for place in places:
        span = slice(place.line - 1, place.end)
        whole, count = "\n".join(lines[span]), place.end - place.line + 1
        if re.match(r"(static |BS_INSIDE |bs_status |void |APART |size_t |int )", whole):  # a definition, at the margin
            head = whole[: whole.index("{") + 1]
            body = "\n    return BS_OK;\n" if "bs_status" in head.split("(")[0] else "\n"
            made = head + body + "}"
        elif whole.lstrip().startswith("return "):
            of = next(line for line in reversed(lines[: place.line]) if re.match(r"[a-zA-Z].*\w\(", line))
            made = "    return BS_OK;" if "bs_status" in of.split("(")[0] else "    return 0;"
        elif begun := BEGUN.match(whole):
            made = f"{begun[1]} {'{ 0 }' if begun[3] else NONE.get(begun[2], '0')};"
        else:
            made = "    ;"
        made += "\n" * (count - 1 - made.count("\n"))
        lines[span] = made.split("\n")
    return "\n".join(lines)


class Tried:
    """A folder built once, and built again where a fault is in it."""

    def __init__(self, folder, out):
        self.folder, self.out = folder, out
        self.files = {
            path.relative_to(folder.path).as_posix(): path.read_text()
            for path in (*folder.sources, *folder.files("include/*_identity.h"))
        }
        for path, text in self.files.items():
            (out / path).parent.mkdir(parents=True, exist_ok=True)
            (out / path).write_text(text)
        self.tests = [
            name
            for path in sorted(self.files)
            if path.startswith("selftest/")
            for name in re.findall(r"^int (test_\w+)\(void\)\n\{", self.files[path], re.MULTILINE)
        ]
        for path in self.files:
            if re.fullmatch(r"selftest/test_\w+\.c", path):
                (out / path).write_text(logging(self.files[path]))
        calls = "".join(f'    if (strcmp(of[1], "{name}") == 0) return {name}() != 0;\n' for name in self.tests)
        (out / "selftest/one.c").write_text(
            f'#include <string.h>\n#include "selftest.h"\nint main(int n, char **of)\n{{\n{calls}    return 2;\n}}\n'
        )
        runner = (out / "selftest/selftest.c").read_text().replace("int main(void)", "int all_of_them(void)")
        (out / "selftest/selftest.c").write_text(runner)
        self.objects = self.compiled([*out.glob("src/*.c"), *out.glob("selftest/*.c")])

    def compiled(self, sources):
        """Objects by source, two compilers at a time."""
        places = [f"-I{self.out / part}" for part in ("include", "src", "selftest")]
        made, running = {path: path.with_suffix(".o") for path in sources}, []
        for path in sources:
            running.append(subprocess.Popen(["gcc", *FLAGS, *places, "-c", path, "-o", made[path]]))
            if len(running) == 2:
                assert running.pop(0).wait() == 0, path
        assert not any(one.wait() for one in running)
        return made

    def red(self, changed):
        """By test that is red the lines of it that are; changed: path -> text."""
        for path, text in changed.items():
            (self.out / path).write_text(text)
        again = [
            path
            for path in self.objects
            if any(p.endswith(".h") for p in changed) or path.relative_to(self.out).as_posix() in changed
        ]
        objects = self.objects | self.compiled(again)
        program = self.out / "program"
        subprocess.run(["gcc", *objects.values(), "-lm", "-o", program], check=True)
        found = {}
        for name in self.tests:
            try:
                done = subprocess.run([program, name], capture_output=True, timeout=LONGEST, check=False)
                code, printed = done.returncode, done.stdout
            except subprocess.TimeoutExpired as ended:
                code, printed = -1, ended.stdout or b""
            if code:
                found[name] = [
                    int(line.split()[1]) for line in printed.decode().splitlines() if line.startswith("RED ")
                ]
        for path in changed:
            (self.out / path).write_text(self.files[path])
        self.objects |= self.compiled(again)
        return found


def judge(tried, one):
    """A line on a requirement whose code is deleted, and whether the trace held."""
    files = tried.files
    paths = dict.fromkeys(place.path for place in one.kept)
    changed = {path: without(files[path], [place for place in one.kept if place.path == path]) for path in paths}
    red = tried.red(changed)
    named = {requirements.test_of(place, files): [] for place in one.tried}
    for place in one.tried:
        named[requirements.test_of(place, files)].append((place.line, place.end))
    lines = {
        test: [line for line in dict.fromkeys(red.get(test, ())) if any(a <= line <= b for a, b in spans)]
        for test, spans in named.items()
    }
    crashed = [test for test in named if test in red and not red[test]]
    others = sorted(red.keys() - named)
    held = bool(any(lines.values()) or crashed) and (len(others) <= OTHERS or "-M-" in one.number)
    hit = [f"{test}:{','.join(map(str, found[:3]))}" for test, found in lines.items() if found]
    hit += [f"{test} ends at once" for test in crashed]
    deleted = "; ".join(f"{place.path}:{place.line}" for place in one.kept[:3]) + ("; ..." if len(one.kept) > 3 else "")
    return (
        held,
        f"{one.number}  deleted {deleted}  red {' '.join(hit[:4]) or 'NO NAMED LINE'}  others {', '.join(others) or 0}",
    )


def main():
    model, *given = sys.argv[1:] or ["velocity-attitude"]
    folder = Folder(generated() / model.replace("-", "_"))
    with tempfile.TemporaryDirectory() as out:
        tried = Tried(folder, Path(out))
        found = requirements.requirements(tried.files, folder.manifest)
        whole = sorted(number for number, one in found.items() if one.kept and one.tried)
        count = int(given[0]) if given and given[0].isdigit() else COUNT
        drawn = given if given and not given[0].isdigit() else random.Random(SEED).sample(whole, count)
        assert not tried.red({}), "the self-test is red as it is"
        held = 0
        for number in drawn:
            good, line = judge(tried, found[number])
            held += good
            print("held " if good else "NOT  ", line, flush=True)
    print(f"{held} of {len(drawn)} held, of {len(whole)} requirements that the self-test tries")
    return 0 if held == len(drawn) else 1


if __name__ == "__main__":
    sys.exit(main())
