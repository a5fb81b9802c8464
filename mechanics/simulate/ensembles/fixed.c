/* Bytes of memory that `mechanics_march` wants, aligned to its vectors. */
typedef struct {
    L y[SIZE], at[SIZE], held[HELD + 1], slopes[STAGES][SIZE];
} Block;

int64_t mechanics_room(void) { return (int64_t)sizeof(Block); }

/* `count` motions over the same times with the same steps: steps[i] of lengths[i] in span i.

   start (count, SIZE), held (count, HELD); states (SIZE, count, samples), an entry so many numbers
   behind the one before. Samples that are not finite are not reached. */
void mechanics_march(int64_t count, int64_t samples, int64_t entry, const int64_t *steps,
                     const double *lengths, const double *start, const double *held,
                     double *states, int64_t *reached, void *room)
{
    Block *b = room;
    for (int64_t from = 0; from < count; from += LANES) {
        const int lanes = count - from < LANES ? (int)(count - from) : LANES;
        int64_t end[LANES];
        for (int lane = 0; lane < LANES; ++lane) {
            /* Lanes without a motion repeat the first one. */
            const int64_t i = from + (lane < lanes ? lane : 0);
            for (int n = 0; n < SIZE; ++n)
                LANE(&b->y[n], lane) = start[i * SIZE + n];
            for (int n = 0; n < HELD; ++n)
                LANE(&b->held[n], lane) = held[i * HELD + n];
            for (int n = 0; n < SIZE && lane < lanes; ++n)
                states[n * entry + i * samples] = start[i * SIZE + n];
            end[lane] = samples;
        }
        for (int64_t span = 0; span + 1 < samples; ++span) {
            const L h = all(lengths[span]);
            for (int64_t i = 0; i < steps[span]; ++i) {
                rate(b->y, b->held, b->slopes[0]);
                stages(b->y, b->held, h, b->slopes, b->at);
                for (int n = 0; n < SIZE; ++n)
                    b->y[n] = fused(h, slope(b->slopes, n), b->y[n]);
            }
            for (int lane = 0; lane < lanes; ++lane) {
                double *out = states + (from + lane) * samples + span + 1;
                int finite = end[lane] == samples;
                for (int n = 0; n < SIZE; ++n)
                    finite &= isfinite(LANE(&b->y[n], lane)) != 0;
                for (int n = 0; n < SIZE; ++n)
                    out[n * entry] = finite ? LANE(&b->y[n], lane) : NAN;
                if (!finite && end[lane] == samples)
                    end[lane] = span + 1;
            }
        }
        for (int lane = 0; lane < lanes; ++lane)
            reached[from + lane] = end[lane];
    }
}
