/* host.c - no interrupts: a sample, and behind it all that the background has to do. */
#include "board.h"

void board_sample(const va_sample *sample)
{
    (void)va_live_sample(&aboard, sample);
    while (va_live_background(&aboard) == BS_OK) {
    }
}

void board_wait(void)
{
}
