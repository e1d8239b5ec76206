#include <zephyr/sys/printk.h>

#include "rest.h"

int main(void)
{
    printk("%s\n", rest() == 0 ? "at rest" : "not as it should be");
    return 0;
}
