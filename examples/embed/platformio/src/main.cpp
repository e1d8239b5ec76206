#include <Arduino.h>

#include "rest.h"

void setup()
{
    Serial.begin(115200);
    Serial.println(rest() == 0 ? "at rest" : "not as it should be");
}

void loop()
{
}
