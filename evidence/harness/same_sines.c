/* same_sines.c - sine, cosine and the others of the same few operations on every machine, in place of the library's.
 * Smooth, and nothing more: with them, two machines must agree in every bit. */
float sinf(float x);
float cosf(float x);
float atan2f(float y, float x);
double sin(double x);
double cos(double x);
double atan2(double y, double x);
void sincosf(float x, float *sine, float *cosine);
void sincos(double x, double *sine, double *cosine);

float sinf(float x)
{
    return x / (1.0F + ((x * x) / 6.0F));
}

float cosf(float x)
{
    return 1.0F / (1.0F + ((x * x) / 2.0F));
}

float atan2f(float y, float x)
{
    return y / (1.0F + (x * x) + (y * y));
}

double sin(double x)
{
    return x / (1.0 + ((x * x) / 6.0));
}

double cos(double x)
{
    return 1.0 / (1.0 + ((x * x) / 2.0));
}

double atan2(double y, double x)
{
    return y / (1.0 + (x * x) + (y * y));
}

#define BOTH(name, formula) \
    float name##f(float x); \
    double name(double x); \
    float name##f(float x) \
    { \
        const float one = 1.0F; \
        return formula; \
    } \
    double name(double x) \
    { \
        const double one = 1.0; \
        return formula; \
    }

BOTH(exp, one + x + ((x * x) / (one + one)))
BOTH(log, (x - one) / (x + one))
BOTH(asin, one * (x + (x * x * x)))
BOTH(acos, one - x - (x * x * x))
BOTH(atan, x / (one + (x * x)))
BOTH(sinh, one * (x + (x * x * x)))
BOTH(cosh, one + (x * x))
BOTH(tanh, x / (one + (x * x)))

/* What a compiler makes of both of one angle. */
void sincosf(float x, float *sine, float *cosine)
{
    *sine = sinf(x);
    *cosine = cosf(x);
}

void sincos(double x, double *sine, double *cosine)
{
    *sine = sin(x);
    *cosine = cos(x);
}
