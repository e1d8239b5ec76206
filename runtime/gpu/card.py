"""A GPU of this machine, by its driver: machine code is loaded, numbers go there and come back."""

import functools
from pathlib import Path
from time import perf_counter
from types import TracebackType
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.errors import need
from boresight.runtime.array import Array
from boresight.runtime.gpu import text
from boresight.runtime.gpu.machine_code import machine_code

TOGETHER = 128  # threads of a block
KERNEL = b"boresight_kernel"
ELSE = "leave device out, and the processor flies"


@functools.cache
def card() -> "Card":
    """The first GPU that CUDA_VISIBLE_DEVICES leaves."""
    return Card()


class Card:
    """Raises BoresightError, in one line, where there is no driver or no GPU."""

    name = "the GPU"
    flown_s = 0.0

    def __init__(self) -> None:
        need("gpu")
        from cuda.bindings import driver

        self.driver = driver
        try:
            code, *_ = driver.cuInit(0)
        except Exception:  # of a kind of its own, and of another one in other versions
            raise BoresightError(f"no driver of an NVIDIA GPU is found here; {ELSE}") from None
        count = 0 if code else self.ask(driver.cuDeviceGetCount())
        if code or not count:
            raise BoresightError(f"no NVIDIA GPU is found here; {ELSE}")
        device = self.ask(driver.cuDeviceGet(0))
        self.name = self.ask(driver.cuDeviceGetName(128, device)).split(b"\0")[0].decode()
        kind = driver.CUdevice_attribute
        asked = (kind.CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR, kind.CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR)
        major, minor = (self.ask(driver.cuDeviceGetAttribute(one, device)) for one in asked)
        self.architecture = f"sm_{major}{minor}"
        self.context = self.ask(driver.cuDevicePrimaryCtxRetain(device))

    def ask(self, answer: tuple[Any, ...]) -> Any:
        """What a function of the driver gives behind its code."""
        code, *values = answer
        if code == self.driver.CUresult.CUDA_ERROR_OUT_OF_MEMORY:
            raise BoresightError(f"{self.name} has too little memory for these runs; give a chunk of fewer")
        if code:
            words = (self.driver.cuGetErrorString(code)[1] or b"").decode()
            raise BoresightError(f"{self.name} refuses a call: {words} (CUDA error {int(code)})")
        return values[0] if values else None

    @functools.lru_cache(maxsize=4)  # noqa: B019  a card is one of the process
    def kernel(self, folder: Path, experiment: Path, precision: str = "double") -> Any:
        """The function that flies a run in each thread, loaded."""
        self.ask(self.driver.cuCtxSetCurrent(self.context))  # of the thread that calls
        try:
            code = machine_code(text.device(folder, experiment, precision), self.architecture)
        except RuntimeError:  # of what looks for libraries
            raise BoresightError("NVRTC is not found; run pip install 'boresight[gpu]'") from None
        module = self.ask(self.driver.cuModuleLoadData(code))
        return self.ask(self.driver.cuModuleGetFunction(module, KERNEL))

    def needs(self, kernel: Any) -> dict[str, int]:
        """What a thread of it takes."""
        kind = self.driver.CUfunction_attribute
        registers, local = kind.CU_FUNC_ATTRIBUTE_NUM_REGS, kind.CU_FUNC_ATTRIBUTE_LOCAL_SIZE_BYTES
        asked = {"registers": registers, "bytes of local memory": local}
        return {name: self.ask(self.driver.cuFuncGetAttribute(one, kernel)) for name, one in asked.items()}

    def fly(
        self, kernel: Any, given: Array, seed: int, runs: range, columns: int, together: int = TOGETHER
    ) -> tuple[Array, Array]:
        """Final states (len(runs), columns) and statuses of neighbouring runs; `flown_s` is how long the card flew."""
        driver, n = self.driver, len(runs)
        self.ask(driver.cuCtxSetCurrent(self.context))
        rows, status = np.empty((n, columns)), np.empty(n, np.uint8)
        with Room(self, given.nbytes) as a, Room(self, rows.nbytes) as b, Room(self, status.nbytes) as c:
            self.ask(driver.cuMemcpyHtoD(a.at, given.ctypes.data, given.nbytes))
            words = np.array([int(a.at), seed, runs.start, n, columns, int(b.at), int(c.at)], np.uint64)
            each = np.array([words[i:].ctypes.data for i in range(len(words))], np.uint64)
            blocks, begun = -(-n // together), perf_counter()
            self.ask(driver.cuLaunchKernel(kernel, blocks, 1, 1, together, 1, 1, 0, 0, each.ctypes.data, 0))
            self.ask(driver.cuCtxSynchronize())
            self.flown_s = perf_counter() - begun
            self.ask(driver.cuMemcpyDtoH(rows.ctypes.data, b.at, rows.nbytes))
            self.ask(driver.cuMemcpyDtoH(status.ctypes.data, c.at, status.nbytes))
        return rows, status


class Room:
    """Memory of a card, which is given back."""

    def __init__(self, card: Card, size: int):
        self.card, self.at = card, card.ask(card.driver.cuMemAlloc(size))

    def __enter__(self) -> "Room":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self.card.driver.cuMemFree(self.at)
