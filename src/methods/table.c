/* The table of highlight methods: one row each. */
#include <string.h>

#include "methods/method.h"

extern const struct rl_method rl_method_plain;
extern const struct rl_method rl_method_regular;
extern const struct rl_method rl_method_random;
extern const struct rl_method rl_method_exhaustive;
extern const struct rl_method rl_method_reference;

const struct rl_method *const rl_methods[] = {
    &rl_method_plain, &rl_method_regular, &rl_method_random, &rl_method_exhaustive, &rl_method_reference,
};

const size_t rl_n_methods = sizeof rl_methods / sizeof rl_methods[0];

const struct rl_method *rl_method_find(const char *name)
{
    for (size_t i = 0; name && i < rl_n_methods; i++)
        if (strcmp(rl_methods[i]->name, name) == 0)
            return rl_methods[i];
    return NULL;
}
