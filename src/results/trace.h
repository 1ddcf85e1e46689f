/* Which cases a claim comes from: while a judge works, every figure that it reads is noted for the claim it has begun.
 *
 *     rl_trace_begin(&claims, &run, &error);
 *     study->judge(&claims, &run, &error);
 *     rl_trace_end(&claims, &error);
 *     claims.claim[i].identity[k], k < n_cases; and size_px and seeds, from these cases' parameters
 *
 * A judge has to do nothing for it but begin a claim (rl_claims_add) before it reads what the claim rests on. A figure of a scene
 * that is read before the scene's first claim (a noise floor, say) counts for all of that scene's claims. Only what is read through
 * rl_record_metric and rl_record_series counts; to look a case up or to read its parameters does not.
 */
#ifndef RL_RESULTS_TRACE_H
#define RL_RESULTS_TRACE_H

#include "base/error.h"
#include "results/claims.h"
#include "results/record.h"

/* The run must not be changed until the end. One run at a time. */
int rl_trace_begin(struct rl_claims *claims, struct rl_run *run, struct rl_error *error);

/* What was read since the last claim was begun becomes that claim's; rl_claims_add calls it before it adds one. Nothing is done
 * where nothing is traced. */
int rl_trace_take(struct rl_claims *claims, struct rl_error *error);

int rl_trace_end(struct rl_claims *claims, struct rl_error *error);

#endif
