/* Numbers with a photometric unit, as scene files have them: "3000 cd/m2", "800 lm", "12klm", "500".
 *
 * Units are lm, cd, lx and cd/m2 (also written cd/m^2 or cd/m² in UTF-8), each with the prefix m, k or M or none; blanks may stand between
 * number and unit.
 */
#ifndef RL_SCENE_UNITS_H
#define RL_SCENE_UNITS_H

#include <stdbool.h>

enum rl_unit {
    RL_UNIT_LUMEN,
    RL_UNIT_CANDELA,
    RL_UNIT_LUX,
    RL_UNIT_LUMINANCE,
    RL_UNIT_NONE,
    RL_UNIT_UNKNOWN
};

/* False: there is no finite number. *value is in the unit without prefix. */
bool rl_measure_scan(double *value, enum rl_unit *unit, const char *text);

/* "lm", "cd", "lx", "cd/m2". */
const char *rl_unit_name(enum rl_unit unit);

#endif
