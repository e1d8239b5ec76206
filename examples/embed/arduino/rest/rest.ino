// Copy arduino/strapdown_f32 of the export into the libraries of your sketchbook, and rest.h beside this sketch.
#include "rest.h"

void setup()
{
    Serial.begin(115200);
    Serial.println(rest() == 0 ? "at rest" : "not as it should be: see bs_probe in boresight.h");
}

void loop()
{
}
