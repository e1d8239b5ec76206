/* As a module of PX4 is built: C++14, by its flags for warnings. */
#include <cstdio>

#include "rest.h"

extern "C" int rest_main(int argc, char *argv[]);

int rest_main(int argc, char *argv[])
{
    (void)argc;
    (void)argv;
    const int failed = rest();
    std::puts(failed == 0 ? "at rest" : "not as it should be");
    return failed;
}
