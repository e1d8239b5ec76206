"""An emulated core that runs one function at a time; on a Cortex-M with exact instruction counts and stack."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from operator import add
from pathlib import Path
from typing import Any

import numpy as np

from boresight.errors import BoresightError, need
from boresight.evidence.targets import GROUPS, ROOM, RV32, Build, Run, recorded, symbol_table

STACK_TOP, STACK_SIZE = 0x2080_0000, 0x40_0000
RETURN = 0x3000_0000  # where the function that was called goes back to
PAINT, PAINTED = b"\xa5", 12 * 1024
REFILL = 3  # cycles at most from a branch to where it leads, on a Cortex-M4
ARM_FPU_ON, RISCV_FPU_ON = 0x00F0_0000, 0x6000


@dataclass
class Cost:
    """Of one public function over the calls that were watched: instructions with what it calls, bytes of stack below
    the caller's; words loaded and stored, divisions and square roots of the call with the most instructions; and how
    many cycles the dearest call takes at most on a Cortex-M4 without wait states, by that core's table."""

    calls: int = 0
    least: int = 0
    most: int = 0
    stack: int = 0
    loads: int = 0
    stores: int = 0
    divisions: int = 0
    roots: int = 0
    cycles: int = 0

    def add(self, counts: Sequence[int], stack: int) -> None:
        instructions, *classes, cycles = counts
        self.least = min(self.least, instructions) if self.calls else instructions
        if instructions > self.most:
            self.most = instructions
            self.loads, self.stores, self.divisions, self.roots = classes
        self.cycles = max(self.cycles, cycles)
        self.stack = max(self.stack, stack)
        self.calls += 1


@dataclass
class Frame:
    """A watched function that has not returned yet."""

    name: str
    back: int
    pointer: int  # stack pointer when it was entered
    counts: tuple[int, ...]  # before it was entered
    lowest: int


def accesses(first: int, second: int | None = None) -> tuple[bool, int]:
    """Whether an instruction of Thumb stores, or else loads, and how many words of memory it touches.

    second: the second half of a long one.
    """
    if second is None:
        kind = first >> 12
        if kind == 0b0101:
            return first >> 9 & 7 < 3, 1
        if kind == 0b0100 and first >> 11 & 1:
            return False, 1  # of a constant
        if 0b0110 <= kind <= 0b1001:
            return not first >> 11 & 1, 1
        if kind == 0b1100:
            return not first >> 11 & 1, (first & 0xFF).bit_count()
        if first >> 9 in (0b1011010, 0b1011110):  # push and pop
            return not first >> 11 & 1, (first & 0x1FF).bit_count()
        return False, 0
    store = not first >> 4 & 1
    if first & 0xFE40 == 0xE800:  # of many
        return store, second.bit_count()
    if first & 0xFE40 == 0xE840:  # of two, or a table of branches
        return store, 2 if first & 0x0120 else 1
    if first & 0xFE00 == 0xF800:
        return store, 1
    if first & 0xFE00 == 0xEC00 and second & 0x0E00 == 0x0A00 and first & 0x01A0:  # of floating-point registers
        many = first & 0x0120 != 0x0100
        return store, second & 0xFF if many else 1 + (second >> 8 & 1)
    return False, 0


def kind(first: int, second: int = 0) -> str:
    """What decides how long an instruction of Thumb takes beside the memory that it touches."""
    if first & 0xFFD0 == 0xFB90 and second & 0xF0F0 == 0xF0F0:
        return "division"
    if first & 0xFFE0 == 0xEC40 and second & 0x0E00 == 0x0A00:
        return "two registers"
    if first & 0xFF00 != 0xEE00 or second & 0x0E10 != 0x0A00:
        return ""
    operation = first & 0x00B0
    if operation == 0x0080:
        return "quotient"
    if operation == 0x00B0:
        return "root" if first & 0xF == 1 and second & 0xC0 == 0xC0 else "floating"
    return "accumulation" if operation in (0x0000, 0x0010, 0x0090, 0x00A0) else "floating"


