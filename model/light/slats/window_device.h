/* window_device.h - a blind, screen or curtain that covers an opening. */
#ifndef PP_MODEL_LIGHT_SLATS_WINDOW_DEVICE_H
#define PP_MODEL_LIGHT_SLATS_WINDOW_DEVICE_H

#include <stdbool.h>
#include <stddef.h>

#include "model/light/slats/slats.h"

enum pp_device_kind {
    PP_DEVICE_NONE,
    PP_DEVICE_BLIND,
    PP_DEVICE_SCREEN,
    PP_DEVICE_CURTAIN
};

/* Position of a blind relative to the glass. */
enum pp_device_position { PP_DEVICE_INSIDE, PP_DEVICE_BETWEEN, PP_DEVICE_OUTSIDE };

struct pp_window_device {
    enum pp_device_kind kind;
    struct pp_slats slats; /* blind */
    bool vertical;         /* blind: its slats are vertical */
    bool follows_sun;      /* blind: its slats turn until they cut off the sun */
    enum pp_device_position position;
    double openness;      /* screen: share of its area that is open */
    double reflectance;   /* screen: reflectance of the fabric */
    double transmittance; /* curtain: for diffuse light; Lambertian */
    int line;
};

/* "blind", "screen" or "curtain". */
const char *pp_window_device_word(enum pp_device_kind kind);

/* Appends a description of the device: "; blind inside, slats 25 mm at 20 mm, tilt -45
 * deg, reflectance 0.6". Appends nothing if there is no device. degrees: " deg" or
 * "\u00b0". */
void pp_window_device_say(const struct pp_window_device *device, char *text,
                          size_t room, const char *degrees);

#endif
