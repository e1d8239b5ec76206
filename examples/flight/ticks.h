/* ticks.h - see ticks.c. */
#ifndef TICKS_H
#define TICKS_H

#include "flight.h"

extern flight_setup tick_setup;
extern double tick_increments[6];
extern flight_message tick_message;
extern flight_line tick_line;
extern int tick_status;

int tick_begin(void);
int tick_slave(void);
int tick_master(void);
int tick_report(void);

#endif
