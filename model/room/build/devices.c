/* devices.c - see devices.h. */
#include "model/room/build/devices.h"

#include <string.h>

#include "model/light/slats/blind.h"
#include "model/room/build/opening_outline.h"

/* Windows within 15 degrees of the vertical count as vertical, as in the tables of
 * dirt. */
#define VERTICAL_FROM (75.0 * PP_RAD)

static bool same_slats(const struct pp_slats *a, const struct pp_slats *b)
{
    return a->width == b->width && a->spacing == b->spacing
           && a->tilt_rad == b->tilt_rad && a->rise == b->rise && a->upper == b->upper
           && a->lower == b->lower;
}

bool pp_devices_is_upright(const struct pp_opening *opening)
{
    return opening->slope_rad >= VERTICAL_FROM
           && opening->slope_rad <= PP_PI - VERTICAL_FROM;
}

/* Blind of one of these openings with the same slats and glass; NULL if there is none. */
static struct pp_blind *shared_blind(const struct pp_opening *openings, int count,
                                     const struct pp_opening *opening)
{
    for (int i = 0; i < count; i++) {
        const struct pp_opening *other = &openings[i];
        if (other->blind && same_slats(&other->device.slats, &opening->device.slats)
            && other->device.vertical == opening->device.vertical
            && other->device.position == opening->device.position
            && other->device.follows_sun == opening->device.follows_sun
            && pp_glass_is_same(&other->glass, &opening->glass)
            && pp_devices_is_upright(other) == pp_devices_is_upright(opening))
            return other->blind;
    }
    return NULL;
}

/* Reason why a device cannot be combined with the glass; NULL if it can. */
static const char *wrong_glass(const struct pp_opening *opening,
                               const struct pp_window_device *device)
{
    if (device->kind != PP_DEVICE_BLIND)
        return NULL;
    if (opening->glass.diffusing)
        return "diffusing glass; expected clear glass";
    if (device->position == PP_DEVICE_BETWEEN && opening->glass.panes < 2)
        return opening->glass.panes == 1
                   ? "one pane; a blind between panes needs two or more"
                   : "no glass; a blind between panes needs two or more panes";
    return NULL;
}

enum pp_status pp_devices_hang(struct pp_opening *opening,
                               const struct pp_opening *openings, int count,
                               struct pp_error *err)
{
    opening->blind = shared_blind(openings, count, opening);
    if (opening->blind) {
        opening->blind->holders++;
    } else {
        enum pp_status status =
            pp_blind_create(&opening->blind, &opening->device, &opening->glass,
                            pp_devices_is_upright(opening), err);
        if (status != PP_OK)
            return status;
    }
    opening->scatter = &opening->blind->scatter;
    return PP_OK;
}

static enum pp_status put_blind(struct pp_resolver *r, struct pp_opening *opening,
                                struct pp_error *err)
{
    struct pp_error fault = {0};
    enum pp_status status =
        pp_devices_hang(opening, r->world->openings, r->world->opening_count, &fault);
    if (status == PP_BAD_INPUT)
        pp_mistakes_add(r->mistakes, opening->device.line, "blind: %s", fault.message);
    else if (status != PP_OK)
        return pp_fail(err, status, "%s", fault.message);
    return PP_OK;
}

enum pp_status pp_devices_put(struct pp_resolver *r, struct pp_opening *opening,
                              const struct pp_opening_part *part, struct pp_error *err)
{
    const char *why = wrong_glass(opening, &part->device);
    opening->device = part->device;
    opening->uncovered = opening->glass;
    if (why) {
        pp_mistakes_add(r->mistakes, part->device.line, "%s: the %s has %s",
                        pp_window_device_word(part->device.kind),
                        pp_opening_outline_word(part), why);
        return PP_OK;
    }
    if (part->device.kind == PP_DEVICE_BLIND)
        return put_blind(r, opening, err);
    if (part->device.kind == PP_DEVICE_CURTAIN)
        opening->glass =
            pp_glass_diffusing(opening->glass.diffuse * part->device.transmittance);
    return PP_OK;
}
