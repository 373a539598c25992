/* lighting_control.h - power of electric lamps under a photoelectric control.
 *
 * E is the daylight illuminance at the control point, t the target, and the lamps at full
 * power give t there.
 *
 *   on-off    on if E < t; once on, off only if E >= t + differential
 *   stepped   with n groups of lamps, group k of n is on if E < k t/n
 *   dimmed    light x = max(l, 1 - E/t), power p = r + (1 - r) (x - l)/(1 - l), for
 *             residual light l and residual power r; or p = 0 if 1 - E/t <= l
 */
#ifndef PP_STUDIES_LIGHTING_LIGHTING_CONTROL_H
#define PP_STUDIES_LIGHTING_LIGHTING_CONTROL_H

#include <stddef.h>

#include "model/results/sheets/lighting_sheet.h"

/* Share of the installed power, 0 to 1, of any control but the manual one. *on: state of
 * an on-off control before and after this moment; the other controls have no memory. */
double pp_lighting_control_power(const struct pp_lighting_control *control, double E,
                                 bool *on);

/* Ideal controls at the darkest point with open blinds, to compare rooms: on-off, dimmed
 * and manual, with this target (lx). */
enum { PP_LIGHTING_CONTROL_IDEAL = 3 };
void pp_lighting_control_ideal(
    struct pp_lighting_control list[PP_LIGHTING_CONTROL_IDEAL], double target_lx);

/* "on-off", "stepped", "dimmed" or "manual". */
const char *pp_lighting_control_name(enum pp_lighting_kind kind);

/* A description with all settings, such as "dimmed: to 500 lx at point 2, ...". Returns
 * text. */
const char *pp_lighting_control_words(char *text, size_t room,
                                      const struct pp_lighting_control *control);

#endif
