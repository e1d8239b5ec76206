"""How often a loop of the C goes round at most is read from its text; here it is also run and counted."""

import re
import subprocess

import pytest

from boresight.codegen.folder import folders
from boresight.codegen.loops import loops

CONSTANT = """#define N 16
#define M (N - 3)
enum {
    ROWS = 5,
    COLUMNS = 7
};

void constant(void)
{
    for (int i = 0; i < N; ++i) {
        ;
    }
    for (int i = 0; i < (M * 2); i += 4) {
        ;
    }
    for (int j = M; j < N; ++j) {
        ;
    }
    for (int j = N - 1; j >= M; --j) {
        ;
    }
    for (int i = 0; (i < ROWS) && (i < COLUMNS); ++i) {
        ;
    }
    for (unsigned int t = 0U; t <= 6U; ++t) {
        ;
    }
    for (int j = 0; j < COLUMNS; ++j) {
        for (int i = 0; i <= j; ++i) {
            ;
        }
    }
}
"""
GIVEN = """void given(int n, const int *ends)
{
    int k = n;
    for (int i = 0; i < n; ++i) {
        ;
    }
    for (int i = ends[0]; i < ends[1]; ++i) {
        ;
    }
    for (int i = 0; i < 8; --k) {
        ++i;
    }
    for (int i = 0; (i < 8) || (k > 0); ++i) {
        --k;
    }
    while (k > 0) {
        --k;
    }
    for (; k < 8; ++k) {
        ;
    }
}
"""


def test_a_loop_of_constants_goes_round_as_often_as_it_is_said_to(tmp_path):
    """The largest count of each, by a counter that is begun before the loop and stands within it."""
    found = loops({"src/a.c": CONSTANT})
    k, lines = 0, []
    for line in CONSTANT.splitlines():
        begins = re.match(r"( *)for ", line)
        lines += (
            [f"{begins[1]}c[{k}] = 0;", line, f"++c[{k}]; m[{k}] = c[{k}] > m[{k}] ? c[{k}] : m[{k}];"]
            if begins
            else [line]
        )
        k += bool(begins)
    text = f"#include <stdio.h>\nstatic int c[{k}], m[{k}];\n" + "\n".join(lines)
    text += f'\nint main(void) {{ constant(); for (int i = 0; i < {k}; ++i) printf("%d\\n", m[i]); return 0; }}\n'
    (tmp_path / "a.c").write_text(text)
    subprocess.run(["gcc", "-w", tmp_path / "a.c", "-o", tmp_path / "a"], check=True)
    counted = subprocess.run([tmp_path / "a"], capture_output=True, text=True, check=True).stdout.split()
    assert [str(one.most) for one in found] == counted and {one.function for one in found} == {"constant"}


def test_of_a_loop_that_goes_by_what_it_is_given_no_bound_is_held():
    assert [one.most for one in loops({"src/a.c": GIVEN})] == [None] * 6


@pytest.mark.parametrize("name", ["strapdown", "velocity_dcm"])
def test_each_loop_of_a_folder_stands_in_a_function(name):
    (folder,) = (one for one in folders() if one.name == name)
    texts = {path.relative_to(folder.path).as_posix(): path.read_text() for path in folder.sources}
    found = loops(texts)
    ours = [text for path, text in texts.items() if path.startswith(("src/", "include/"))]
    count = sum(len(re.findall(r"^ +(?:for|while) \(", text, re.MULTILINE)) for text in ours)
    assert len(found) == count and all(one.function for one in found)
    assert sum(one.most is not None for one in found) > len(found) / 2
