"""The proofs that Gappa writes, checked by Coq.

Gappa states its hints on quotients without proof.  Here each becomes a lemma that follows by field arithmetic, and a
proof counts as accepted only if Coq ends well and names no assumption but those of its real numbers.
"""

import hashlib
import json
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from boresight.codegen.functions.tape import Tape
from boresight.derive.model import Variable
from boresight.evidence.proofs import kept
from boresight.evidence.proofs.prover import QUIET, Unproved, written

MISSING = "" if shutil.which("coqc") else "coqc is not installed"
LARGEST = 200  # operations of a list whose proofs are checked
HOURS = 2.0  # of processor time in all
SECONDS = 600.0  # for one proof
HINT = re.compile(r"^Hypothesis (a\d+) : (.*)\.$", re.MULTILINE)
ENDED = "End Generated_by_Gappa."
# a / b - c / d in every shape that a script may ask for
LEMMAS = """Require Import Reals.
Lemma both (a b c d : R) : (b <> 0 -> d <> 0 -> a / b - c / d = (a - c) / b - c / b * ((b - d) / d))%R.
Proof. intros; field; auto. Qed.
Lemma divisor (b c d : R) : (b <> 0 -> d <> 0 -> c / b - c / d = - (c / b * ((b - d) / d)))%R.
Proof. intros; field; auto. Qed.
Lemma dividend (a b c : R) : (b <> 0 -> a / b - c / b = (a - c) / b)%R.
Proof. intros; field; auto. Qed.
"""
PROVED = r"""Lemma \1 : \2.
Proof. intros; first [apply both | apply divisor | apply dividend]; assumption. Qed."""
# What Coq's library of real numbers itself assumes.
REALS = {
    "ClassicalDedekindReals.sig_not_dec",
    "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
}
ASSUMED = re.compile(r"^([\w.]+)\s*:", re.MULTILINE)


def version() -> str:
    if MISSING:
        return MISSING
    printed = subprocess.run(["coqc", "--version"], capture_output=True, text=True).stdout
    return printed.splitlines()[0].strip()


def proof(tape: Tape, position: int, args: tuple[Variable, ...], claimed: float) -> str:
    """A Coq file whose last lemma is the claimed bound.  Raises Unproved where Gappa does not prove it."""
    made = written(tape, position, args, SECONDS)
    computed, exact = made.pairs[position]
    asked = f"{computed} - {exact} in [{(-claimed).hex()}, {claimed.hex()}]"
    # a warning amid the proof would be no Coq: standard output holds the proof alone
    done = subprocess.run(
        ["gappa", *QUIET, "-Bcoq"], input=made.question(asked), capture_output=True, text=True, timeout=SECONDS
    )
    if done.returncode != 0 or ENDED not in done.stdout:
        raise Unproved("Gappa writes no proof of it")
    return LEMMAS + HINT.sub(PROVED, done.stdout) + "\nPrint Assumptions l1.\n"


def accepts(text: str, seconds: float = SECONDS) -> bool:
    """Whether Coq accepts the file, and its last lemma assumes nothing of its own."""
    if "Hypothesis" in text:  # a premise of the last lemma that nobody proves
        return False
    with tempfile.TemporaryDirectory() as place:
        path = Path(place) / "bound.v"
        path.write_text(text)
        try:
            done = subprocess.run(["coqc", "-q", path], capture_output=True, text=True, timeout=seconds, cwd=place)
        except subprocess.TimeoutExpired:
            return False
        _, _, assumed = done.stdout.rpartition("Axioms:")
        return done.returncode == 0 and path.with_suffix(".vo").is_file() and set(ASSUMED.findall(assumed)) <= REALS


class Accepted:
    """What Coq has accepted so far, by the hash of the file; kept beside the other results."""

    def __init__(self) -> None:
        self.path = kept.PLACE / "coq" / "accepted.json"
        self.seconds: dict[str, float] = {}
        if self.path.is_file():
            before = json.loads(self.path.read_text())
            self.seconds = before["seconds"] if before["tool"] == version() else {}

    @property
    def hours(self) -> float:
        return sum(self.seconds.values()) / 3600

    def check(self, text: str) -> bool:
        key = hashlib.sha256(text.encode()).hexdigest()[:16]
        if key not in self.seconds:
            start = sum(os.times()[2:4])  # of the processes that were started
            if not accepts(text):
                return False
            self.seconds[key] = round(sum(os.times()[2:4]) - start, 1)
            self.path.parent.mkdir(parents=True, exist_ok=True)
            entry = {"tool": version(), "seconds": self.seconds}
            self.path.write_text(json.dumps(entry, indent=1, sort_keys=True) + "\n")
        return True
