"""The digest of the generated C: SHA-256, whatever the machine."""

import ctypes
import hashlib

import numpy as np
import pytest
from tools import needs, tool

from boresight.codegen.text.digest import MESSAGES
from boresight.runtime.compiler import PRECISIONS, run
from boresight.runtime.manifest import folder_of

# Of FIPS 180-4's examples, as they are printed.
PRINTED = {
    "abc": "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad",
    "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq": (
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"
    ),
    "a" * 1_000_000: "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0",
}
CALLS = """
#include "boresight_digest.h"
int of_bytes(const unsigned char *bytes, size_t n, unsigned char *out);
int of_bytes(const unsigned char *bytes, size_t n, unsigned char *out)
{
    bs_digest digest;
    return (int)bs_digest_begin(&digest) + (int)bs_digest_add(&digest, bytes, n) + (int)bs_digest_end(&digest, out);
}
int of_reals(const bs_real *values, int n, unsigned char *out);
int of_reals(const bs_real *values, int n, unsigned char *out)
{
    bs_digest digest;
    (void)bs_digest_begin(&digest);
    for (int i = 0; i < n; i += 7) { /* with an end in between, which must change nothing */
        (void)bs_digest_end(&digest, out);
        (void)bs_digest_reals(&digest, &values[i], (n - i < 7) ? n - i : 7);
    }
    return (int)bs_digest_end(&digest, out);
}
"""
# Without a library: what a compiler asks for, the numbers' digest, and how the program ends.
BARE = """
#include "boresight_digest.h"
void *memcpy(void *to, const void *from, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        ((unsigned char *)to)[i] = ((const unsigned char *)from)[i];
    }
    return to;
}
void _start(void)
{
    static const bs_real numbers[3] = { BS_REAL(1.0), BS_REAL(-2.5), BS_REAL(3.140625) };
    static const unsigned char wanted[BS_DIGEST_SIZE] = { WANTED };
    static const unsigned int one = 1U;
    register int code __asm__("r0") = 0;
    register int exit __asm__("r7") = 1;
    unsigned char out[BS_DIGEST_SIZE];
    bs_digest digest;
    int differing = *(const unsigned char *)&one; /* 0: the highest byte comes first */
    (void)bs_digest_begin(&digest);
    (void)bs_digest_reals(&digest, numbers, 3);
    (void)bs_digest_end(&digest, out);
    for (unsigned int i = 0; i < BS_DIGEST_SIZE; ++i) {
        differing += out[i] != wanted[i];
    }
    code = differing;
    __asm__ volatile("svc 0" : : "r"(code), "r"(exit));
    for (;;) {
    }
}
"""
INCLUDE = folder_of("euler-matching") / "include"


@pytest.fixture(params=PRECISIONS)
def digests(request, tmp_path):
    (tmp_path / "calls.c").write_text(CALLS)
    image = tmp_path / f"calls-{request.param}.so"
    flags = ("-std=c99", "-O1", "-fPIC", "-shared", *PRECISIONS[request.param])
    run(["gcc", *flags, "-I", INCLUDE, tmp_path / "calls.c", "-o", image])
    return ctypes.CDLL(str(image)), "<f4" if request.param == "float" else "<f8"


def test_bytes_have_the_digest_that_the_standard_prints_and_that_hashlib_has(digests):
    library, _ = digests
    out = ctypes.create_string_buffer(32)
    for text in (*PRINTED, *MESSAGES, *("x" * n for n in range(50, 130))):
        assert library.of_bytes(text.encode(), ctypes.c_size_t(len(text)), out) == 0
        assert out.raw == hashlib.sha256(text.encode()).digest()
        assert out.raw.hex() == PRINTED.get(text, out.raw.hex())


def test_numbers_have_the_digest_that_hashlib_has_of_their_bytes(digests):
    library, dtype = digests
    values = np.random.default_rng(1).standard_normal(1000).astype(dtype)
    values[:5] = [0.0, -0.0, np.inf, np.finfo(dtype).smallest_subnormal, np.finfo(dtype).max]
    out = ctypes.create_string_buffer(32)
    assert library.of_reals(ctypes.c_void_p(values.ctypes.data), len(values), out) == 0
    assert out.raw == hashlib.sha256(values.tobytes()).digest()


@needs("arm-none-eabi-gcc", "qemu-armeb")
@pytest.mark.parametrize("precision", PRECISIONS)
def test_a_machine_whose_highest_byte_comes_first_has_the_same_digest(precision, tmp_path):
    numbers = np.array([1.0, -2.5, 3.140625], "<f4" if precision == "float" else "<f8")
    wanted = ",".join(map(str, hashlib.sha256(numbers.tobytes()).digest()))
    (tmp_path / "bare.c").write_text(BARE)
    core = ("-mbig-endian", "-mcpu=arm926ej-s", "-marm", "-mfloat-abi=soft")
    flags = ("-std=gnu99", "-O2", "-ffreestanding", "-nostdlib", f"-DWANTED={wanted}", *PRECISIONS[precision])
    program = tmp_path / "bare.elf"
    run([tool("arm-none-eabi-gcc"), *core, *flags, "-I", INCLUDE, tmp_path / "bare.c", "-lgcc", "-o", program])
    run([tool("qemu-armeb"), program])
