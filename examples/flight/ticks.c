/* ticks.c - the flight behind functions without arguments, for a program that puts the inputs into place and calls one
 * after the other.  They keep the status, so that none of them is left by a jump into the flight. */
#include "ticks.h"

flight_setup tick_setup;
double tick_increments[6];
flight_message tick_message;
flight_line tick_line;

int tick_status;

static flight aboard;

int tick_begin(void)
{
    flight_begin(&aboard, &tick_setup);
    return 0;
}

int tick_slave(void)
{
    tick_status = (int)flight_slave(&aboard, tick_increments, tick_increments + 3);
    return tick_status;
}

int tick_master(void)
{
    tick_status = (int)flight_master(&aboard, &tick_message);
    return tick_status;
}

int tick_report(void)
{
    tick_status = (int)flight_report(&aboard, &tick_line);
    return tick_status;
}
