#include <stdio.h>

#include "rest.h"

void app_main(void)
{
    puts(rest() == 0 ? "at rest" : "not as it should be");
}
