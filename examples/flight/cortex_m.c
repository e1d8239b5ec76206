/* cortex_m.c - a Cortex-M with an FPU: a timer interrupt takes the samples, and interrupts the
 * background.  The recording is read faster than it was made: 1 kHz in place of 200 Hz. */
#include "board.h"

#define QUEUE 8U /* samples; a power of two */
#define CYCLES 25000U /* of the board's 25 MHz, from tick to tick */

static va_sample queue[QUEUE];
static volatile uint32_t given, taken;

void reset(void);
void tick(void);
void _start(void); /* of the C library: clears memory, opens the semihosted files, calls main */

extern const uintptr_t vectors[16];
const uintptr_t vectors[16] __attribute__((section(".vectors"))) = {
    0x20400000U, /* the stack's top: the end of 4 MB of RAM */
    (uintptr_t)&reset,
    [15] = (uintptr_t)&tick,
};

void reset(void)
{
    *(volatile uint32_t *)0xE000ED88U |= 0xFU << 20; /* CPACR: full access to the FPU */
    __asm volatile("dsb\n\tisb");
    *(volatile uint32_t *)0xE000E014U = CYCLES - 1U; /* SysTick: reload, count, and on */
    *(volatile uint32_t *)0xE000E018U = 0U;
    *(volatile uint32_t *)0xE000E010U = 7U;
    _start();
}

void tick(void)
{
    if (taken != given) {
        (void)va_live_sample(&aboard, &queue[taken % QUEUE]);
        taken += 1U;
    }
}

void board_sample(const va_sample *sample)
{
    while ((given - taken) >= QUEUE) {
        (void)va_live_background(&aboard);
    }
    queue[given % QUEUE] = *sample;
    BS_LIVE_BARRIER();
    given += 1U;
}

void board_wait(void)
{
    while (taken != given) {
        (void)va_live_background(&aboard);
    }
}
