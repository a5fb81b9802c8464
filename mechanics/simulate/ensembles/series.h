/* Products of Taylor series, order by order:  (x y)_j = sum of x_i y_(j - i).

   Two orders at a time, so that a coefficient that has been fetched serves both: the first of a
   pair, which is odd, also sums what is known already of the second, its terms without x_j and y_j.
   What holds the newest coefficients comes last: the rest need not wait for them. */
static inline L known(L *later, const L *x, const L *y, int j)
{
    L sum = all(0.0), next = sum;
    if (j > 1) {
        L before = y[j - 1];
        sum = mul(x[1], before);
        for (int i = 2; i < j; ++i) {
            const L factor = x[i], other = y[j - i];
            sum = fused(factor, other, sum);
            next = fused(factor, before, next);
            before = other;
        }
    }
    *later = next;
    return sum;
}

/* The sum with what was not known when the pair began, but for x_0 y_j and x_j y_0. */
static inline L rest_known(L later, const L *x, const L *y, int j)
{
    later = fused(x[1], y[j - 1], later);
    return j > 2 ? fused(x[j - 1], y[1], later) : later;
}

static inline L product_first(L *later, const L *x, const L *y, int j)
{
    return fused(x[j], y[0], fused(x[0], y[j], known(later, x, y, j)));
}

static inline L product_second(L later, const L *x, const L *y, int j)
{
    return fused(x[j], y[0], fused(x[0], y[j], rest_known(later, x, y, j)));
}

/* q of q y = x, without x: sum over i < j of q_i y_(j - i). */
static inline L divided_first(L *later, const L *q, const L *y, int j)
{
    return fused(q[0], y[j], known(later, q, y, j));
}

static inline L divided_second(L later, const L *q, const L *y, int j)
{
    return fused(q[0], y[j], rest_known(later, q, y, j));
}

/* j times what y' = d/dt(x) g adds at order j, where slope_i = i x_i. */
static inline L chained_first(L *later, const L *slope, const L *g, int j)
{
    return fused(slope[j], g[0], known(later, slope, g, j));
}

static inline L chained_second(L later, const L *slope, const L *g, int j)
{
    return fused(slope[j], g[0], rest_known(later, slope, g, j));
}

/* Half of the terms, twice; the one in the middle of an even order once. */
static inline L square_first(L *later, const L *x, int j)
{
    L sum = all(0.0), next = sum;
    if (j > 1) {
        L before = x[j - 1];
        const L middle = x[(j + 1) / 2];
        sum = mul(x[1], before);
        for (int i = 2; 2 * i < j; ++i) {
            const L factor = x[i], other = x[j - i];
            sum = fused(factor, other, sum);
            next = fused(factor, before, next);
            before = other;
        }
        next = fused(middle, middle, add(next, next));
    }
    *later = next;
    sum = fused(x[j], x[0], sum);
    return add(sum, sum);
}

static inline L square_second(L later, const L *x, int j)
{
    const L twice = add(x[j], x[j]), last = j > 2 ? add(x[j - 1], x[j - 1]) : x[j - 1];
    return fused(twice, x[0], fused(last, x[1], later));
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
