/* devices.c - see devices.h. */
#include "model/room/build/devices.h"

#include <string.h>

#include "model/light/slats/blind.h"
#include "model/room/build/opening_outline.h"

/* Windows within 15 degrees of the vertical count as vertical, as for dirt. */
#define VERTICAL_FROM (75.0 * PP_RAD)

static bool same_slats(const struct pp_slats *a, const struct pp_slats *b)
{
    return a->width == b->width && a->spacing == b->spacing
           && a->tilt_rad == b->tilt_rad && a->rise == b->rise && a->upper == b->upper
           && a->lower == b->lower;
}

static bool is_upright(const struct pp_opening *opening)
{
    return opening->slope_rad >= VERTICAL_FROM
           && opening->slope_rad <= PP_PI - VERTICAL_FROM;
}

/* Blind of an earlier opening with the same slats; NULL if there is none. */
static struct pp_blind *shared_blind(const struct pp_world *world,
                                     const struct pp_opening *opening)
{
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *other = &world->openings[i];
        if (other->blind && same_slats(&other->blind->slats, &opening->device.slats)
            && other->device.vertical == opening->device.vertical
            && is_upright(other) == is_upright(opening))
            return other->blind;
    }
    return NULL;
}

static enum pp_status put_blind(struct pp_resolver *r, struct pp_opening *opening,
                                const struct pp_opening_part *part,
                                struct pp_error *err)
{
    const struct pp_window_device *device = &opening->device;
    struct pp_error fault = {0};
    if (device->position == PP_DEVICE_BETWEEN && opening->glass.panes < 2) {
        pp_mistakes_add(r->mistakes, device->line,
                        "blind: is between the panes, but the %s has %s; expected "
                        "glazing of two or more panes",
                        pp_opening_outline_word(part),
                        opening->glass.panes == 1 ? "one pane" : "no glass");
        return PP_OK;
    }
    opening->blind = shared_blind(r->world, opening);
    if (opening->blind) {
        opening->blind->holders++;
        return PP_OK;
    }
    enum pp_status status =
        pp_blind_create(&opening->blind, &device->slats,
                        !device->vertical && is_upright(opening), &fault);
    if (status == PP_BAD_INPUT) {
        pp_mistakes_add(r->mistakes, device->line, "blind: %s", fault.message);
        return PP_OK;
    }
    return status == PP_OK ? PP_OK : pp_fail(err, status, "%s", fault.message);
}

enum pp_status pp_devices_put(struct pp_resolver *r, struct pp_opening *opening,
                              const struct pp_opening_part *part, struct pp_error *err)
{
    opening->device = part->device;
    if (part->device.kind == PP_DEVICE_BLIND)
        return put_blind(r, opening, part, err);
    if (part->device.kind == PP_DEVICE_CURTAIN)
        opening->glass =
            pp_glass_diffusing(opening->glass.diffuse * part->device.transmittance);
    return PP_OK;
}
