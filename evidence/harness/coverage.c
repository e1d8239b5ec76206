/* coverage.c - keeps of each decision the different ways in which it was taken: which of its conditions were
 * evaluated, which were true, and what came of them; written to coverage.txt when the program ends. */
#include <stdio.h>
#include <stdlib.h>

#define WAYS 256 /* of one decision; with conditions that are not evaluated there are few */

int coverage_mark(int decision, int condition, int value);
int coverage_decide(int decision, int value);

typedef struct {
    unsigned evaluated, values, outcome;
} way;

static way now[EVIDENCE_DECISIONS], ways[EVIDENCE_DECISIONS][WAYS];
static int n_ways[EVIDENCE_DECISIONS];

int coverage_mark(int decision, int condition, int value)
{
    now[decision].evaluated |= 1U << condition;
    now[decision].values |= (value ? 1U : 0U) << condition;
    return value;
}

int coverage_decide(int decision, int value)
{
    const way this = { now[decision].evaluated, now[decision].values, value ? 1U : 0U };
    int i = 0;
    now[decision].evaluated = now[decision].values = 0U;
    while ((i < n_ways[decision]) && ((ways[decision][i].evaluated != this.evaluated)
                                      || (ways[decision][i].values != this.values))) {
        ++i;
    }
    if (i == WAYS) {
        abort();
    }
    if (i == n_ways[decision]) {
        ways[decision][n_ways[decision]++] = this;
    }
    return value;
}

static void put(void)
{
    FILE *file = fopen("coverage.txt", "w");
    for (int d = 0; (file != NULL) && (d < EVIDENCE_DECISIONS); ++d) {
        for (int i = 0; i < n_ways[d]; ++i) {
            fprintf(file, "%d %u %u %u\n", d, ways[d][i].evaluated, ways[d][i].values, ways[d][i].outcome);
        }
    }
    if (file != NULL) {
        fclose(file);
    }
}

__attribute__((constructor)) static void begin(void)
{
    (void)atexit(put);
}
