/*
 * MuJoCo's mj_forward on the cart with n links, state by state. It also finds contacts, sensors and
 * more, so it does more than the others. Joint angles are relative there; the caller converts.
 */
#include <mujoco/mujoco.h>
#include <string.h>

struct chain {
    mjModel *model;
    mjData *data;
};

static struct chain chain;

/* Returns 0 and leaves the reason in `why` when the file is refused. */
int chain_load(const char *file, char *why, int size)
{
    chain.model = mj_loadXML(file, 0, why, size);
    chain.data = chain.model ? mj_makeData(chain.model) : 0;
    return chain.data != 0;
}

void loop(long count, const double *q, const double *u, const double *forces, double *accelerations)
{
    const int n = chain.model->nv;
    const size_t bytes = n * sizeof(double);
    for (long i = 0; i < count; ++i) {
        memcpy(chain.data->qpos, q + i * n, bytes);
        memcpy(chain.data->qvel, u + i * n, bytes);
        memcpy(chain.data->qfrc_applied, forces + i * n, bytes);
        mj_forward(chain.model, chain.data);
        memcpy(accelerations + i * n, chain.data->qacc, bytes);
    }
}
