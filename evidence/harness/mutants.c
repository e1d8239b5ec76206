/* mutants.c - runs one self-test once for each mutant, in a process of its own: 1 where it fails, crashes or does not
 * end within a second, 0 where it passes. */
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

int EVIDENCE_TEST(void);

int evidence_mutant = -1;

int main(int argc, char **argv)
{
    const int count = (argc > 1) ? atoi(argv[1]) : 0;
    if (EVIDENCE_TEST() != 0) {
        return 2; /* no mutant, and it fails */
    }
    for (int i = 0; i < count; ++i) {
        int status = 0;
        char verdict;
        const pid_t child = fork();
        if (child == 0) {
            evidence_mutant = i;
            (void)alarm(2);
            _exit((EVIDENCE_TEST() != 0) ? 1 : 0);
        }
        if (waitpid(child, &status, 0) != child) {
            return 3;
        }
        verdict = (WIFEXITED(status) && (WEXITSTATUS(status) == 0)) ? '0' : '1';
        if (write(1, &verdict, 1) != 1) {
            return 3;
        }
    }
    return 0;
}
