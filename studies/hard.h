/* Within the study `hard`: plan and tables (hard.c), measuring (hard_measure.c) and claims (hard_claims.c).
 *
 * "series=rows function=F backend=B": every row of tests/hard/F.tsv, as `roughlight hard` judges them. Metrics: rows, failed;
 * worst_ulp, of answers that the arguments' rounding does not move by more than the plain bound; worst_share, of a bound, and of
 * the row that has it error, bound and line. Its remark: which result that is, and why the row is hard.
 * "series=map map=M function=F backend=B": every point of tests/hard/maps/M.tsv, by the same judge. Metrics: worst_ulp and
 * median_ulp, points, beyond (share of points above their bound), beyond_points, worst_share. Series: ulp, of each point, those across
 * first; across and up, what stands at the axes; beyond and conditioned, the points above their bounds, and those above the plain
 * bound by no more than the arguments' rounding.
 * `data` in both is the hash of the file: other rows are other cases.
 */
#ifndef RL_STUDIES_HARD_H
#define RL_STUDIES_HARD_H

#include "probe/map.h"
#include "studies/study.h"

/* "cpu", "gpu" */
const char *rl_hard_backend(enum rl_catalogue_backend backend);

int rl_hard_measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                    struct rl_error *error);

int rl_hard_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
