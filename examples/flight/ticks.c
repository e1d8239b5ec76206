/* ticks.c - the flight call by call, for a program that counts the instructions of each: functions
 * without arguments, and no interrupt. */
#include "board.h"

extern flight_record tick_record;
extern unsigned char tick_digest[BS_DIGEST_SIZE];
extern unsigned char tick_stage[2]; /* of a measurement under way, before and behind a call */
int tick_take(void);
int tick_background(void);
int tick_output(void);
int tick_end(void);

flight_record tick_record;
unsigned char tick_digest[BS_DIGEST_SIZE];
unsigned char tick_stage[2];

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
    int status;
    tick_stage[0] = (unsigned char)aboard.measuring.stage;
    status = (int)va_live_background(&aboard);
    tick_stage[1] = (unsigned char)aboard.measuring.stage;
    return status;
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