# Beyond one for each instruction and each word of memory, as Arm's table for the Cortex-M4 has it, and with it that
# what waits for a floating-point result waits one cycle more.
LONGER = {"": 0, "division": 11, "two registers": 1, "quotient": 14, "root": 14, "accumulation": 3, "floating": 1}


@dataclass
class Machine:
    """One image, loaded.  After `call` nothing of a former call remains but what the program keeps itself."""

    made: Build
    image: Path
    watched: tuple[str, ...] = ()
    answering: tuple[str, ...] = ()  # watched, and counted where their status is 0 alone
    costs: dict[str, Cost] = field(default_factory=dict)

    def __post_init__(self) -> None:
        need("evidence")
        import unicorn as u
        from elftools.elf.elffile import ELFFile
        from unicorn import arm_const as arm
        from unicorn import riscv_const as riscv

        registers: Any
        if self.made.target is RV32:
            # the emulator's list of cores begins with one that has every extension
            architecture, mode, model = u.UC_ARCH_RISCV, u.UC_MODE_RISCV32, riscv.UC_CPU_RISCV32_ANY
            names, registers, self.thumb = ("PC", "SP", "RA", "A0"), riscv, 0
        elif self.made.target.double:
            # the emulator's Cortex-M7 has no double FPU; its largest core knows every instruction of FPv5
            architecture, mode, model = u.UC_ARCH_ARM, u.UC_MODE_THUMB, arm.UC_CPU_ARM_MAX
            names, registers, self.thumb = ("PC", "SP", "LR", "R0"), arm, 1
        else:
            architecture, mode = u.UC_ARCH_ARM, u.UC_MODE_THUMB | u.UC_MODE_MCLASS
            model = arm.UC_CPU_ARM_CORTEX_M4
            names, registers, self.thumb = ("PC", "SP", "LR", "R0"), arm, 1
        family = "RISCV" if registers is riscv else "ARM"
        self.pc, self.sp, self.lr, self.r0 = (getattr(registers, f"UC_{family}_REG_{name}") for name in names)
        self.core = u.Uc(architecture, mode)
        self.core.ctl_set_cpu_model(model)
        with self.image.open("rb") as file:
            elf = ELFFile(file)
            segments = [s for s in elf.iter_segments() if s["p_type"] == "PT_LOAD" and s["p_memsz"]]
            low = min(s["p_vaddr"] for s in segments) & ~0xFFFF
            high = max(s["p_vaddr"] + s["p_memsz"] for s in segments)
            self.core.mem_map(low, (high - low + 0xFFFF) & ~0xFFFF)
            for s in segments:
                self.core.mem_write(s["p_vaddr"], s.data())
        self.symbols = {s.name: s["st_value"] for s in symbol_table(self.image)}
        self.core.mem_map(STACK_TOP - STACK_SIZE, STACK_SIZE)
        self.core.mem_map(RETURN, 0x1000)
        self.core.mem_write(RETURN, b"\x00\xbf" * 8)
        if registers is riscv:
            self.core.reg_write(riscv.UC_RISCV_REG_MSTATUS, RISCV_FPU_ON)
            self.core.reg_write(riscv.UC_RISCV_REG_TP, STACK_TOP - STACK_SIZE + 0x1000)  # where errno lives
        else:
            self.core.reg_write(arm.UC_ARM_REG_C1_C0_2, ARM_FPU_ON)
            self.core.reg_write(arm.UC_ARM_REG_FPEXC, 0x4000_0000)
        self.lengths: dict[tuple[int, int], tuple[int, ...]] = {}
        self.frames: list[Frame] = []
        self.counts: tuple[int, ...] = (0,) * 6
        if self.watched:
            self.entries = {self.symbols[name] & ~1: name for name in self.watched if name in self.symbols}
            self.core.hook_add(u.UC_HOOK_BLOCK, self._block)

    def call(self, name: str) -> int:
        """What the function (without arguments) returns."""
        self.core.reg_write(self.sp, STACK_TOP - 64)
        self.core.reg_write(self.lr, RETURN | self.thumb)
        self.core.emu_start(self.symbols[name] | self.thumb, RETURN)
        if self.core.reg_read(self.pc) & ~1 != RETURN:
            raise BoresightError(f"{name} did not return on the emulated {self.made.target.name}")
        value = int(self.core.reg_read(self.r0))
        return value - 2**32 if value >= 2**31 else value

    def counted(self, address: int, size: int) -> tuple[int, ...]:
        """How many instructions a block holds, those whose condition fails among them: the core fetches them too; the
        words that they load and store, divisions, roots, and cycles.

        Thumb's are two or four bytes long, as their first half says.
        """
        key = (address, size)
        if key not in self.lengths:
            halves = np.frombuffer(bytes(self.core.mem_read(address, size)), dtype="<u2").tolist()
            at, count, words, kinds = 0, 0, [0, 0], Counter[str]()
            while at < len(halves):
                length = 2 if halves[at] >> 11 in (0b11101, 0b11110, 0b11111) else 1
                store, touched = accesses(*halves[at : at + length])
                words[store] += touched
                kinds[kind(*halves[at : at + length])] += 1
                at, count = at + length, count + 1
            longer = sum(LONGER[name] * many for name, many in kinds.items())
            divisions = kinds["division"] + kinds["quotient"]
            self.lengths[key] = count, *words, divisions, kinds["root"], count + sum(words) + longer + REFILL
        return self.lengths[key]

    def _block(self, core: Any, address: int, size: int, _: Any) -> None:
        if not self.frames and address not in self.entries:
            return
        pointer = core.reg_read(self.sp)
        while self.frames and address == self.frames[-1].back and pointer == self.frames[-1].pointer:
            done = self.frames.pop()
            below = bytes(core.mem_read(done.pointer - PAINTED, PAINTED))
            touched = PAINTED - (len(below) - len(below.lstrip(PAINT)))
            deepest = max(touched, done.pointer - done.lowest)
            if done.name not in self.answering or core.reg_read(self.r0) == 0:
                spent = [now - before for now, before in zip(self.counts, done.counts, strict=True)]
                self.costs.setdefault(done.name, Cost()).add(spent, deepest)
            if self.frames:
                self.frames[-1].lowest = min(self.frames[-1].lowest, done.pointer - deepest)
        for frame in self.frames:
            frame.lowest = min(frame.lowest, pointer)
        if address in self.entries:
            back = core.reg_read(self.lr) & ~1
            # what an earlier call left below the stack pointer is not this one's
            core.mem_write(pointer - PAINTED, PAINT * PAINTED)
            self.frames.append(Frame(self.entries[address], back, pointer, self.counts, pointer))
        if self.frames:
            self.counts = tuple(map(add, self.counts, self.counted(address, size)))

    def read(self, name: str, dtype: type[np.generic], count: int) -> np.ndarray:
        size = count * np.dtype(dtype).itemsize
        return np.frombuffer(bytes(self.core.mem_read(self.symbols[name], size)), dtype=dtype)

    def run_tests(self, names: Iterable[str] | None = None) -> dict[str, Run]:
        """Each unit's shipped test, by the unit's name."""
        runs = {}
        for unit in self.made.folder.units:
            if not unit.test.is_file() or (names is not None and unit.name not in names):
                continue
            for counter in ("evidence_count", "evidence_groups"):
                self.core.mem_write(self.symbols[counter], bytes(4))
            failures = self.call(unit.test_function)
            (count,), (groups,) = (self.read(name, np.int32, 1) for name in ("evidence_count", "evidence_groups"))
            runs[unit.name] = recorded(
                failures,
                self.read("evidence_record", self.made.real, min(int(count), ROOM)),
                self.read("evidence_lengths", np.int32, min(int(groups), GROUPS)),
                int(count),
                int(groups),
            )
        return runs
