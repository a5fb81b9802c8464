/* Taylor's method:  y(t + h) = c_0 + c_1 (h/s) + ... + c_n (h/s)^n,   c_j = y^(j)(t) s^j / j!

   The step is as long as the last two terms stay below the tolerance times the size of each entry
   of the state, the largest of its first three terms (Jorba and Zou, Experimental Mathematics 14
   (2005), section 3). */
enum { LONGEST = 40 }; /* log2 of how far a step may differ from the one before */

static void enter(Block *b) { constants(b->held, b->work.constants); }

static void attempt(Block *b)
{
    const int n = b->order;
    const double share = log2(b->tolerance);
    expand(n, b->y, b->held, b->work.constants, b->step, b->work.s);
    L ratio;
    for (int i = 0; i < VECTORS; ++i) {
        I before = (I){0} + INT64_MIN, last = before;
        for (int k = 0; k < SIZE; ++k) {
            const L *c = b->work.s[k];
            V scale = largest(size(c[0].at[i]), every(0x1p-600));
            scale = largest(scale, largest(size(c[1].at[i]), size(c[2].at[i])));
            I x = (I)size(c[n - 1].at[i]) - (I)scale, y = (I)size(c[n].at[i]) - (I)scale;
            before = (I)choose(x > before, (V)x, (V)before);
            last = (I)choose(y > last, (V)y, (V)last);
        }
        V reach = least((share - logarithm(before)) * (1.0 / (n - 1)),
                        (share - logarithm(last)) * (1.0 / n));
        reach = largest(least(reach, every(LONGEST)), every(-LONGEST));
        V h = b->step.at[i] * power(reach);
        b->taken.at[i] = least(h, b->left.at[i]);
        ratio.at[i] = b->taken.at[i] / b->step.at[i];
        b->step.at[i] = h;
    }
    for (int k = 0; k < SIZE; ++k) {
        const L *c = b->work.s[k];
        L y = c[n];
        for (int j = n - 1; j >= 0; --j)
            y = fused(y, ratio, c[j]);
        b->next[k] = y;
    }
    b->work.ratio = ratio;
}

static void between(Block *b) { (void)b; }

/* Entry k of the state when a part of the step has passed. */
static L inside(const Block *b, int k, L part)
{
    const L *c = b->work.s[k], z = mul(part, b->work.ratio);
    L y = c[b->order];
    for (int j = b->order - 1; j >= 0; --j)
        y = fused(y, z, c[j]);
    return y;
}

static void settle(Block *b, const M *accepted) { (void)b; (void)accepted; }
