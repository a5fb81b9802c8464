/* Arithmetic on LANES motions at once.

   A value of all motions of a block is an L: two or more of the widest vectors of the machine, so
   that the processor has work while one of them waits for its last operation. Vectors are an
   extension of C that gcc and clang share. Every lane goes through the same operations, so the
   result of a motion does not depend on its neighbours. */
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { LANES = 16 };
#if defined(__AVX512F__)
enum { WIDE = 8, VECTORS = 2 };
#define EACH(DO) DO(0) DO(1)
#elif defined(__AVX__)
enum { WIDE = 4, VECTORS = 4 };
#define EACH(DO) DO(0) DO(1) DO(2) DO(3)
#else
enum { WIDE = 2, VECTORS = 8 };
#define EACH(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)
#endif

typedef double V __attribute__((vector_size(WIDE * 8)));
typedef int64_t I __attribute__((vector_size(WIDE * 8)));
typedef struct {
    V at[VECTORS];
} L;
typedef struct {
    I at[VECTORS];
} M; /* a mask: all bits of a lane are set, or none */

#define LANE(x, lane) (((double *)(x))[lane])
#define WHERE(x, lane) (((const int64_t *)(x))[lane] != 0)

#define OPERATION(name, arguments, expression)                                                     \
    static inline L name arguments                                                                 \
    {                                                                                              \
        L r;                                                                                       \
        EACH(expression)                                                                           \
        return r;                                                                                  \
    }
#define ADD(i) r.at[i] = x.at[i] + y.at[i];
#define SUB(i) r.at[i] = x.at[i] - y.at[i];
#define MUL(i) r.at[i] = x.at[i] * y.at[i];
#define DIV(i) r.at[i] = x.at[i] / y.at[i];
#define FMA(i) r.at[i] = x.at[i] * y.at[i] + z.at[i];
#define FNMA(i) r.at[i] = z.at[i] - x.at[i] * y.at[i];
#define NEG(i) r.at[i] = -x.at[i];
#define ALL(i) r.at[i] = (V){0} + x;
OPERATION(add, (L x, L y), ADD)
OPERATION(sub, (L x, L y), SUB)
OPERATION(mul, (L x, L y), MUL)
OPERATION(over, (L x, L y), DIV)
OPERATION(fused, (L x, L y, L z), FMA)   /* x y + z */
OPERATION(rest, (L x, L y, L z), FNMA)   /* z - x y */
OPERATION(minus, (L x), NEG)
OPERATION(all, (double x), ALL)

static inline V choose(I mask, V x, V y)
{
    return (V)(((I)x & mask) | ((I)y & ~mask));
}

static inline V least(V x, V y) { return choose(x < y, x, y); }
static inline V largest(V x, V y) { return choose(x > y, x, y); }
static inline V size(V x) { return (V)((I)x & INT64_MAX); }
static inline V every(double x) { return (V){0} + x; }

static inline int some(I mask)
{
    int64_t any = 0;
    for (int i = 0; i < WIDE; ++i)
        any |= mask[i];
    return any != 0;
}

/* The logarithm to base 2 of x > 0, too small by up to .09, and its inverse: the exponent and the
   mantissa as they stand in the number. Lengths of steps need no more. */
static inline V logarithm(I bits) { return __builtin_convertvector(bits, V) * 0x1p-52; }
static inline V power(V x) { return (V)__builtin_convertvector((x + 1023.0) * 0x1p52, I); }
