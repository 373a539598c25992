/* window_device.c - see window_device.h. */
#include "model/light/slats/window_device.h"

#include "model/base/text.h"

const char *pp_window_device_word(enum pp_device_kind kind)
{
    static const char *const words[] = {[PP_DEVICE_NONE] = "nothing",
                                        [PP_DEVICE_BLIND] = "blind",
                                        [PP_DEVICE_SCREEN] = "screen",
                                        [PP_DEVICE_CURTAIN] = "curtain"};
    return words[kind];
}

static void say_blind(const struct pp_window_device *device, char *text, size_t room,
                      const char *degrees)
{
    static const char *const places[] = {[PP_DEVICE_INSIDE] = "inside",
                                         [PP_DEVICE_BETWEEN] = "between the panes",
                                         [PP_DEVICE_OUTSIDE] = "outside"};
    const struct pp_slats *slats = &device->slats;
    pp_text_append(text, room, "; %sblind %s, slats %.4g mm at %.4g mm, tilt %.3g%s%s",
                   device->vertical ? "vertical " : "", places[device->position],
                   1000.0 * slats->width, 1000.0 * slats->spacing,
                   slats->tilt_rad / PP_RAD, degrees,
                   device->follows_sun ? " (follows the sun)" : "");
    if (slats->rise != 0.0)
        pp_text_append(text, room, ", curved by %.3g mm", 1000.0 * slats->rise);
    pp_text_append(text, room, ", reflectance %.3g", slats->upper);
    if (slats->lower != slats->upper)
        pp_text_append(text, room, " above, %.3g below", slats->lower);
}

void pp_window_device_say(const struct pp_window_device *device, char *text,
                          size_t room, const char *degrees)
{
    if (device->kind == PP_DEVICE_BLIND)
        say_blind(device, text, room, degrees);
    else if (device->kind == PP_DEVICE_SCREEN)
        pp_text_append(text, room, "; screen, openness %.3g, reflectance %.3g",
                       device->openness, device->reflectance);
    else if (device->kind == PP_DEVICE_CURTAIN)
        pp_text_append(text, room, "; curtain, transmittance %.3g",
                       device->transmittance);
}
