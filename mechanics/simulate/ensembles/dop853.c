/* DOP853 with the control of a step that SciPy has:

   error = h |e5|^2 / sqrt(n (|e5|^2 + |e3|^2 / 100)),  each entry over tolerance (1 + |y|)
   next step = h min(10, max(1/5, 9/10 error^(-1/8))),  no longer than h after a refused one

   The first step takes the state 1/100 of its size on, along its slope (Hairer, Norsett and Wanner,
   section II.4); 1e-6 s where one of them is zero. */
static inline L scaled(const Block *b, const L *x, int n)
{
    L r;
    for (int i = 0; i < VECTORS; ++i) {
        const V y = largest(size(b->y[n].at[i]), size(x[n].at[i]));
        r.at[i] = b->tolerance + b->tolerance * y;
    }
    return r;
}

static void enter(Block *b)
{
    L y = all(0.0), f = all(0.0);
    rate(b->y, b->held, b->work.slopes[0]);
    for (int n = 0; n < MOVING; ++n) {
        const L scale = scaled(b, b->y, n);
        const L a = over(b->y[n], scale), c = over(b->work.slopes[0][n], scale);
        y = fused(a, a, y);
        f = fused(c, c, f);
    }
    for (int lane = 0; lane < LANES; ++lane)
        if (LANE(&b->tried, lane) == 0) {
            const double d0 = sqrt(LANE(&y, lane)), d1 = sqrt(LANE(&f, lane));
            const double guess = d0 < 1e-5 || !(d1 > 1e-5) ? 1e-6 : 0.01 * d0 / d1;
            LANE(&b->step, lane) = fmin(LANE(&b->step, lane), guess);
            LANE(&b->work.careful, lane) = 0;
        }
}

static void attempt(Block *b)
{
    L h, five = all(0.0), three = all(0.0);
    for (int i = 0; i < VECTORS; ++i)
        h.at[i] = least(b->step.at[i], b->left.at[i]);
    memcpy(b->work.old, b->y, sizeof b->y);
    stages(b->y, b->held, h, b->work.slopes, b->next);
    for (int n = 0; n < MOVING; ++n) {
        const L scale = scaled(b, b->next, n);
        const L x = over(fifth(b->work.slopes, n), scale);
        const L y = over(third(b->work.slopes, n), scale);
        five = fused(x, x, five);
        three = fused(y, y, three);
    }
    for (int i = 0; i < VECTORS; ++i) {
        V strange = every(0.0);
        for (int n = 0; n < SIZE; ++n)
            strange += b->next[n].at[i] - b->next[n].at[i];
        const V e = h.at[i] * five.at[i];
        const V both = MOVING * (five.at[i] + 0.01 * three.at[i]);
        const V error = largest(choose(both == 0, every(0.0), e * e / both), every(1e-30));
        const I good = error < 1;
        const V most = choose(good & (b->work.careful.at[i] == 0), every(10.0), every(1.0));
        const V factor = 0.9 * power((logarithm((I)error) - 1023.0) * (-1.0 / 16));
        b->taken.at[i] = choose(good | (strange != 0), h.at[i], every(0.0));
        b->step.at[i] = h.at[i] * largest(least(factor, most), every(0.2));
        b->work.careful.at[i] = choose(good, every(0.0), every(1.0));
    }
    b->work.length = h;
}

/* The terms of what is between the ends: the change, what the slopes at the ends add, and more. */
static void between(Block *b)
{
    L at[SIZE], (*const k)[SIZE] = b->work.slopes;
    const L h = b->work.length;
    more_stages(b->work.old, b->held, h, k, at);
    for (int n = 0; n < SIZE; ++n) {
        L *f = b->work.terms[n];
        f[0] = sub(b->next[n], b->work.old[n]);
        f[1] = sub(mul(h, k[0][n]), f[0]);
        f[2] = rest(h, add(k[0][n], k[STAGES][n]), add(f[0], f[0]));
        for (int i = 0; i < DENSE; ++i) {
            L sum = all(0.0);
            for (int j = 0; j < STAGES + 1 + MORE; ++j)
                sum = fused(all(dense[i][j]), k[j][n], sum);
            f[3 + i] = mul(h, sum);
        }
    }
}

static L inside(const Block *b, int n, L part)
{
    const L left = sub(all(1.0), part);
    L y = all(0.0);
    for (int i = 2 + DENSE; i >= 0; --i)
        y = mul(add(y, b->work.terms[n][i]), i % 2 ? left : part);
    return add(b->work.old[n], y);
}

static void settle(Block *b, const M *accepted)
{
    L(*k)[SIZE] = b->work.slopes;
    for (int n = 0; n < SIZE; ++n)
        for (int i = 0; i < VECTORS; ++i)
            k[0][n].at[i] = choose(accepted->at[i], k[STAGES][n].at[i], k[0][n].at[i]);
}
