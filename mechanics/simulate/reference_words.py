"""C for the recurrences of `reference_native`, on integers of a few 64-bit words.

Two's complement, the least word first; a product takes twice the words, sums of products are made
there and shifted back once. The compiler has to know 128-bit integers, as gcc and clang do.
"""

SOURCE = """\
#include <stdint.h>
#include <string.h>

typedef unsigned __int128 wide;
enum { L = @WORDS, COPY = 0, SUM, TIMES, OVER, PRODUCT, QUOTIENT, CHAIN, SLOPE };

static __thread int bad;

static int negative(const uint64_t *a)
{
    return (int64_t)a[L - 1] < 0;
}

static void negate(uint64_t *a, int words)
{
    uint64_t carry = 1;
    for (int i = 0; i < words; ++i) {
        a[i] = ~a[i] + carry;
        carry = carry && a[i] == 0;
    }
}

static void add(uint64_t *a, const uint64_t *b, int words)
{
    uint64_t carry = 0;
    for (int i = 0; i < words; ++i) {
        const wide sum = (wide)a[i] + b[i] + carry;
        a[i] = (uint64_t)sum;
        carry = (uint64_t)(sum >> 64);
    }
}

static void subtract_high(uint64_t *product, const uint64_t *b)
{
    uint64_t borrow = 0;
    for (int i = 0; i < L; ++i) {
        const wide rest = (wide)product[L + i] - b[i] - borrow;
        product[L + i] = (uint64_t)rest;
        borrow = (uint64_t)(rest >> 64) & 1;
    }
}

/* sum += a b, in two's complement of 2 L words. */
static void accumulate(uint64_t *sum, const uint64_t *a, const uint64_t *b)
{
    uint64_t product[2 * L] = {0};
    for (int i = 0; i < L; ++i) {
        uint64_t carry = 0;
        for (int j = 0; j < L; ++j) {
            const wide t = (wide)a[i] * b[j] + product[i + j] + carry;
            product[i + j] = (uint64_t)t;
            carry = (uint64_t)(t >> 64);
        }
        product[i + L] = carry;
    }
    if (negative(a))
        subtract_high(product, b);
    if (negative(b))
        subtract_high(product, a);
    add(sum, product, 2 * L);
}

static void check(const uint64_t *a)
{
    bad |= a[L - 1] + ((uint64_t)1 << 55) >= (uint64_t)1 << 56;
}

/* out = sum 2^-bits, rounded down. */
static void shifted(uint64_t *out, const uint64_t *sum, int bits)
{
    const int whole = bits / 64, part = bits % 64;
    const uint64_t sign = (int64_t)sum[2 * L - 1] < 0 ? ~(uint64_t)0 : 0;
    uint64_t lost = 0;
    for (int i = 0; i < 2 * L; ++i) {
        const uint64_t low = i + whole < 2 * L ? sum[i + whole] : sign;
        const uint64_t high = i + whole + 1 < 2 * L ? sum[i + whole + 1] : sign;
        const uint64_t word = part ? low >> part | high << (64 - part) : low;
        if (i < L)
            out[i] = word;
        else
            lost |= word ^ sign;
    }
    bad |= lost != 0;
    check(out);
}

static void divided(uint64_t *a, uint64_t by)
{
    const int minus = negative(a);
    wide rest = 0;
    if (minus)
        negate(a, L);
    for (int i = L - 1; i >= 0; --i) {
        rest = rest << 64 | a[i];
        a[i] = (uint64_t)(rest / by);
        rest %= by;
    }
    if (minus)
        negate(a, L);
}

/* sum_(i = first .. j) a_i b_(j - i) */
static void convolved(uint64_t *sum, const uint64_t *a, const uint64_t *b, int first, int last,
    int j)
{
    memset(sum, 0, 2 * L * sizeof *sum);
    for (int i = first; i <= last; ++i)
        accumulate(sum, a + i * L, b + (j - i) * L);
}

/* sum_(i = 0 .. j) a_i a_(j - i): half of the terms, twice */
static void squared(uint64_t *sum, const uint64_t *a, int j)
{
    convolved(sum, a, a, 0, (j + 1) / 2 - 1, j);
    for (int i = 2 * L - 1; i >= 0; --i)
        sum[i] = sum[i] << 1 | (i ? sum[i - 1] >> 63 : 0);
    if (j % 2 == 0)
        accumulate(sum, a + j / 2 * L, a + j / 2 * L);
}

static void times(uint64_t *out, const uint64_t *a, const uint64_t *b, int bits)
{
    uint64_t sum[2 * L] = {0};
    accumulate(sum, a, b);
    shifted(out, sum, bits);
}

/* Coefficients 1 to `order`; 0, or 1 where a number outgrew its words. */
int mechanics_expand(int order, int bits, int rules, const int32_t *rule, int states,
    const int32_t *state, uint64_t *series, const uint64_t *number, const int32_t *shift,
    const uint64_t *step)
{
    bad = 0;
    for (int j = 0; j <= order; ++j) {
        for (int r = 0; r < rules && j; ++r) {
            const int32_t *line = rule + 5 * r;
            const long size = (long)(order + 1) * L;
            uint64_t *out = series + line[1] * size, *x = out + j * L, sum[2 * L];
            const uint64_t *a = series + line[2] * size, *b = series + line[3] * size;
            const uint64_t *held = number + line[4] * L;
            switch (line[0]) {
            case COPY:
                memcpy(x, a + j * L, L * sizeof *x);
                if (line[4] < 0)
                    negate(x, L);
                break;
            case SUM:
                memcpy(x, b + j * L, L * sizeof *x);
                if (line[4] < 0)
                    negate(x, L);
                add(x, a + j * L, L);
                check(x);
                break;
            case TIMES:
                times(x, a + j * L, held, bits);
                break;
            case PRODUCT:
                if (a == b)
                    squared(sum, a, j);
                else
                    convolved(sum, a, b, 0, j, j);
                shifted(x, sum, bits);
                break;
            case OVER:
                times(x, a + j * L, held, shift[line[4]]);
                break;
            case QUOTIENT: {
                uint64_t rest[L];
                convolved(sum, out, b, 0, j - 1, j);
                negate(sum, 2 * L);
                shifted(rest, sum, bits);
                if (line[2] >= 0)
                    add(rest, a + j * L, L);
                check(rest);
                times(x, rest, held, shift[line[4]]);
                break;
            }
            case SLOPE:
                memset(sum, 0, sizeof sum);
                memset(x, 0, L * sizeof *x);
                x[0] = (uint64_t)j;
                accumulate(sum, a + j * L, x);
                shifted(x, sum, 0);
                break;
            default: /* CHAIN */
                convolved(sum, a, b, 1, j, j);
                shifted(x, sum, bits);
                divided(x, (uint64_t)j);
                if (line[4] < 0)
                    negate(x, L);
            }
        }
        for (int s = 0; s < states && j < order; ++s) {
            const long size = (long)(order + 1) * L;
            uint64_t *next = series + state[2 * s] * size + (j + 1) * L;
            if (state[2 * s + 1] < 0 && j)
                memset(next, 0, L * sizeof *next);
            else {
                const uint64_t *rate = state[2 * s + 1] < 0
                    ? number - (state[2 * s + 1] + 1) * L
                    : series + state[2 * s + 1] * size + j * L;
                times(next, rate, step, bits);
                divided(next, (uint64_t)j + 1);
            }
        }
        if (bad)
            return 1;
    }
    return 0;
}
"""
