#include "rest.h"

int main(void)
{
    return rest();
}
