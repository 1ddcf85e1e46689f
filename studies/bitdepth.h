/* Within the study `bitdepth`: plan (bitdepth.c), measuring (bitdepth_measure.c, and what is not a texture on the GPU: the regular
 * pattern and the frame buffer, bitdepth_models.c) and claims (bitdepth_claims.c). */
#ifndef RL_STUDIES_BITDEPTH_H
#define RL_STUDIES_BITDEPTH_H

#include "studies/seeds.h"
#include "studies/study.h"

/* A group is one R_r and N: series "normals" over normal_bits, "environment" over env_format, "frame" over frame_format and "regular"
 * (13 normals) over normal_bits. The first record of each series has the full precision that the others of the series are held against, picture by
 * picture with the same seed, so that noise cancels. Metrics:
 *
 *     change      RMS difference to full precision in one picture
 *     bias        what of it is the same for every seed, RMS over pixels
 *     difference  the mean difference, with its sign
 *     noise_4     noise of 4 random normals at full precision, and bias_of_noise, change_of_noise: divided by it
 *     clipped     share of values above 1, which an unsigned frame buffer cannot hold: left out of its figures
 *
 * Series "time", a group of its own: frame_ms by normal_bits with its series, paired by round. */
int rl_bitdepth_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                        const struct rl_scene *scene, struct rl_error *error);

int rl_bitdepth_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

/* One picture by the method `regular` whose pattern is rounded as a normal map's texels are. RL_ERR_INPUT: normal_bits is none that the
 * study has. */
int rl_bitdepth_pattern_picture(struct rl_image *image, struct rl_bench *bench, const struct rl_scene *scene,
                                const char *parameters, struct rl_error *error);

/* The pictures of `exact` as a frame buffer of `format` would hold them: the surface pass writes `surface`, rounded to nearest, and
 * the highlight pass adds to it, rounded again. `clamped` gets the exact ones, cut off at 1 where the format is: what is above is not a matter of
 * bits. *share: of such values in the foreground. Both must be empty and are cleared by the caller in any case. */
int rl_bitdepth_frames(struct rl_seeds *rounded, struct rl_seeds *clamped, double *share,
                       const struct rl_seeds *exact, const struct rl_image *surface,
                       enum rl_texel_format format, struct rl_error *error);

#endif
