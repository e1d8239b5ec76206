/* device.h - what the C asks of the standard headers, where a compiler for a GPU has none: they are left out of the
 * text.  Comparisons are quiet there. */
#define FLT_MANT_DIG 24
#define DBL_MANT_DIG 53
#define FLT_EPSILON 1.1920928955078125e-7F
#define DBL_EPSILON 2.220446049250313e-16
#define FLT_MAX 3.4028234663852886e+38F
#define DBL_MAX 1.7976931348623157e+308
#define FLT_EVAL_METHOD 0
#define NAN __int_as_float(0x7FC00000)
#define INFINITY __int_as_float(0x7F800000)
#define isgreaterequal(a, b) ((a) >= (b))
#define islessequal(a, b) ((a) <= (b))
#define isunordered(a, b) (((a) != (a)) || ((b) != (b)))
#define NULL 0
typedef unsigned int uint32_t;
typedef unsigned long long uint64_t;
