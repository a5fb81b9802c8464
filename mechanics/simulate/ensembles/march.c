/* Motions from a queue through the lanes of a block, each with a step of its own.

   A method gives   enter    after a lane has got another motion
                    attempt  a step no longer than what is left: next, taken, and step, the
                             length that it proposes; taken is zero where it was refused
                    between  what `inside` needs
                    inside   an entry of the state, for each lane somewhere within the step
                    settle   last, with the lanes whose step was accepted

   A lane whose motion has ended takes the next one. */
enum { FINISHED, NOT_FINITE, STALLED, TOO_LONG };
enum { IDLE = -1 };

typedef struct {
    int64_t count, samples, entry;
    const double *times, *start, *held;
    double *states;
    int64_t *status, *reached, *steps, *tries;
    double end, first;
    int64_t budget, next;
    int64_t who[LANES], due[LANES], wild[LANES];
} Queue;

static void take(Queue *q, Block *b, int lane)
{
    const int idle = q->next == q->count;
    /* A lane without a motion stands where the first one starts. */
    const int64_t i = idle ? 0 : q->next++;
    q->who[lane] = idle ? IDLE : i;
    for (int k = 0; k < SIZE; ++k)
        LANE(&b->y[k], lane) = q->start[i * SIZE + k];
    for (int k = 0; k < HELD; ++k)
        LANE(&b->held[k], lane) = q->held[i * HELD + k];
    LANE(&b->t, lane) = LANE(&b->low, lane) = 0.0;
    LANE(&b->left, lane) = idle ? 0.0 : q->end;
    LANE(&b->due, lane) = idle ? INFINITY : q->times[1];
    LANE(&b->accepted, lane) = LANE(&b->tried, lane) = 0.0;
    LANE(&b->step, lane) = q->first;
    q->due[lane] = 1;
    q->wild[lane] = 0;
    for (int k = 0; k < SIZE && !idle; ++k)
        q->states[k * q->entry + i * q->samples] = q->start[i * SIZE + k];
}

static int finish(Queue *q, Block *b, int lane, int64_t status)
{
    const int64_t i = q->who[lane];
    q->status[i] = status;
    q->reached[i] = q->due[lane];
    q->steps[i] = (int64_t)LANE(&b->accepted, lane);
    q->tries[i] = (int64_t)LANE(&b->tried, lane);
    for (int k = 0; k < SIZE; ++k)
        for (int64_t d = q->due[lane]; d < q->samples; ++d)
            q->states[k * q->entry + i * q->samples + d] = NAN;
    take(q, b, lane);
    return 1;
}

/* Samples that accepted steps have passed: the next one of every lane, until no lane has one. */
static void sample(Queue *q, const Block *b, const M *accepted)
{
    for (;;) {
        int64_t place[LANES], any = 0;
        L part = b->t;
        for (int lane = 0; lane < LANES; ++lane) {
            const int64_t d = q->due[lane];
            const int due = WHERE(accepted, lane) && d < q->samples
                            && q->times[d] <= LANE(&b->t, lane);
            place[lane] = due ? q->who[lane] * q->samples + d : IDLE;
            if (due)
                LANE(&part, lane) = q->times[d];
            q->due[lane] += due;
            any |= due;
        }
        if (!any)
            return;
        part = over(sub(sub(part, b->begun), b->lost), b->taken);
        for (int k = 0; k < SIZE; ++k) {
            L y = inside(b, k, part);
            for (int i = 0; i < VECTORS; ++i)
                y.at[i] = choose(part.at[i] < 1, y.at[i], b->next[k].at[i]);
            for (int lane = 0; lane < LANES; ++lane)
                if (place[lane] != IDLE)
                    q->states[k * q->entry + place[lane]] = LANE(&y, lane);
        }
    }
}

