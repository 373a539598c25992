/* standard_sky.c - see standard_sky.h. */
#include "studies/year/hand/standard_sky.h"

struct pp_perez_sky pp_standard_sky_of(enum pp_standard_sky kind, struct pp_vec3 sun)
{
    /* Types 12, 13 and 1 of ISO 15469; pp_sky_iso would also find their illuminance. */
    static const struct pp_sky clear = {
        .kind = PP_SKY_ISO, .a = -1.0, .b = -0.32, .c = 10.0, .d = -3.0, .e = 0.45};
    static const struct pp_sky turbid = {
        .kind = PP_SKY_ISO, .a = -1.0, .b = -0.32, .c = 16.0, .d = -3.0, .e = 0.3};
    static const struct pp_sky type_1 = {
        .kind = PP_SKY_ISO, .a = 4.0, .b = -0.7, .c = 0.0, .d = -1.0, .e = 0.0};
    struct pp_perez_sky sky = {.intermediate = true, .sun = sun};
    struct pp_sky overcast = pp_sky_overcast();
    const struct pp_sky *standard = kind == PP_STANDARD_CLEAR    ? &clear
                                    : kind == PP_STANDARD_TURBID ? &turbid
                                    : kind == PP_STANDARD_ISO_1  ? &type_1
                                                                 : &overcast;
    if (kind == PP_STANDARD_INTERMEDIATE)
        pp_perez_sky_set_diffuse(&sky, 1.0);
    else
        sky = pp_perez_sky_of_standard(standard, sun, 0.0, 1.0);
    sky.clearness = 1.0;
    sky.bin = 1;
    return sky;
}

double pp_standard_sky_per_zenith(const struct pp_perez_sky *sky)
{
    return sky->diffuse_lx / pp_perez_sky_luminance(sky, pp_vec(0.0, 0.0, 1.0));
}
