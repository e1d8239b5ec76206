/* Calls functions of a library, all with one signature, on the same numbers.
 * usage: drive clock, or
 *        drive LIBRARY NUMBERS check|count|time ROUNDS SECONDS NAME...
 * NUMBERS: four counts (v, P, out and 0), then v, P, Q, in doubles.
 * check: writes what each function gives to standard output; time: prints ns a call, a line a round, the rounds
 * interleaved; count: has callgrind count one call of each, when run below it. */
#define _POSIX_C_SOURCE 200809L
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#ifdef CALLGRIND
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_DUMP_STATS_AT(name)
#endif

#define ROOM 16384
typedef void function(const double *v, const double *P, const double *Q, double *out);
typedef struct {
    function *call;
    void (*after)(double *out);
    double *v, *P, *Q, *out;
    long calls;
} task;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double *room(const double *from, size_t n)
{
    void *made = NULL;
    if (posix_memalign(&made, 64, sizeof(double) * ROOM) != 0)
        abort();
    memset(made, 0, sizeof(double) * ROOM);
    memcpy(made, from, sizeof(double) * n);
    return made;
}

static double seconds(const task *one, long calls)
{
    const double start = now();
    for (long k = 0; k < calls; ++k)
        one->call(one->v, one->P, one->Q, one->out);
    return now() - start;
}

/* GHz of the processor: an addition that waits for the one before it takes a cycle. */
static double clock_ghz(void)
{
#if defined(__x86_64__)
    long x = 0, turns = 2000000;
    double best = 1.0;
    for (int round = 0; round < 9; ++round) {
        const double start = now();
        for (long k = 0; k < turns; ++k)
            __asm__ volatile("add $1,%0\nadd $1,%0\nadd $1,%0\nadd $1,%0\nadd $1,%0\nadd $1,%0\nadd $1,%0\nadd $1,%0"
                             : "+r"(x));
        const double spent = now() - start;
        best = (spent < best) ? spent : best;
    }
    return 8e-9 * (double)turns / best;
#else
    return 0.0 / 0.0;
#endif
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "clock") == 0) {
        printf("%.3f\n", clock_ghz());
        return 0;
    }
    if (argc < 7) {
        fprintf(stderr, "drive: too few arguments\n");
        return 1;
    }
    void *const library = dlopen(argv[1], RTLD_NOW);
    static double numbers[4 * ROOM];
    FILE *const file = fopen(argv[2], "rb");
    if (library == NULL || file == NULL || fread(numbers, sizeof(double), 4 * ROOM, file) < 4) {
        fprintf(stderr, "drive: %s\n", library == NULL ? dlerror() : "cannot read the numbers");
        return 1;
    }
    const size_t nv = (size_t)numbers[0], np = (size_t)numbers[1], nout = (size_t)numbers[2];
    const char *const mode = argv[3];
    const int rounds = atoi(argv[4]), n = argc - 6;
    const double slot = atof(argv[5]);
    task *const tasks = calloc((size_t)n, sizeof(task));
    for (int i = 0; i < n; ++i) {
        char name[256];
        void (*before)(double *, double *);
        *(void **)&tasks[i].call = dlsym(library, argv[6 + i]);
        snprintf(name, sizeof name, "%s_before", argv[6 + i]);
        *(void **)&before = dlsym(library, name);
        snprintf(name, sizeof name, "%s_after", argv[6 + i]);
        *(void **)&tasks[i].after = dlsym(library, name);
        tasks[i].v = room(&numbers[4], nv);
        tasks[i].P = room(&numbers[4 + nv], np);
        tasks[i].Q = room(&numbers[4 + nv + np], np);
        tasks[i].out = room(numbers, 0);
        if (tasks[i].call == NULL) {
            fprintf(stderr, "drive: no function %s\n", argv[6 + i]);
            return 1;
        }
        if (before != NULL)
            before(tasks[i].P, tasks[i].Q);
        (void)seconds(&tasks[i], 1); /* what is bound late is bound now */
        if (strcmp(mode, "check") == 0) {
            if (tasks[i].after != NULL)
                tasks[i].after(tasks[i].out);
            fwrite(tasks[i].out, sizeof(double), nout, stdout);
        } else if (strcmp(mode, "count") == 0) {
            CALLGRIND_ZERO_STATS;
            tasks[i].call(tasks[i].v, tasks[i].P, tasks[i].Q, tasks[i].out);
            CALLGRIND_DUMP_STATS_AT(argv[6 + i]);
        } else {
            tasks[i].calls = 1;
            while (seconds(&tasks[i], tasks[i].calls) < slot / 2)
                tasks[i].calls *= 2;
        }
    }
    if (strcmp(mode, "time") == 0) {
        for (int round = 0; round < rounds; ++round) {
            for (int i = 0; i < n; ++i)
                printf("%.2f ", 1e9 * seconds(&tasks[i], tasks[i].calls) / (double)tasks[i].calls);
            printf("\n");
        }
    }
    return 0;
}
