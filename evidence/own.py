"""`boresight evidence FILE.py:NAME`: the evidence of a model of one's own, by the tools that are here."""

from pathlib import Path

from boresight import BoresightError
from boresight.codegen import proof
from boresight.codegen.export import current_folder
from boresight.codegen.folder import Folder
from boresight.evidence.kind import kinds_for, make_all, stale

QUICK = ("guards", "golden", "coverage", "stack", "trace", "rounding", "riscv", "misra")


def make_own(target: str, quick: bool = False, generated: Path | None = None) -> Folder:
    """Make what is stale of the evidence of a model, beside its generated folder, for `export` to write.

    Parameters
    ----------
    target : str
        FILE.py:NAME; its C must have been generated and be what the model says now.
    quick : bool, optional
        Only what takes some three minutes: no mutants, Eva, hostile calls, nor `verify`.
    generated : Path, optional
        Where its C is, by default where `generate` puts it.

    Returns
    -------
    Folder
        The generated folder.

    Raises
    ------
    BoresightError
        A built-in model, whose evidence is kept with Boresight; C that is not what the model says
        now; a kind that could not be made, after the others were.
    """
    if ":" not in target:
        raise BoresightError(f"evidence of {target} comes with Boresight; 'boresight export {target}' writes it")
    folder = Folder(current_folder(target, generated).resolve(), target)
    kinds = [kind for kind in kinds_for(folder) if not quick or kind.name in QUICK]
    for kind in kinds:
        if kind.missing:
            print(f"{kind.name}: not made, {kind.missing}")
        elif not stale(folder, kind):
            print(f"{kind.name}: kept, of this C")
    failed = make_all((kind, folder) for kind in kinds)
    if failed:
        raise BoresightError(f"{failed} kinds of evidence could not be made of {target}; the others are kept")
    verdicts = proof.judged(folder, proof.kept(folder))
    print(f"{folder.name}: {proof.VERDICTS[min(map(proof.lowest, verdicts.values()))]}; it is in {proof.place(folder)}")
    return folder
