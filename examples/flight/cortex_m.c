/* cortex_m.c - what a Cortex-M with an FPU needs before the C library's start: its vectors, and the FPU switched on. */
#include <stdint.h>

void reset(void);
void _start(void); /* of the C library: clears memory, opens the semihosted files, calls main */

extern const uintptr_t vectors[2];
const uintptr_t vectors[2] __attribute__((section(".vectors"))) = {
    0x20400000U, /* the stack's top: the end of 4 MB of RAM */
    (uintptr_t)&reset,
};

void reset(void)
{
    *(volatile uint32_t *)0xE000ED88U |= 0xFU << 20; /* CPACR: full access to the FPU */
    __asm volatile("dsb\n\tisb");
    _start();
}
