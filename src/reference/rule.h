/* The 7-point Gauss rule and the 15-point Kronrod rule that holds its points, with error estimates from null rules.
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

/* Nodes come in two batches, which fill whole vector registers: the Gauss rule's, i = 1, 3 .. 13, and the rest, i = 0, 2 .. 14. */
enum { RL_RULE_NODES = 15, RL_RULE_GAUSS = 7, RL_RULE_BATCH = 8 };

/* Node i = 0 .. 14 on [-1, 1], ascending, and its weight. */
double rl_rule_node(int i);
double rl_rule_weight(int i);

/* Integral over [-1, 1] of the data at the Gauss rule's nodes: exact to degree 13. *error: what it is off by at most, as far as the data
 * tell. */
double rl_rule_gauss(const double gauss[RL_RULE_GAUSS], double *error);

/* The same from all nodes. */
double rl_rule_kronrod(const double gauss[RL_RULE_GAUSS], const double rest[RL_RULE_BATCH], double *error);

#endif
