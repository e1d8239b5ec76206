"""`boresight evidence`: that of a model of one's own, or of what flies of a model, by the tools that are here."""

import shutil
from pathlib import Path

from boresight import BoresightError
from boresight.codegen import proof
from boresight.codegen.export import current_folder, part
from boresight.codegen.folder import Folder
from boresight.evidence.kind import Kind, kinds_for, make_all, stale

QUICK = ("guards", "golden", "coverage", "stack", "trace", "rounding", "riscv", "misra")
FEW = 6  # states; with more the emulated boards take minutes, and a quick run leaves them out
OF_THE_WHOLE = ("verified", "gpu", "bits")  # of a model, whatever of it flies


def make_own(
    target: str, quick: bool = False, generated: Path | None = None, only: tuple[str, ...] = (), form: str = ""
) -> Path:
    """Make what is stale of the evidence of a model, or of a part of one, for `export` to write.

    Parameters
    ----------
    target : str
        FILE.py:NAME; its C must have been generated and be what the model says now.  Of a built-in
        name the evidence is kept with Boresight, but for that of a part.
    quick : bool, optional
        Only what takes some three minutes: no mutants, Eva, hostile calls, nor `verify`; of more
        than six states no emulated Cortex-M either.
    generated : Path, optional
        Where its C is, by default where `generate` puts it.
    only, form : optional
        What flies of it, as for `export`.  What is known of the same text of the whole model is
        taken over.

    Returns
    -------
    Path
        Where it is kept: beside the generated folder, for a part of a built-in model in ./generated.

    Raises
    ------
    BoresightError
        A built-in model as a whole; C that is not what the model says now; a kind that could not be
        made, after the others were.
    """
    if only or form:
        with part(target, only, form, generated) as (folder, whole):
            of_whole = proof.place(Folder(whole))
            if of_whole.is_file() and not proof.place(folder).is_file():
                proof.place(folder).parent.mkdir(exist_ok=True)
                shutil.copy(of_whole, proof.place(folder))
            return made(folder, quick, OF_THE_WHOLE)
    if ":" not in target:
        raise BoresightError(f"evidence of {target} comes with Boresight; 'boresight export {target}' writes it")
    return made(Folder(current_folder(target, generated).resolve(), target), quick)


def chosen(folder: Folder, quick: bool) -> list[Kind]:
    """What is made of a folder; quick: in some three minutes."""
    many = len(folder.manifest.get("states", ())) > FEW
    quickly = {name for name in QUICK if name != "golden" or not many}
    return [kind for kind in kinds_for(folder) if not quick or kind.name in quickly]


def made(folder: Folder, quick: bool, left_out: tuple[str, ...] = ()) -> Path:
    """Where what is known of a folder is kept, once it is made."""
    kinds = [kind for kind in chosen(folder, quick) if kind.name not in left_out]
    for kind in kinds:
        if kind.missing:
            print(f"{kind.name}: not made, {kind.missing}")
        elif not stale(folder, kind):
            print(f"{kind.name}: kept, of this C")
    failed = make_all((kind, folder) for kind in kinds)
    if failed:
        raise BoresightError(f"{failed} kinds of evidence could not be made of {folder.target}; the others are kept")
    verdicts, place = proof.judged(folder, proof.kept(folder)), proof.place(folder)
    print(f"{folder.name}: {proof.VERDICTS[min(map(proof.lowest, verdicts.values()))]}; it is in {place}")
    return place
