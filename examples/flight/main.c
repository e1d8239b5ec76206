/* main.c - flies a recording: flight FILE.  Prints each second; exit status 0 if the flight reached the end.
 * A recording is doubles, little-endian: a flight_setup, then records of 12: kind (0 slave, 1 master) and what
 * flight_slave or flight_master takes, filled up with zeros. */
#include <stdio.h>

#include "flight.h"

enum { PER_SECOND = 400 };

typedef struct {
    double kind;
    union {
        struct {
            double dtheta[3];
            double dv[3];
        } slave;
        flight_message master;
    } of;
} record;

static flight aboard;

int main(int argc, char **argv)
{
    flight_setup setup;
    record next;
    flight_line line;
    long ticks = 0;
    bs_status status;
    FILE *file = (argc == 2) ? fopen(argv[1], "rb") : NULL;

    if (file == NULL) {
        (void)printf("give the name of a recording, as make_recording.py writes it\n");
        return 2;
    }
    if (fread(&setup, sizeof setup, 1, file) != 1U) {
        (void)printf("%s is too short for a recording\n", argv[1]);
        (void)fclose(file);
        return 2;
    }
    flight_begin(&aboard, &setup);
    (void)printf("   s  heading deg  sigma mil   misalignment deg                 delay ms  sigma ms\n");
    while (fread(&next, sizeof next, 1, file) == 1U) {
        if (next.kind > 0.0) {
            status = flight_master(&aboard, &next.of.master);
            if (status != BS_OK) {
                (void)printf("%8.4f: message refused, or a part of it: status %d\n", (double)ticks / PER_SECOND, (int)status);
            }
            continue;
        }
        status = flight_slave(&aboard, next.of.slave.dtheta, next.of.slave.dv);
        ticks += 1;
        if ((status != BS_OK) && (status != BS_NOT_READY)) {
            (void)printf("%8.4f: increments refused: status %d\n", (double)ticks / PER_SECOND, (int)status);
        }
        if (((ticks % PER_SECOND) == 0) && (flight_report(&aboard, &line) == BS_OK)) {
            (void)printf("%4ld %12.7f %10.6f %10.6f %10.6f %10.6f %9.5f %9.5f\n", ticks / PER_SECOND, line.heading_deg,
                         line.heading_sigma_mil, line.misalignment_deg[0], line.misalignment_deg[1],
                         line.misalignment_deg[2], line.delay_ms, line.delay_sigma_ms);
        }
    }
    (void)fclose(file);
    (void)printf("%ld ticks, %u held; %u messages taken, %u in part, %u refused; starts: %u\n", ticks, aboard.held,
                 aboard.taken, aboard.in_part, aboard.refused, aboard.begun);
    return aboard.flying ? 0 : 1;
}
