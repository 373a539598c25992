/* lighting_control.c - see lighting_control.h. */
#include "studies/lighting/lighting_control.h"

#include <math.h>
#include <stdio.h>

#include "model/base/text.h"

static double power_stepped(const struct pp_lighting_control *control, double E)
{
    int on = 0;
    for (int k = 1; k <= control->steps; k++)
        on += E < k * control->target_lx / control->steps;
    return (double)on / control->steps;
}

static double power_dimmed(const struct pp_lighting_control *control, double E)
{
    double l = control->residual_light, r = control->residual_power;
    double needed = 1.0 - E / control->target_lx;
    if (needed <= l)
        return control->switches_off ? 0.0 : r;
    return r + (1.0 - r) * (needed - l) / (1.0 - l);
}

double pp_lighting_control_power(const struct pp_lighting_control *control, double E,
                                 bool *on)
{
    switch (control->kind) {
    case PP_LIGHTING_ON_OFF:
        *on = E < control->target_lx + (*on ? control->differential_lx : 0.0);
        return *on ? 1.0 : 0.0;
    case PP_LIGHTING_STEPPED:
        return power_stepped(control, E);
    case PP_LIGHTING_DIMMED:
        return power_dimmed(control, E);
    case PP_LIGHTING_MANUAL:
        break;
    }
    return NAN;
}

void pp_lighting_control_ideal(
    struct pp_lighting_control list[PP_LIGHTING_CONTROL_IDEAL], double target_lx)
{
    static const enum pp_lighting_kind kinds[] = {
        PP_LIGHTING_ON_OFF, PP_LIGHTING_DIMMED, PP_LIGHTING_MANUAL};
    for (int k = 0; k < PP_LIGHTING_CONTROL_IDEAL; k++)
        list[k] = (struct pp_lighting_control){.kind = kinds[k],
                                               .target_lx = target_lx,
                                               .steps = 1,
                                               .power_w = NAN,
                                               .power_w_m2 = NAN};
}

const char *pp_lighting_control_name(enum pp_lighting_kind kind)
{
    static const char *const names[] = {"on-off", "stepped", "dimmed", "manual"};
    return names[kind];
}

const char *pp_lighting_control_words(char *text, size_t room,
                                      const struct pp_lighting_control *control)
{
    char at[48] = "the darkest point";
    double t = control->target_lx;
    if (control->point > 0)
        snprintf(at, sizeof at, "point %d", control->point);
    switch (control->kind) {
    case PP_LIGHTING_ON_OFF:
        snprintf(text, room, "on-off: on below %g lx at %s, off at %g lx", t, at,
                 t + control->differential_lx);
        break;
    case PP_LIGHTING_STEPPED:
        snprintf(
            text, room, "stepped: %d step%s, all on below %g lx at %s, off at %g lx",
            control->steps, control->steps == 1 ? "" : "s", t / control->steps, at, t);
        break;
    case PP_LIGHTING_DIMMED:
        snprintf(text, room,
                 "dimmed: to %g lx at %s, down to %g %% of the light at %g %% of the "
                 "power%s",
                 t, at, 100.0 * control->residual_light,
                 100.0 * control->residual_power,
                 control->switches_off ? ", off if less is needed" : "");
        break;
    case PP_LIGHTING_MANUAL:
        snprintf(text, room,
                 "manual: on at arrival by Hunt's probability for the light at %s, off "
                 "at departure; EN 15193 for %g lx",
                 at, t);
        break;
    }
    pp_text_append(text, room, "; %s",
                   control->with_blinds ? "blinds as in LM-83" : "blinds open");
    return text;
}
