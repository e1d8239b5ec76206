/* ticks.c - the flight call by call, for a program that counts the instructions of each: functions
 * without arguments, and no interrupt. */
#include "board.h"

extern flight_record tick_record;
extern unsigned char tick_digest[BS_DIGEST_SIZE];
int tick_take(void);
int tick_background(void);
int tick_output(void);
int tick_end(void);

flight_record tick_record;
unsigned char tick_digest[BS_DIGEST_SIZE];

void board_sample(const va_sample *sample)
{
    (void)va_live_sample(&aboard, sample);
}

void board_wait(void)
{
}

int tick_take(void)
{
    take(&tick_record);
    return 0;
}

int tick_background(void)
{
    return (int)va_live_background(&aboard);
}

/* Half a sample behind the newest. */
int tick_output(void)
{
    va_output out;
    return (int)va_live_output(&aboard, (int64_t)tick_record.at + (int64_t)(0.5e6 * head.dt), &out);
}

int tick_end(void)
{
    return (int)va_live_digest(&aboard, tick_digest);
}
