"""A Dask cluster for `runtime.runs`: the model travels to its workers by the hash of its files and is built there."""

import hashlib
import io
import os
import shutil
import zipfile
from collections.abc import Iterator
from concurrent.futures import CancelledError, Executor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from boresight.errors import BoresightError, need
from boresight.runtime.manifest import cache_folder, read_manifest

need("cluster")

from distributed import Client, KilledWorker, WorkerPlugin  # noqa: E402
from distributed.client import FutureCancelledError  # noqa: E402
from distributed.comm import CommClosedError, resolve_address  # noqa: E402

CONNECT_S = 10
RETRIES = 10  # of a piece whose worker is gone


def packed(folder: Path) -> tuple[str, bytes]:
    """Hash and contents of a generated folder: what its manifest lists, and the manifest."""
    names = sorted({*read_manifest(folder)["files"], "manifest.json"})
    digest, out = hashlib.sha256(), io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in names:
            content = (folder / name).read_bytes()
            digest.update(name.encode() + b"\0" + hashlib.sha256(content).digest())
            archive.writestr(name, content)
    return digest.hexdigest(), out.getvalue()


def unpacked(digest: str) -> Path:
    """Where a model that travelled here lies."""
    return cache_folder() / "travelled" / digest


class Model(WorkerPlugin):  # type: ignore[misc]
    """Each worker, one that comes later too, unpacks the model; its first piece builds it, and is not waited for."""

    def __init__(self, digest: str, contents: bytes):
        self.name, self.digest, self.contents = f"boresight-{digest}", digest, contents

    def setup(self, worker: Any) -> None:
        folder = unpacked(self.digest)
        if not (folder / "manifest.json").exists():
            aside = folder.with_name(f".{self.digest}.{os.getpid()}")
            with zipfile.ZipFile(io.BytesIO(self.contents)) as archive:
                archive.extractall(aside)
            try:
                aside.rename(folder)
            except OSError:  # another worker of this machine was first
                if not (folder / "manifest.json").exists():
                    raise
                shutil.rmtree(aside)


@contextmanager
def connected(address: str, folder: Path) -> Iterator[tuple[Executor, str, int]]:
    """What submits to the cluster, the model's hash there, and how many pieces to keep under way."""
    try:
        resolve_address(address)  # a client that fails on the form of its address prints a traceback at the end
        client = Client(address, timeout=CONNECT_S, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        raise BoresightError(f"no Dask scheduler answers at {address!r} ({type(error).__name__})") from None
    with client:
        digest, contents = packed(folder)
        client.register_plugin(Model(digest, contents))
        threads = sum(client.nthreads().values())
        if not threads:
            raise BoresightError(f"the cluster at {address!r} has no worker; start one with 'dask worker {address}'")
        try:
            with client.get_executor(pure=False, retries=RETRIES) as executor:
                yield executor, digest, 4 * threads
        except (KilledWorker, CancelledError, FutureCancelledError, CommClosedError) as error:
            raise BoresightError(
                f"the cluster at {address!r} is gone, or its workers are killed ({type(error).__name__}); the same "
                "command goes on"
            ) from None
