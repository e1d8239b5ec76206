"""The papers' texts, which are beside the checkout where they may be."""

import os
from pathlib import Path

import pytest

FOLDER = Path(__file__).resolve().parents[3] / "shared" / "papers"
NAMES = {
    "song-lee-2001": "song-lee-2001-euler-angle-matching.txt",
    "kim-2018": "kim-2018-azimuth-hold-zupt.txt",
    "kang-2025": "kang-2025-sea-state-transfer-alignment.txt",
}

# Where CI is true the texts must be there, and these tests fail without them.
needs_source = pytest.mark.skipif(
    not all((FOLDER / name).exists() for name in NAMES.values()) and os.environ.get("CI", "").lower() != "true",
    reason="the papers' texts are not beside the checkout",
)


def source(paper):
    """The lines of a paper's text."""
    return (FOLDER / NAMES[paper]).read_text(encoding="utf-8").splitlines()
