/* Products of Taylor series, order by order:  (x y)_j = sum of x_i y_(j - i).

   What holds the newest coefficients comes last: the rest need not wait for them. */
static inline L convolved(const L *x, const L *y, int from, int to, int j)
{
    L sum = all(0.0);
    for (int i = from; i <= to; ++i)
        sum = fused(x[i], y[j - i], sum);
    return sum;
}

static inline L product(const L *x, const L *y, int j)
{
    return fused(x[j], y[0], fused(x[0], y[j], convolved(x, y, 1, j - 1, j)));
}

static inline L square(const L *x, int j)
{
    L half = convolved(x, x, 1, (j - 1) / 2, j);
    L sum = add(half, half);
    if (j % 2 == 0)
        sum = fused(x[j / 2], x[j / 2], sum);
    return fused(add(x[j], x[j]), x[0], sum);
}

/* q of q y = x, without x: sum over i < j of q_i y_(j - i). */
static inline L divided(const L *q, const L *y, int j)
{
    return fused(q[0], y[j], convolved(q, y, 1, j - 1, j));
}

/* j times what y' = d/dt(x) g adds at order j, where slope_i = i x_i. */
static inline L chained(const L *slope, const L *g, int j)
{
    return fused(slope[j], g[0], convolved(slope, g, 1, j - 1, j));
}

static inline void waves(L x, L *sine, L *cosine)
{
    double a[LANES], s[LANES], c[LANES];
    uint64_t far = 0;
    memcpy(a, &x, sizeof a);
    for (int i = 0; i < LANES; ++i) {
        mechanics_sincos(a[i], &s[i], &c[i]);
        far |= mechanics_far(a[i]);
    }
    if (far)
        for (int i = 0; i < LANES; ++i)
            if (mechanics_far(a[i])) {
                s[i] = sin(a[i]);
                c[i] = cos(a[i]);
            }
    memcpy(sine, s, sizeof s);
    memcpy(cosine, c, sizeof c);
}

LIBRARY(each_sqrt, sqrt)
LIBRARY(each_exp, exp)
LIBRARY(each_log, log)
LIBRARY(each_sinh, sinh)
LIBRARY(each_cosh, cosh)
LIBRARY(each_asin, asin)
LIBRARY(each_acos, acos)
LIBRARY(each_atan, atan)
LIBRARY(each_asinh, asinh)
LIBRARY(each_acosh, acosh)
LIBRARY(each_atanh, atanh)
LIBRARY(each_erf, erf)

static inline L each_pow(L x, L y)
{
    double a[LANES], b[LANES];
    memcpy(a, &x, sizeof a);
    memcpy(b, &y, sizeof b);
    for (int i = 0; i < LANES; ++i)
        a[i] = pow(a[i], b[i]);
    memcpy(&x, a, sizeof a);
    return x;
}

static inline L each_root_of_pi(L one)
{
    return mul(one, all(0x1.c5bf891b4ef6bp+0));
}
