/* LANES motions on their way, each at its own time. */
typedef struct {
    L y[SIZE], next[SIZE];            /* states at the time, and one step later */
    L held[HELD + 1];                 /* inputs and parameters */
    L t, low, left;                   /* the time is t + low; how much is left; zero: no motion */
    L step, taken;                    /* proposed; of the last step, zero where it was refused */
    L due, begun, lost;               /* next sample; t and low when the last step began */
    L accepted, tried;                /* numbers of steps */
    double tolerance;
    int order;
    Work work;
} Block;
