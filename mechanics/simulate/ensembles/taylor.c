/* Taylor's method:  y(t + h) = c_0 + c_1 (h/s) + ... + c_n (h/s)^n,   c_j = y^(j)(t) s^j / j!

   The step is as long as the last two terms stay below the tolerance times the size of each entry
   of the state, the largest of its first three terms (Jorba and Zou, Experimental Mathematics 14
   (2005), section 3). By symmetry both may vanish: a pendulum released where its rod is level has
   every fourth term only. So the two before them count as well, as if terms fell off to the last
   one as a geometric series; those of the upper half where they leave less than a part of that. */
enum { LONGEST = 40 }; /* log2 of how far a step may differ from the one before */
#define FARTHER 0.585  /* log2 of how much farther the last four may reach than the upper half */

static void enter(Block *b) { constants(b->held, b->work.constants); }

static void attempt(Block *b)
{
    const int n = b->order;
    const double share = log2(b->tolerance);
    expand(n, b->y, b->held, b->work.constants, b->step, b->work.s);
    L ratio;
    for (int i = 0; i < VECTORS; ++i) {
        V scale[SIZE], reach = every(LONGEST);
        for (int k = 0; k < SIZE; ++k) {
            const L *c = b->work.s[k];
            scale[k] = largest(size(c[0].at[i]), every(0x1p-600));
            scale[k] = largest(scale[k], largest(size(c[1].at[i]), size(c[2].at[i])));
        }
        for (int j = n / 2; j <= n; ++j) {
            I most = (I){0} + INT64_MIN;
            for (int k = 0; k < SIZE; ++k) {
                const I x = (I)size(b->work.s[k][j].at[i]) - (I)scale[k];
                most = (I)choose(x > most, (V)x, (V)most);
            }
            const double allowed = share / (j < n - 1 ? n : j) + (j < n - 3 ? FARTHER : 0.0);
            reach = least(reach, allowed - logarithm(most) * (1.0 / j));
        }
        reach = largest(reach, every(-LONGEST));
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
