"""The files of a paper of one's own."""

from pathlib import Path

FILES = ("paper.toml", "printed.tex")
STEPS = "derivation.toml"  # of which there may be none
PYTHON = "witness.py"  # which is run where paper.toml names it as the witness


def holds_paper(folder: str) -> bool:
    """Whether a folder holds a paper."""
    return (Path(folder) / FILES[0]).is_file()