/* Whether the motion has ended. */
static int look(Queue *q, Block *b, int lane, int finite)
{
    const double t = LANE(&b->t, lane), taken = LANE(&b->taken, lane);
    if (finite && taken > 0) {
        q->wild[lane] = 0;
        if (q->due[lane] == q->samples)
            return finish(q, b, lane, FINISHED);
        LANE(&b->due, lane) = q->times[q->due[lane]];
    }
    if (!finite) {
        q->wild[lane] = 1;
        LANE(&b->step, lane) = taken * 0x1p-8;
    }
    if (LANE(&b->tried, lane) >= (double)q->budget)
        return finish(q, b, lane, TOO_LONG);
    if (t + LANE(&b->step, lane) == t || !(LANE(&b->step, lane) > q->end * 0x1p-80))
        return finish(q, b, lane, q->wild[lane] ? NOT_FINITE : STALLED);
    return 0;
}

/* One step of every lane; whether a lane has got another motion. */
static int advance(Queue *q, Block *b)
{
    M finite, accepted, odd;
    int any = 0;
    attempt(b);
    for (int i = 0; i < VECTORS; ++i) {
        V sum = every(0.0);
        for (int k = 0; k < SIZE; ++k)
            sum += b->next[k].at[i] - b->next[k].at[i];
        const V taken = b->taken.at[i], t = b->t.at[i], left = b->left.at[i];
        const I live = left > 0;
        finite.at[i] = sum == 0;
        accepted.at[i] = finite.at[i] & live & (taken > 0);
        /* t + low + taken, with what rounding loses. */
        const V later = b->low.at[i] + choose(accepted.at[i], taken, every(0.0));
        const V now = choose(accepted.at[i] & (taken >= left), every(q->end), t + later);
        b->begun.at[i] = t;
        b->lost.at[i] = b->low.at[i];
        b->low.at[i] = later - (now - t);
        b->t.at[i] = now;
        b->left.at[i] = choose(live, (q->end - now) - b->low.at[i], every(0.0));
        b->accepted.at[i] += choose(accepted.at[i], every(1.0), every(0.0));
        b->tried.at[i] += choose(live, every(1.0), every(0.0));
        odd.at[i] = live & (~finite.at[i] | (now >= b->due.at[i]) | (now + b->step.at[i] == now)
                            | (b->tried.at[i] >= (double)q->budget));
        any |= some(odd.at[i]);
    }
    int changed = 0;
    if (any) {
        between(b);
        sample(q, b, &accepted);
    }
    for (int k = 0; k < SIZE; ++k)
        for (int i = 0; i < VECTORS; ++i)
            b->y[k].at[i] = choose(accepted.at[i], b->next[k].at[i], b->y[k].at[i]);
    if (any)
        for (int lane = 0; lane < LANES; ++lane)
            if (WHERE(&odd, lane))
                changed |= look(q, b, lane, WHERE(&finite, lane));
    settle(b, &accepted);
    return changed;
}

/* Bytes of memory that `mechanics_march` wants, aligned to its vectors. */
int64_t mechanics_room(void) { return (int64_t)sizeof(Block); }

/* `count` motions from their start to the last of the times.

   start (count, SIZE), held (count, HELD); states (SIZE, count, samples), an entry so many numbers
   behind the one before; one number a motion for status, samples reached, steps, and tries. */
void mechanics_march(int64_t count, int64_t samples, int64_t entry, const double *times,
                     const double *start, const double *held, double *states, int64_t *status,
                     int64_t *reached, int64_t *steps, int64_t *tries, double tolerance,
                     int64_t order, int64_t budget, void *room)
{
    Block *b = room;
    const double end = times[samples - 1];
    Queue q = {.count = count, .samples = samples, .entry = entry, .times = times,
               .start = start, .held = held, .states = states, .status = status, .reached = reached, .steps = steps,
               .tries = tries, .end = end, .first = end / 64, .budget = budget};
    memset(b, 0, sizeof *b);
    b->tolerance = tolerance;
    b->order = (int)order;
    for (int lane = 0; lane < LANES; ++lane)
        take(&q, b, lane);
    int changed = 1;
    for (;;) {
        int busy = 0;
        for (int lane = 0; lane < LANES; ++lane)
            busy |= q.who[lane] != IDLE;
        if (!busy)
            return;
        do {
            if (changed)
                enter(b);
            changed = advance(&q, b);
        } while (!changed);
    }
}
