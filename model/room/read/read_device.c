/* read_device.c - see read_device.h. */
#include "model/room/read/read_device.h"

#include "model/room/read/element_form.h"

/* Default ratio of the spacing of slats to their width: usual blinds have slats of 25
 * mm at 20 mm. */
#define USUAL_SPACING 0.8

static bool read_blind(struct pp_reader *r, struct pp_window_device *device,
                       const struct pp_xml_element *e)
{
    struct pp_blind_form form = {0};
    if (!pp_reader_fill_form(r, &form, &pp_rule_blind, e))
        return false;
    if (fabs(form.curvature_m) > 0.5 * form.width_m) {
        pp_mistakes_add(r->mistakes, e->line,
                        "blind: curvature is %g m, but slats of width %g m can be "
                        "curved by at most half of that",
                        form.curvature_m, form.width_m);
        return false;
    }
    if (form.cut_off == 1 && !isnan(form.angle_rad)) {
        pp_mistakes_add(
            r->mistakes, e->line,
            "blind: there are an angle and cut-off=\"yes\", which turns the "
            "slats; expected one of them");
        return false;
    }
    device->follows_sun = form.cut_off == 1;
    device->slats = (struct pp_slats){
        .width = form.width_m,
        .spacing =
            isnan(form.spacing_m) ? USUAL_SPACING * form.width_m : form.spacing_m,
        .tilt_rad = isnan(form.angle_rad) ? 0.0 : form.angle_rad,
        .rise = form.curvature_m,
        .upper = form.upper.reflectance,
        .lower = isnan(form.lower.reflectance) ? form.upper.reflectance
                                               : form.lower.reflectance};
    device->vertical = form.direction == 1;
    device->position = (enum pp_device_position)form.position;
    return true;
}

static bool read_screen(struct pp_reader *r, struct pp_window_device *device,
                        const struct pp_xml_element *e)
{
    struct pp_screen_form form = {0};
    if (!pp_reader_fill_form(r, &form, &pp_rule_screen, e))
        return false;
    device->openness = form.openness;
    device->reflectance = form.finish.reflectance;
    return true;
}

static bool read_curtain(struct pp_reader *r, struct pp_window_device *device,
                         const struct pp_xml_element *e)
{
    struct pp_curtain_form form = {0};
    if (!pp_reader_fill_form(r, &form, &pp_rule_curtain, e))
        return false;
    device->transmittance = form.transmittance;
    return true;
}

bool pp_read_device(struct pp_reader *r, struct pp_window_device *device,
                    const struct pp_xml_element *opening)
{
    static const struct {
        enum pp_device_kind kind;
        const struct pp_element_rule *rule;
        bool (*read)(struct pp_reader *, struct pp_window_device *,
                     const struct pp_xml_element *);
    } kinds[] = {{PP_DEVICE_BLIND, &pp_rule_blind, read_blind},
                 {PP_DEVICE_SCREEN, &pp_rule_screen, read_screen},
                 {PP_DEVICE_CURTAIN, &pp_rule_curtain, read_curtain}};
    bool good = true;
    *device = (struct pp_window_device){.kind = PP_DEVICE_NONE};
    for (const struct pp_xml_element *c = opening->child;
         c && !pp_reader_should_stop(r); c = c->next)
        for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
            if (!pp_element_form_matches(c, kinds[i].rule))
                continue;
            if (device->kind != PP_DEVICE_NONE) {
                pp_mistakes_add(r->mistakes, c->line,
                                "%s: the %s has a %s already; expected one blind, "
                                "screen or curtain",
                                c->name, opening->name,
                                pp_window_device_word(device->kind));
                return false;
            }
            device->kind = kinds[i].kind;
            device->line = c->line;
            good = kinds[i].read(r, device, c) && good;
        }
    return good;
}
