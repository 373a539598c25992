/* lighting_control.h - power of electric lamps with a photoelectric control.
 *
 * E is the daylight illuminance at the control point, and t the target illuminance. At
 * full power, the lamps give t at that point.
 *
 *   on-off    switches on if E < t, and off if E >= t + differential
 *   stepped   n groups of lamps; group k is on if E < k t/n
 *   dimmed    light x = max(l, 1 - E/t), power p = r + (1 - r) (x - l)/(1 - l), for
 *             residual light l and residual power r; if the control can switch off,
 *             p = 0 if 1 - E/t <= l
 */
#ifndef PP_STUDIES_LIGHTING_LIGHTING_CONTROL_H
#define PP_STUDIES_LIGHTING_LIGHTING_CONTROL_H

#include <stddef.h>

#include "model/results/sheets/lighting_sheet.h"

/* Fraction of the installed power, 0 to 1, for any control except the manual one. *on:
 * state of an on-off control, updated; other controls have no memory. */
double pp_lighting_control_power(const struct pp_lighting_control *control, double E,
                                 bool *on);

/* Makes ideal controls for the comparison of rooms: on-off, dimmed and manual, with
 * this target (lx), controlled at the darkest point, with open blinds. */
enum { PP_LIGHTING_CONTROL_IDEAL = 3 };
void pp_lighting_control_ideal(
    struct pp_lighting_control list[PP_LIGHTING_CONTROL_IDEAL], double target_lx);

/* Name of a kind of control: "on-off", "stepped", "dimmed" or "manual". */
const char *pp_lighting_control_name(enum pp_lighting_kind kind);

/* Describes a control with all settings, such as "dimmed: to 500 lx at point 2, ...".
 * Returns `text`. */
const char *pp_lighting_control_words(char *text, size_t room,
                                      const struct pp_lighting_control *control);

#endif
