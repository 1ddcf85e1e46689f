/* One application of the 15-point Gauss-Kronrod rule to vector-valued data, with an error estimate from null rules.
 *
 * A null rule of degree j weighs the same 15 values so that every polynomial of lower degree gives 0: it measures the degree-j part
 * of the integrand. For a smooth integrand those parts fall geometrically, and how fast they fall in the data themselves tells how
 * far the Kronrod rule, exact to degree 22, is off; where they do not fall, nothing is claimed (Berntsen and Espelid, "Error
 * estimation in automatic quadrature routines", ACM TOMS 17, 1991). QUADPACK's |K - G|^1.5 assumes the fall instead of looking
 * for it: over random lights it stated up to 240 times too little.
 */
#ifndef RL_REFERENCE_RULE_H
#define RL_REFERENCE_RULE_H

#include <stdbool.h>

/* Values come in rows of RL_RULE_ROOM so that a row fills whole vector registers; the last place is not used. */
enum { RL_RULE_NODES = 15, RL_RULE_ROOM = 16 };

/* Node i = 0 .. 14 on [-1, 1], ascending, and its weight. */
double rl_rule_node(int i);
double rl_rule_weight(int i);

/* Integral over [-1, 1] of the data f[0..14]. */
double rl_rule_sum(const double f[RL_RULE_ROOM]);

/* The same; *error: what it is off by at most, as far as the data tell. */
double rl_rule_estimate(const double f[RL_RULE_ROOM], double *error);

#endif
