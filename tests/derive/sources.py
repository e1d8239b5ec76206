"""The papers' texts, which are beside the checkout where they may be."""

from tools import SHARED, needs

FOLDER = SHARED / "papers"
NAMES = {
    "song-lee-2001": "song-lee-2001-euler-angle-matching.txt",
    "kim-2018": "kim-2018-azimuth-hold-zupt.txt",
    "kang-2025": "kang-2025-sea-state-transfer-alignment.txt",
}

needs_source = needs("papers")


def source(paper):
    """The lines of a paper's text."""
    return (FOLDER / NAMES[paper]).read_text(encoding="utf-8").splitlines()
