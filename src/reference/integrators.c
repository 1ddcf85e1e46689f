/* The table of integrators: one row each. */
#include "reference/integrators.h"

#include <string.h>

extern const struct rl_integrator rl_integrator_reference;
extern const struct rl_integrator rl_integrator_montecarlo;
extern const struct rl_integrator rl_integrator_cubature;
extern const struct rl_integrator rl_integrator_cubature_uv;
extern const struct rl_integrator rl_integrator_vegas;
extern const struct rl_integrator rl_integrator_exhaustive;

const struct rl_integrator *const rl_integrators[] = {
    &rl_integrator_reference,   &rl_integrator_montecarlo, &rl_integrator_cubature,
    &rl_integrator_cubature_uv, &rl_integrator_vegas,      &rl_integrator_exhaustive,
};

const size_t rl_n_integrators = sizeof rl_integrators / sizeof rl_integrators[0];

const struct rl_integrator *rl_integrator_find(const char *name)
{
    for (size_t i = 0; name && i < rl_n_integrators; i++)
        if (strcmp(rl_integrators[i]->name, name) == 0)
            return rl_integrators[i];
    return NULL;
}
