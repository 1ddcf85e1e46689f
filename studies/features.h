/* Features: whatever a scene can ask for, one by one, taken from the tables of effects and of highlight methods; and views of a scene that
 * have some of them and not others. What is added to a table appears here by itself.
 *
 *     struct rl_feature f[RL_FEATURES_MAX];
 *     size_t n = rl_features_list(f);
 *     struct rl_view full, less;
 *     rl_view_make(&full, &scene, &RL_SETTINGS_DEFAULT, &error);
 *     rl_view_copy(&less, &full, &error);
 *     rl_view_remove(&less, &f[0]);
 *     rl_plan_make(&plan, &less.scene, &less.settings, &error);
 *     rl_view_clear(&less); rl_view_clear(&full);
 */
#ifndef RL_STUDIES_FEATURES_H
#define RL_STUDIES_FEATURES_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "effects/effect.h"
#include "methods/method.h"
#include "scene/scene.h"
#include "scene/settings.h"

enum rl_feature_kind { RL_FEATURE_EFFECT, RL_FEATURE_HIGHLIGHT, RL_FEATURE_SWITCH };

/* Switches are settings: attenuation and the bounding spheres, of highlights; and culling. */
enum rl_feature_switch { RL_SWITCH_ATTENUATION, RL_SWITCH_SPHERE, RL_SWITCH_CULLING, RL_SWITCHES };

struct rl_feature {
    const char *name; /* the effect's, the method's; "attenuation", "sphere", "culling" */
    const struct rl_effect *effect;
    const struct rl_method *method;
    enum rl_feature_kind kind;
    enum rl_feature_switch which;
};

enum { RL_FEATURES_MAX = RL_MATERIAL_EFFECTS_MAX + 16 };

/* Every effect, every method that runs on the GPU, every switch, in this order; gives their number. */
size_t rl_features_list(struct rl_feature feature[RL_FEATURES_MAX]);

/* "effect", "highlight", "switch" */
const char *rl_feature_kind_name(enum rl_feature_kind kind);

/* Whether it acts on highlights of shaped lights, and does nothing without: factors, and the switches of highlights. */
bool rl_feature_needs_highlight(const struct rl_feature *feature);

/* Whether some material that an object wears asks for it; always true of switches. */
bool rl_feature_named(const struct rl_scene *scene, const struct rl_feature *feature);

/* Makes the material ask for the effect, with values that do something: coefficients of a half, everything else in the middle of its range. */
void rl_feature_give(struct rl_material *material, const struct rl_effect *effect);

/* A scene with materials of its own, and settings. All else is the other scene's, which must outlive it. */
struct rl_view {
    struct rl_scene scene;
    struct rl_settings settings;
};

/* As the scene is, with all switches on (spheres with its own margin, or 0.5). Clear it, also after an error. */
int rl_view_make(struct rl_view *view, const struct rl_scene *scene, const struct rl_settings *settings,
                 struct rl_error *error);
int rl_view_copy(struct rl_view *view, const struct rl_view *other, struct rl_error *error);
void rl_view_clear(struct rl_view *view);

/* Takes a feature from every material; or gives it to those that have it in `from`, with their values. */
void rl_view_remove(struct rl_view *view, const struct rl_feature *feature);
void rl_view_add(struct rl_view *view, const struct rl_view *from, const struct rl_feature *feature);

/* Gives a feature that no material names to one that an object wears: the first where it is in nobody's way, else the first, which
 * loses what is a model of the same thing. */
void rl_view_host(struct rl_view *view, const struct rl_feature *feature);

#endif
